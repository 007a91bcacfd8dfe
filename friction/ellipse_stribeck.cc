// Stribeck's excess of ellipses and discs: a mean of plane waves over directions (local_stribeck.h).
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/beta.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/kernels/excess_parts.h>
#include <patchgrip/friction/kernels/stribeck_wave.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/seed_hertz_disc.h>
#include <patchgrip/friction/stribeck_excess.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::friction {
namespace {

using kernels::BoundedIntegrals;
using kernels::ExcessParts;
using kernels::integrate;
using std::numbers::pi;

constexpr double unit = 0x1p-53;

// q(s) at 0 <= s <= 1.
class Projection {
 public:
  explicit Projection(double n) : n_(n), scale_(static_cast<double>(1 / boost::math::beta(0.5L, n + 1.0L))) {}

  double operator()(double s, double one_minus_s) const noexcept {
    const double x = one_minus_s * (1 + s);
    if (n_ == 0) return scale_;
    if (n_ == 1) return scale_ * x;
    if (n_ == 0.5) return scale_ * std::sqrt(x);
    if (n_ == -0.5) return scale_ / std::sqrt(x);
    if (is_steep() && s < 0.5) return scale_ * std::exp(n_ * std::log1p(-s * s));
    return scale_ * std::pow(x, n_);
  }

  double scale() const noexcept { return scale_; }

  // Roundings of q in units: of itself, scale, power and product 1 each, and 3 |n| from x; steep, 4 n |ln x| from the
  // logarithm, 3 n < 10.4 n |ln x| where s > 1/2, of which the mean is 10.4 n (psi(n + 3/2) - psi(n + 1)) < 5.2.
  double of_itself() const noexcept { return is_steep() ? 4 : 3 + 3 * std::fabs(n_); }
  double in_the_mean() const noexcept { return is_steep() ? 5.2 : 0; }

 private:
  bool is_steep() const noexcept { return n_ > 2; }

  double n_, scale_;
};

// int q g ds and int q s g ds of the wave g(c + k s) over [-1, 1]; c, k >= 0. The wave is folded at s = 0, and jumps
// where it changes sign, at s = c / k.
BoundedIntegrals<2> across(const Projection& q, double c, double k) noexcept {
  const auto& g = kernels::StribeckWave::shared();
  const auto folded = [&](double s, double one_minus_s, double argument) -> std::array<double, 2> {
    const double forth = g(c + k * s), back = g(argument), pressure = q(s, one_minus_s);
    return {pressure * (forth - back), pressure * s * (forth + back)};
  };
  const double jump = c / k;
  if (!(jump < 1)) {
    return integrate<2>([&](double s, double to_hi) { return folded(s, to_hi, k * s - c); }, 0, 1);
  }
  BoundedIntegrals<2> sum =
      integrate<2>([&](double s, double to_jump) { return folded(s, (1 - jump) + to_jump, -k * to_jump); }, 0, jump);
  const BoundedIntegrals<2> beyond = integrate<2>(
      [&](double from_jump, double to_hi) { return folded(jump + from_jump, to_hi, k * from_jump); }, jump, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    sum.value[i] += beyond.value[i];
    sum.error[i] += beyond.error[i];
  }
  return sum;
}

// No point is slower. The pole is `level` / w semi-axes from the centre.
double slowest(const PowerEllipse& zone, double speed, double w, double level) noexcept {
  return std::max({speed - w * std::max(zone.a(), zone.b()), std::min(zone.a(), zone.b()) * (level - w), 0.0});
}

// See local_stribeck.h; x is the pole's place in semi-axes, u the largest speed.
double rounding_of(const PowerEllipse& zone, const Projection& q, double x, double u) noexcept {
  const bool round = zone.a() == zone.b();
  const double of_place = round ? 5 : 8, of_argument = round ? 3 : 6;  // units, as all that follow
  const double of_directions = round ? 0 : 4 * (1 + 2 / pi * std::fabs(std::log(zone.a() / zone.b())));
  const double of_wave = (4 + q.in_the_mean()) * pi / 2, steepest = std::min(1.336, 3 * pi / 2 * u * u);
  double condition = 1;
  if (zone.n() < 0) {
    const double from_rim = std::max(std::fabs(1 - x), of_place * unit);
    condition = q.scale() * std::min(1 / (zone.n() + 0.5), std::log((1 + x) / from_rim) + 1);
  }
  return unit *
         (of_wave + steepest * (of_argument + of_directions) + (of_place + of_directions) * std::max(condition, 1.0));
}

}  // namespace

PowerEllipse PowerEllipse::of_semi_axes(double a, double b, double n) {
  contact::require_positive("a", a);
  contact::require_positive("b", b);
  contact::require_in("n", n, a == b ? -0.5 : 0, 20);
  return {a, b, n};
}

BoundedWrench stribeck_excess(const PowerEllipse& zone, const Twist& u) noexcept {
  const double a = zone.a(), b = zone.b();
  if (u.w == 0) return stribeck_excess(PointLoad{}, u);
  const bool round = a == b;
  if (round && zone.n() == -0.5) return stribeck_excess(Ring::of_radius(a), u);
  const double w = std::fabs(u.w), length = std::max(a, b), speed = std::hypot(u.vx, u.vy);
  const double level = std::hypot(u.vx / b, u.vy / a), least = slowest(zone, speed, w, level);
  if (std::exp(-least * least) < unit) return {{}, unit, unit * length};
  const Projection q(zone.n());
  const double ex = speed > 0 ? u.vx / speed : 1, ey = speed > 0 ? u.vy / speed : 0;
  // n at the angle phi from u.
  const auto at = [&](double phi) -> ExcessParts {
    const double c = std::max(std::cos(phi), 0.0), s = std::sin(phi);
    const double nx = c * ex - s * ey, ny = c * ey + s * ex, W = round ? a : std::hypot(b * nx, a * ny);
    const auto wave = across(q, speed * c, w * W);
    // The error has 8 units of the integrand's size. Its roundings: q, the sum of two waves 1, times q 1; n of cosines
    // 1, of u 2, their product 1, the sum 1, n g 1. In the moment s and W are no more than n.
    const double error = 1 + (q.of_itself() + 8) / 8;
    return {nx * wave.value[0], ny * wave.value[0], W / length * wave.value[1], error * wave.error[0],
            error * W / length * wave.error[1]};
  };
  // Cuts where the wave's jump leaves the zone (nowhere if the pole is inside), between them, where it comes nearest to
  // the rim, and across a long axis, where W turns.
  std::array<double, 6> cuts{-pi / 2, pi / 2, pi / 2, pi / 2, pi / 2, pi / 2};
  std::size_t count = 1;
  const auto angle = [&](double x, double y) { return std::atan2(ex * y - ey * x, ex * x + ey * y); };
  const double theta_0 = std::atan2(ey / a, ex / b);
  const double leaves = level > w ? std::atan2(std::sqrt((level - w) * (level + w)), w) : 0;
  for (const double theta : {-leaves, 0.0, leaves}) {
    cuts[count++] = round ? theta : angle(std::cos(theta_0 + theta) / b, std::sin(theta_0 + theta) / a);
  }
  if (!round) {
    const double turn = a > b ? angle(1, 0) : angle(0, 1);
    cuts[count++] = turn > pi / 2 ? turn - pi : turn < -pi / 2 ? turn + pi : turn;
  }
  std::sort(cuts.begin(), cuts.begin() + count);
  BoundedIntegrals<5> sum;
  for (std::size_t i = 0; i < count; ++i) {
    if (round && cuts[i + 1] <= 0) continue;  // the same as beyond 0
    add(sum,
        integrate<5>([&, lo = cuts[i]](double from_lo, double) { return at(lo + from_lo); }, cuts[i], cuts[i + 1]));
  }
  BoundedWrench g = collected(sum, (round ? 2 : 1) / pi, length);
  if (round) {
    const double along = g.value.fx * ex + g.value.fy * ey;
    g.value.fx = along * ex;
    g.value.fy = along * ey;
  }
  g.value.m *= std::copysign(1.0, u.w);
  const double rounding = rounding_of(zone, q, level / w, speed + w * length);
  g.force_error += rounding;
  g.moment_error += rounding * length;
  return g;
}

BoundedWrench stribeck_excess(const FlatPunchDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 0), u);
}

BoundedWrench stribeck_excess(const HertzDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 1), u);
}

BoundedWrench stribeck_excess(const HertzEllipse& ellipse, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(ellipse.a(), ellipse.b(), 1), u);
}

BoundedWrench stribeck_excess(const PowerDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), disc.exponent()), u);
}

BoundedWrench stribeck_excess(const SeedHertzDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 1), u);
}

BoundedWrench stribeck_excess(const UniformDisc& disc, const Twist& u) noexcept {
  return stribeck_excess(PowerEllipse::of_semi_axes(disc.radius(), disc.radius(), 0.5), u);
}

}  // namespace patchgrip::friction
