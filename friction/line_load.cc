#include <patchgrip/friction/line_load.h>

#include <cmath>
#include <stdexcept>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/kernels/line_motion.h>

namespace patchgrip::friction {
namespace {

constexpr double force_error = 12 * 0x1p-53;
constexpr double moment_error = 16 * 0x1p-53;

bool at_rest(const Twist& v) noexcept { return v.vx == 0 && v.vy == 0 && v.w == 0; }

}  // namespace

LineLoad LineLoad::of_length(double length) { return LineLoad(contact::require_positive("length", length)); }

double LineLoad::dissipation(const Twist& v) const noexcept { return power(gradient(v), v); }

Wrench LineLoad::gradient(const Twist& twist) const noexcept {
  if (at_rest(twist)) return {};
  const Twist v = finite_or_nan(twist);
  const kernels::LineMotion<double> m(v.vx, v.vy, v.w, length_);
  return {v.vx == 0 ? 0 : 2 * (v.vx / m.Q) * m.A, m.nu, std::copysign(length_ / 4 * m.x * m.eta2 * m.gamma, v.w)};
}

BoundedWrench LineLoad::bounded_gradient(const Twist& v) const noexcept {
  const Wrench g = gradient(v);
  return {g, force_error * std::hypot(g.fx, g.fy), moment_error * std::fabs(g.m)};
}

Hessian LineLoad::hessian(const Twist& twist) const {
  if (at_rest(twist)) throw std::domain_error("twist = 0 is not allowed: the Hessian of D exists only in motion");
  const Twist v = finite_or_nan(twist);
  const kernels::LineMotion<double> m(v.vx, v.vy, v.w, length_);
  if (m.on_line) throw std::domain_error("twist has its pole on the line load: the Hessian of D is infinite there");
  const double k = 2 / m.Q;
  const double ux = v.vx / m.Q;
  const double lever = std::copysign(length_ * m.x, v.w);  // w L^2 / Q
  const double across = m.nu / m.ends;
  const double square = m.nu * across;
  return {k * (m.x * m.x * m.alpha + m.c2 * square),
          -2 * k * ux * across,
          -k * ux * lever * (m.alpha - square),
          k * (m.eta2 / m.ends),
          -k / 2 * lever * m.eta2 * across,
          k / 4 * length_ * length_ * m.eta2 * (m.c2 * m.alpha + m.x * m.x * square)};
}

}  // namespace patchgrip::friction
