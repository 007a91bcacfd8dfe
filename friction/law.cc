#include <patchgrip/friction/law.h>

#include <cmath>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;

struct Bounded {
  double value;
  double error;
};

struct CentroidVelocity {
  double x, y;
  double error;  // of either component
};

CentroidVelocity centroid_velocity(const PressureMoments& s, const Twist& v) noexcept {
  // Near a pole at the centroid the two terms cancel; what is left of their rounding is in the error.
  const double rounding =
      2 * unit * (std::fabs(v.vx) + std::fabs(v.vy) + 2 * std::fabs(v.w) * (std::fabs(s.x) + std::fabs(s.y)));
  return {v.vx - v.w * s.y, v.vy + v.w * s.x, rounding};
}

Bounded mean_square(const PressureMoments& s, const Twist& v) noexcept {
  const CentroidVelocity c = centroid_velocity(s, v);
  const double value = c.x * c.x + c.y * c.y + v.w * v.w * s.polar;
  return {value, 2 * c.error * (std::fabs(c.x) + std::fabs(c.y) + c.error) + 6 * unit * value};
}

Bounded bounded_coefficient(const Law& law, const PressureMoments& s, const Twist& v) noexcept {
  if (law.mu_static == law.mu_kinetic) return {law.mu_kinetic, 0};
  // In units of v_S, whose square a double need not hold.
  const double v_S = law.stribeck_velocity;
  const Bounded z = mean_square(s, {v.vx / v_S, v.vy / v_S, v.w / v_S});
  const double step = law.mu_static - law.mu_kinetic;
  if (!(z.value < 700)) return {law.mu_kinetic, 1e-300 * std::fabs(step)};
  const double excess = step * std::exp(-z.value);
  const double mu = law.mu_kinetic + excess;
  return {mu, std::fabs(excess) * (z.error + unit * (6 * z.value + 4)) + unit * mu};
}

}  // namespace

Law Law::coulomb(double mu) {
  contact::require_non_negative("mu", mu);
  return {mu, mu, 1, 0};
}

Law Law::stribeck(double mu_static, double mu_kinetic, double stribeck_velocity) {
  return {contact::require_non_negative("mu_kinetic", mu_kinetic),
          contact::require_non_negative("mu_static", mu_static),
          contact::require_positive("stribeck_velocity", stribeck_velocity), 0};
}

Law Law::viscous(double mu_viscous) { return Law{}.with_viscous(mu_viscous); }

Law Law::with_viscous(double mu) const {
  Law law = *this;
  law.mu_viscous = contact::require_non_negative("mu_viscous", mu);
  return law;
}

double mean_square_speed(const PressureMoments& moments, const Twist& v) noexcept {
  return mean_square(moments, v).value;
}

double coefficient(const Law& law, const PressureMoments& moments, const Twist& v) noexcept {
  return bounded_coefficient(law, moments, v).value;
}

BoundedWrench friction_wrench(const Law& law, double normal_force, const PressureMoments& s,
                              const BoundedWrench& gradient, const Twist& v) noexcept {
  const Bounded mu = bounded_coefficient(law, s, v);
  const Wrench& g = gradient.value;
  const double dry = mu.value * normal_force;
  const double dry_error = mu.error * normal_force + 3 * unit * dry;
  BoundedWrench t{{-dry * g.fx, -dry * g.fy, -dry * g.m},
                  dry * gradient.force_error + dry_error * std::hypot(g.fx, g.fy),
                  dry * gradient.moment_error + dry_error * std::fabs(g.m)};
  if (law.mu_viscous == 0) return t;

  const CentroidVelocity c = centroid_velocity(s, v);
  const double wet = law.mu_viscous * normal_force;
  const double s1 = s.x * s.x + s.y * s.y + s.polar;
  const double spin = s.x * v.vy - s.y * v.vx + v.w * s1;
  const double spin_size = std::fabs(s.x * v.vy) + std::fabs(s.y * v.vx) + std::fabs(v.w) * s1;
  t.value.fx -= wet * c.x;
  t.value.fy -= wet * c.y;
  t.value.m -= wet * spin;
  t.force_error += wet * (2 * c.error + 3 * unit * std::hypot(c.x, c.y)) + unit * std::hypot(t.value.fx, t.value.fy);
  t.moment_error += wet * unit * 7 * spin_size + unit * std::fabs(t.value.m);
  return t;
}

}  // namespace patchgrip::friction
