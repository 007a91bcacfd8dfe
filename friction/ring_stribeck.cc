// Stribeck's excess of a ring.
//
// With V = |(vx, vy)|, W = a |w| and s = sin(theta / 2), theta from the point next to the pole, its points slide at
// rho^2 = (V - W)^2 + 4 V W s^2, and
//
//     f = (1 / pi) int_0^pi exp(-rho^2) [(V - W) + 2 W s^2] / rho dtheta
//     m = (a / pi) int_0^pi exp(-rho^2) [(W - V) + 2 V s^2] / rho dtheta
//
// On the half next to the pole 2 sqrt(V W) s = |V - W| sinh t, dtheta / rho = dt / (sqrt(V W) cos(theta / 2)): smooth
// in t, wherever the pole is. V - W is taken from V^2 - W^2 as rim_excess() has it (round_patch.h), and all terms but
// that are positive: each rounding counts as one of an integrand, in units of 2^-53 of its terms, and none is enlarged.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <patchgrip/friction/kernels/excess_parts.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/stribeck_excess.h>

namespace patchgrip::friction {
namespace {

using kernels::ExcessParts;
using std::numbers::pi;

constexpr double unit = 0x1p-53;

class SlidingRing {
 public:
  // V and W not 0.
  SlidingRing(double V, double W, double difference) noexcept
      : V_(V),
        W_(W),
        difference_(difference),
        root_(std::sqrt(V) * std::sqrt(W)),
        nearest_(std::max(std::fabs(difference), next * (V + W))),
        ratio_(nearest_ / (2 * root_)),
        whole_(std::asinh(std::sqrt(0.5) / ratio_)),
        end_(ratio_ * std::sinh(whole_)) {}

  kernels::BoundedIntegrals<5> sum() const noexcept {
    // Cuts where exp(-rho^2) falls: what lies beyond the last, half of the ring at most, is an error.
    constexpr double falls = 1;
    const double gone = std::sqrt(-std::log(kernels::negligible));
    const auto reach = [&](double rho) { return rho > nearest_ ? std::min(std::acosh(rho / nearest_), whole_) : 0; };
    const std::array<double, 3> cuts{0, reach(falls), reach(gone)};
    kernels::BoundedIntegrals<5> sum = kernels::integrate<5>(
        [&](double theta, double) {
          theta += 2 * std::asin(end_);
          return parts(std::sin(theta / 2), 1 / speed(std::sin(theta / 2)));
        },
        2 * std::asin(end_), pi);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      const double lo = cuts[i], rest = whole_ - cuts[i + 1];
      kernels::add(sum, kernels::integrate<5>(
                            [&](double from, double to) {
                              const double s = sine(lo + from, rest + to);
                              return parts(s, 1 / (root_ * std::sqrt((1 - s) * (1 + s))));
                            },
                            lo, cuts[i + 1]));
    }
    if (cuts.back() < whole_) {
      const double slowest = std::max(gone, nearest_), dropped = pi / 2 * std::exp(-slowest * slowest);
      sum.value[3] += dropped;
      sum.value[4] += dropped;
    }
    return sum;
  }

 private:
  // A pole on the ring is as one that is next to it.
  static constexpr double next = 1e-25;

  double speed(double s) const noexcept { return std::hypot(difference_, 2 * root_ * s); }

  // sin(theta / 2) at t = `from`, with `to` left of the half next to the pole.
  double sine(double from, double to) const noexcept {
    if (from < to) return ratio_ * std::sinh(from);
    return end_ * std::exp(-to) * (std::expm1(-2 * from) / std::expm1(-2 * whole_));
  }

  // exp(-rho^2) [...] weight. Roundings: V - W 7, s^2 14, rho^2 18, the brackets 16, a weight 14, the rest 4.
  ExcessParts parts(double s, double weight) const noexcept {
    constexpr double roundings = 34, of_square = 18;
    const double s2 = s * s, rho2 = difference_ * difference_ + 4 * V_ * W_ * s2;
    const double k = std::exp(-rho2) * weight, error = unit * k * (roundings + of_square * rho2);
    const double size = std::fabs(difference_);
    return {k * (difference_ + 2 * W_ * s2), 0, k * (2 * V_ * s2 - difference_), error * (size + 2 * W_ * s2),
            error * (size + 2 * V_ * s2)};
  }

  double V_, W_, difference_;
  double root_;     // of V W
  double nearest_;  // |V - W|
  double ratio_;    // s / sinh t
  double whole_;    // t at theta = pi / 2
  double end_;      // s there
};

}  // namespace

BoundedWrench stribeck_excess(const Ring& ring, const Twist& twist) noexcept {
  constexpr double slow = 1e-10;  // exp(-rho^2) is 1, to rounding
  constexpr double fast = 1e100;  // of the ring a part about 1 / W is slower than v_S
  const Twist u = finite_or_nan(twist);
  if (u.w == 0) return stribeck_excess(PointLoad{}, u);
  const double a = ring.radius(), V = std::hypot(u.vx, u.vy), W = a * std::fabs(u.w), sense = std::copysign(1.0, u.w);
  if (std::isnan(V + W)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {{nan, nan, nan}, nan, nan};
  }
  if (V + W < slow) return ring.bounded_gradient(u);
  if (V + W > fast) return {{}, 1 / fast, a / fast};
  if (V == 0) {
    const double moment = a * std::exp(-W * W);
    return {{0, 0, sense * moment}, 0, unit * moment * (4 + 6 * W * W)};
  }
  if (W == 0) return stribeck_excess(PointLoad{}, {u.vx, u.vy, 0});  // less than the least double
  const SlidingRing sliding(V, W, rim_excess(u.vx, u.vy, u.w, a) / (V + W));
  BoundedWrench g = kernels::collected(sliding.sum(), 1 / pi, a);
  const double force = g.value.fx;
  g.value = {force * (u.vx / V), force * (u.vy / V), sense * g.value.m};
  g.force_error += 4 * unit * std::fabs(force);
  return g;
}

}  // namespace patchgrip::friction
