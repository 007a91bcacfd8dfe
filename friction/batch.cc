#include <patchgrip/friction/batch.h>

#include <algorithm>
#include <cstdint>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/moebius_kernel.h>

namespace patchgrip::friction {
namespace {

// Squares stay finite and normal between 1 / limit and limit.
constexpr double limit = 0x1p900;

// One pole without branches; x, y about the centre, sense = +-1.
template <class Coefficients>
[[gnu::always_inline]] inline Wrench wrench_by_selection(double x, double y, double radius, double sense) noexcept {
  const double V2 = x * x + y * y;
  const double W2 = radius * radius;
  const bool inside = V2 <= W2;
  const double V = std::sqrt(V2);
  const double R = std::sqrt(inside ? 0.0 : V2 - W2);
  // One division serves k = 1 / V (1 / a inside) and the variable p: vector units are slowest at it.
  const double larger = inside ? radius : V;
  const double denominator = inside ? 1.0 : kernels::moebius_minus * R + V;
  const double reciprocal = 1 / (larger * denominator);
  const double k = denominator * reciprocal;
  const double p = (kernels::moebius_plus * R - V) * (larger * reciprocal);
  const double z = inside ? V2 * k * k : 0.0;
  const double force = inside ? Coefficients::force_inside(z) : kernels::polynomial(Coefficients::force, p);
  const double moment =
      inside ? Coefficients::moment_inside(z) : radius * k * kernels::polynomial(Coefficients::moment, p);
  const double per_speed = sense * k * force;
  return {per_speed * y, -per_speed * x, sense * radius * moment};
}

// False where a pole is too far away to be squared.
template <class Coefficients>
[[gnu::always_inline]] inline bool all_poles(std::size_t n, const double* __restrict x, const double* __restrict y,
                                             double radius, double sense, double* __restrict fx, double* __restrict fy,
                                             double* __restrict m) noexcept {
  std::int64_t beyond = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Wrench g = wrench_by_selection<Coefficients>(x[i], y[i], radius, sense);
    fx[i] = g.fx;
    fy[i] = g.fy;
    m[i] = g.m;
    beyond |= x[i] * x[i] + y[i] * y[i] < limit ? 0 : 1;
  }
  return beyond == 0;
}

using Kernel = bool (*)(std::size_t, const double*, const double*, double, double, double*, double*, double*) noexcept;

template <class Coefficients>
bool baseline(std::size_t n, const double* x, const double* y, double radius, double sense, double* fx, double* fy,
              double* m) noexcept {
  return all_poles<Coefficients>(n, x, y, radius, sense, fx, fy, m);
}

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

template <class Coefficients>
[[gnu::target("arch=x86-64-v3")]] bool avx2(std::size_t n, const double* x, const double* y, double radius,
                                            double sense, double* fx, double* fy, double* m) noexcept {
  return all_poles<Coefficients>(n, x, y, radius, sense, fx, fy, m);
}

template <class Coefficients>
[[gnu::target("arch=x86-64-v4,prefer-vector-width=512")]] bool avx512(std::size_t n, const double* x, const double* y,
                                                                      double radius, double sense, double* fx,
                                                                      double* fy, double* m) noexcept {
  return all_poles<Coefficients>(n, x, y, radius, sense, fx, fy, m);
}

template <class Coefficients>
Kernel best_kernel() noexcept {
  if (__builtin_cpu_supports("x86-64-v4")) return avx512<Coefficients>;
  if (__builtin_cpu_supports("x86-64-v3")) return avx2<Coefficients>;
  return baseline<Coefficients>;
}

#else

template <class Coefficients>
Kernel best_kernel() noexcept {
  return baseline<Coefficients>;
}

#endif

template <class Coefficients, class Disc>
void run(const Disc& disc, double spin, const PoleBatch& batch) {
  static const Kernel kernel = best_kernel<Coefficients>();
  batch.check(spin);
  constexpr std::size_t chunk = 1024;  // a pole that cannot be squared sends its own chunk to the scalar code
  const double a = disc.radius();
  const bool scalable = a * a > 1 / limit && a * a < limit;
  const std::size_t n = batch.pole_x.size();
  for (std::size_t i = 0; i < n; i += chunk) {
    const std::size_t count = std::min(chunk, n - i);
    const PoleBatch part{batch.pole_x.subspan(i, count), batch.pole_y.subspan(i, count),
                         batch.force_x.subspan(i, count), batch.force_y.subspan(i, count),
                         batch.moment.subspan(i, count)};
    const bool done = scalable && kernel(count, part.pole_x.data(), part.pole_y.data(), a, std::copysign(1.0, spin),
                                         part.force_x.data(), part.force_y.data(), part.moment.data());
    if (!done) gradient<Disc>(disc, spin, part);
  }
}

}  // namespace

void PoleBatch::check(double spin) const {
  if (!(spin != 0)) contact::refuse("spin", spin, "must not be zero: a translation has no pole in the plane");
  const auto n = static_cast<double>(pole_x.size());
  for (const std::size_t size : {pole_y.size(), force_x.size(), force_y.size(), moment.size()}) {
    if (size != pole_x.size()) contact::refuse("length of pole_x", n, "must be that of the other spans");
  }
}

void gradient(const HertzDisc& patch, double spin, const PoleBatch& batch) {
  run<kernels::HertzCoefficients>(patch, spin, batch);
}

void gradient(const FlatPunchDisc& patch, double spin, const PoleBatch& batch) {
  run<kernels::FlatPunchCoefficients>(patch, spin, batch);
}

}  // namespace patchgrip::friction
