#include <patchgrip/friction/batch.h>

#include <algorithm>
#include <limits>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/moebius_kernel.h>

// GCC builds a function once per instruction set and picks one at load time.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PATCHGRIP_VECTOR_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define PATCHGRIP_VECTOR_CLONES
#endif

namespace patchgrip::friction {
namespace {

using kernels::Pair;

template <int Lane, std::size_t First, std::size_t Count, std::size_t N>
[[gnu::always_inline]] inline double lane_polynomial(const std::array<Pair, N>& c, const double* powers) noexcept {
  if constexpr (Count == 1) {
    return c[First][Lane];
  } else {
    constexpr std::size_t log2 = Count > 16 ? 4 : Count > 8 ? 3 : Count > 4 ? 2 : Count > 2 ? 1 : 0;
    constexpr std::size_t low = std::size_t{1} << log2;
    return lane_polynomial<Lane, First, low>(c, powers) +
           powers[log2] * lane_polynomial<Lane, First + low, Count - low>(c, powers);
  }
}

// One pole without branches; x, y about the centre, sense = +-1.
template <class Coefficients>
[[gnu::always_inline]] inline Wrench wrench_by_selection(double x, double y, double radius, double sense) noexcept {
  constexpr const auto& c = Coefficients::gradient;
  constexpr std::size_t n = std::tuple_size_v<std::remove_cvref_t<decltype(c)>>;
  const double V2 = x * x + y * y;
  const double W2 = radius * radius;
  const bool inside = V2 <= W2;
  const double V = std::sqrt(V2);
  const double R = std::sqrt(inside ? 0.0 : V2 - W2);
  const double k = 1 / (inside ? radius : V);
  const double p = (kernels::moebius_plus * R - V) / (kernels::moebius_minus * R + V);
  const double p2 = p * p;
  const double p4 = p2 * p2;
  const double p8 = p4 * p4;
  const double powers[] = {p, p2, p4, p8, p8 * p8};
  const Pair within = Coefficients::inside(inside ? V2 * k * k : 0.0);
  const double force = k * sense * (inside ? within[0] : lane_polynomial<0, 0, n>(c, powers));
  const double moment = inside ? within[1] : radius * k * lane_polynomial<1, 0, n>(c, powers);
  return {force * y, -force * x, sense * radius * moment};
}

PATCHGRIP_VECTOR_CLONES void hertz_batch(std::size_t n, const double* __restrict x, const double* __restrict y,
                                         double radius, double sense, double* __restrict fx, double* __restrict fy,
                                         double* __restrict m) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    const Wrench g = wrench_by_selection<kernels::HertzCoefficients>(x[i], y[i], radius, sense);
    fx[i] = g.fx;
    fy[i] = g.fy;
    m[i] = g.m;
  }
}

PATCHGRIP_VECTOR_CLONES void flat_punch_batch(std::size_t n, const double* __restrict x, const double* __restrict y,
                                              double radius, double sense, double* __restrict fx, double* __restrict fy,
                                              double* __restrict m) noexcept {
  for (std::size_t i = 0; i < n; ++i) {
    const Wrench g = wrench_by_selection<kernels::FlatPunchCoefficients>(x[i], y[i], radius, sense);
    fx[i] = g.fx;
    fy[i] = g.fy;
    m[i] = g.m;
  }
}

PATCHGRIP_VECTOR_CLONES double largest_size(std::size_t n, const double* __restrict x,
                                            const double* __restrict y) noexcept {
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double size = std::max(std::fabs(x[i]), std::fabs(y[i]));
    largest = size > largest ? size : largest;
  }
  return largest;
}

template <class Disc, class Kernel>
void run(const Disc& disc, double spin, const PoleBatch& batch, const Kernel& kernel) {
  batch.check(spin);
  // Squares stay finite and normal below this; chunks keep both passes in the cache.
  constexpr double limit = 0x1p450;
  constexpr std::size_t chunk = 1024;
  const double a = disc.radius();
  const bool scalable = a > 1 / limit && a < limit;
  const std::size_t n = batch.pole_x.size();
  for (std::size_t i = 0; i < n; i += chunk) {
    const std::size_t count = std::min(chunk, n - i);
    const double* x = batch.pole_x.data() + i;
    const double* y = batch.pole_y.data() + i;
    const PoleBatch part{batch.pole_x.subspan(i, count), batch.pole_y.subspan(i, count),
                         batch.force_x.subspan(i, count), batch.force_y.subspan(i, count),
                         batch.moment.subspan(i, count)};
    if (scalable && largest_size(count, x, y) < limit) {
      kernel(count, x, y, a, std::copysign(1.0, spin), part.force_x.data(), part.force_y.data(), part.moment.data());
    } else {
      gradient<Disc>(disc, spin, part);
    }
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

void gradient(const HertzDisc& patch, double spin, const PoleBatch& batch) { run(patch, spin, batch, hertz_batch); }
void gradient(const FlatPunchDisc& patch, double spin, const PoleBatch& batch) {
  run(patch, spin, batch, flat_punch_batch);
}

}  // namespace patchgrip::friction
