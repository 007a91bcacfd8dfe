#include <patchgrip/friction/kernels/moebius_batch.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <patchgrip/friction/twist.h>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PATCHGRIP_X86_VECTORS
#include <immintrin.h>
#endif

namespace patchgrip::friction::kernels {
namespace {

// Squares stay finite and normal between 1 / limit and limit.
constexpr double limit = 0x1p900;

// One pole, every case computed and one selected. Inside the rim R and p are of no use but finite: a select before the
// root would be sunk behind it by the compiler, and roots of negative numbers are slow.
template <class Coefficients>
[[gnu::always_inline]] inline Wrench selected_wrench(double x, double y, double radius, double sense) noexcept {
  const double V2 = x * x + y * y;
  const double W2 = radius * radius;
  const bool inside = V2 <= W2;
  const double V = std::sqrt(V2);
  const double R = std::sqrt(std::fabs(V2 - W2));
  // One division serves k = 1 / max(V, a) and p: vector units are slowest at it.
  const double larger = inside ? radius : V;
  const double denominator = moebius_minus * R + V;
  const double reciprocal = 1 / (larger * denominator);
  const double k = denominator * reciprocal;
  const double p = (moebius_plus * R - V) * (larger * reciprocal);
  const double z = V2 * k * k;
  const double force = inside ? horner(Coefficients::force_inside, z) : polynomial(Coefficients::force, p);
  const double moment =
      inside ? horner(Coefficients::moment_inside, z) : radius * k * polynomial(Coefficients::moment, p);
  const double per_speed = sense * k * force;
  return {per_speed * y, -per_speed * x, sense * radius * moment};
}

template <class Coefficients>
[[gnu::always_inline]] inline bool loop(std::size_t n, const double* __restrict x, const double* __restrict y,
                                        double radius, double sense, double* __restrict fx, double* __restrict fy,
                                        double* __restrict m) noexcept {
  std::int64_t beyond = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Wrench g = selected_wrench<Coefficients>(x[i], y[i], radius, sense);
    fx[i] = g.fx;
    fy[i] = g.fy;
    m[i] = g.m;
    beyond |= x[i] * x[i] + y[i] * y[i] < limit ? 0 : 1;
  }
  return beyond == 0;
}

template <class Coefficients>
bool baseline(std::size_t n, const double* x, const double* y, double radius, double sense, double* fx, double* fy,
              double* m) noexcept {
  return loop<Coefficients>(n, x, y, radius, sense, fx, fy, m);
}

#ifdef PATCHGRIP_X86_VECTORS

template <class Coefficients>
[[gnu::target("arch=x86-64-v3")]] bool avx2(std::size_t n, const double* x, const double* y, double radius,
                                            double sense, double* fx, double* fy, double* m) noexcept {
  return loop<Coefficients>(n, x, y, radius, sense, fx, fy, m);
}

#define PATCHGRIP_AVX512 [[gnu::target("arch=x86-64-v4")]]

using Eight [[gnu::vector_size(64)]] = double;

template <std::size_t First, std::size_t Count, std::size_t N>
PATCHGRIP_AVX512 [[gnu::always_inline]] inline Eight estrin8(const std::array<double, N>& c,
                                                             const Eight* powers) noexcept {
  if constexpr (Count == 1) {
    return Eight{} + c[First];
  } else {
    constexpr std::size_t log2 = Count > 16 ? 4 : Count > 8 ? 3 : Count > 4 ? 2 : Count > 2 ? 1 : 0;
    constexpr std::size_t low = std::size_t{1} << log2;
    return estrin8<First, low>(c, powers) + powers[log2] * estrin8<First + low, Count - low>(c, powers);
  }
}

template <std::size_t N>
PATCHGRIP_AVX512 [[gnu::always_inline]] inline Eight horner8(const std::array<double, N>& c, Eight t) noexcept {
  Eight sum = Eight{} + c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * t + c[k];
  return sum;
}

// 1 / sqrt(a): the 14-bit estimate and one step of third order, to about one unit of rounding.
PATCHGRIP_AVX512 [[gnu::always_inline]] inline Eight reciprocal_root(Eight a) noexcept {
  const Eight y = _mm512_rsqrt14_pd(a);
  const Eight e = 1 - (a * y) * y;
  return y + y * (e * (0.5 + e * (0.375 + e * 0.3125)));
}

// Poles whose bit in `lanes` is set; false if one of them cannot be squared.
template <class Coefficients>
PATCHGRIP_AVX512 [[gnu::always_inline]] inline bool eight_poles(__mmask8 lanes, const double* x, const double* y,
                                                                double radius, double sense, double* fx, double* fy,
                                                                double* m) noexcept {
  const Eight X = _mm512_maskz_loadu_pd(lanes, x);
  const Eight Y = _mm512_maskz_loadu_pd(lanes, y);
  const Eight V2 = X * X + Y * Y;
  const Eight W2 = Eight{} + radius * radius;
  const __mmask8 inside = _mm512_cmp_pd_mask(V2, W2, _CMP_LE_OQ);
  const Eight k = reciprocal_root(_mm512_max_pd(V2, W2));
  const Eight s = static_cast<Eight>(_mm512_sqrt_pd(_mm512_abs_pd(V2 - W2))) * k;  // R / V
  const Eight p = (s * moebius_plus - 1) / (s * moebius_minus + 1);
  const Eight p2 = p * p;
  const Eight p4 = p2 * p2;
  const Eight p8 = p4 * p4;
  const Eight powers[] = {p, p2, p4, p8, p8 * p8};
  constexpr std::size_t terms = std::tuple_size_v<std::remove_cvref_t<decltype(Coefficients::force)>>;
  const Eight z = V2 * (k * k);
  const Eight force = _mm512_mask_mov_pd(estrin8<0, terms>(Coefficients::force, powers), inside,
                                         horner8(Coefficients::force_inside, z));
  const Eight moment = _mm512_mask_mov_pd(k * radius * estrin8<0, terms>(Coefficients::moment, powers), inside,
                                          horner8(Coefficients::moment_inside, z));
  const Eight per_speed = k * sense * force;
  _mm512_mask_storeu_pd(fx, lanes, per_speed * Y);
  _mm512_mask_storeu_pd(fy, lanes, -per_speed * X);
  _mm512_mask_storeu_pd(m, lanes, moment * (sense * radius));
  return _mm512_cmp_pd_mask(V2, _mm512_set1_pd(limit), _CMP_NLT_UQ) == 0;
}

template <class Coefficients>
PATCHGRIP_AVX512 bool avx512(std::size_t n, const double* x, const double* y, double radius, double sense, double* fx,
                             double* fy, double* m) noexcept {
  bool good = true;
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    good &= eight_poles<Coefficients>(0xff, x + i, y + i, radius, sense, fx + i, fy + i, m + i);
  }
  const auto rest = static_cast<__mmask8>((1U << (n - i)) - 1);
  if (rest != 0) good &= eight_poles<Coefficients>(rest, x + i, y + i, radius, sense, fx + i, fy + i, m + i);
  return good;
}

#endif

}  // namespace

template <class Coefficients>
MoebiusBatch moebius_batch() noexcept {
#ifdef PATCHGRIP_X86_VECTORS
  if (__builtin_cpu_supports("x86-64-v4")) return avx512<Coefficients>;
  if (__builtin_cpu_supports("x86-64-v3")) return avx2<Coefficients>;
#endif
  return baseline<Coefficients>;
}

template MoebiusBatch moebius_batch<HertzCoefficients>() noexcept;
template MoebiusBatch moebius_batch<FlatPunchCoefficients>() noexcept;

}  // namespace patchgrip::friction::kernels
