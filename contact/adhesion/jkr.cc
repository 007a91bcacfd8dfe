#include <patchgrip/contact/adhesion/jkr.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

// y^2 / 2 = pi w R^2 / (E* a^3), and a length of it.
Real length_cubed(const AdhesiveSphere& s) {
  return pi * s.work_of_adhesion * s.relative_radius * s.relative_radius / s.contact_modulus;
}

Real force_at(const AdhesiveSphere& s, Real a) {
  const Real E = s.contact_modulus, a3 = a * a * a;
  return 4 * E * a3 / (3 * Real(s.relative_radius)) - std::sqrt(8 * pi * s.work_of_adhesion * E * a3);
}

Real approach_at(const AdhesiveSphere& s, Real a) {
  return a * a / s.relative_radius - std::sqrt(2 * pi * a * s.work_of_adhesion / s.contact_modulus);
}

double stiffness_at(const AdhesiveSphere& s, Real a) {
  const Real y = std::sqrt(2 * length_cubed(s) / (a * a * a));
  return static_cast<double>(2 * s.contact_modulus * a * (4 - 3 * y) / (4 - y));
}

AdhesiveState state(const AdhesiveSphere& s, Real force, Real approach, Real a) {
  return {static_cast<double>(force), static_cast<double>(approach),
          require_representable("contact_radius", static_cast<double>(a)), stiffness_at(s, a)};
}

// The larger root of t^2 (6 + 4 t + t^2) = g: Newton from above, where the left side is convex.
Real excess_root(Real g) {
  if (g == 0) return 0;
  Real t = std::min(std::sqrt(g / 6), std::sqrt(std::sqrt(g)));
  for (int i = 0; i < 60; ++i) {
    const Real residual = t * t * (6 + t * (4 + t)) - g;
    const Real next = t - residual / (4 * t * (3 + t * (3 + t)));
    if (!(next < t)) return t;
    t = next;
  }
  throw std::runtime_error("jkr: contact radius not found, 3 + 4 R delta / L^2 = " +
                           std::to_string(static_cast<double>(g)));
}

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

AdhesiveState Jkr::at_radius(double contact_radius) const {
  const Real a = require_positive("contact_radius", contact_radius);
  return state(sphere, force_at(sphere, a), approach_at(sphere, a), a);
}

AdhesiveState Jkr::under_force(double normal_force) const {
  require_in("normal_force", require_finite("normal_force", normal_force),
             static_cast<double>(-3 * sphere.pi_w_R() / 2), infinity);
  // The rounded limit itself may lie a little below the exact one.
  const Real excess = std::max<Real>(0, sphere.force_above(2, normal_force, 3));
  const Real sum = sphere.force_above(1, normal_force, 3) + std::sqrt(3 * sphere.pi_w_R() * excess);
  const Real a = std::cbrt(3 * Real(sphere.relative_radius) * sum / (4 * Real(sphere.contact_modulus)));
  return state(sphere, normal_force, approach_at(sphere, a), a);
}

AdhesiveState Jkr::unstable_under_force(double normal_force) const {
  require_in("normal_force", normal_force, static_cast<double>(-3 * sphere.pi_w_R() / 2), 0, Ends::right_open);
  const Real excess = std::max<Real>(0, sphere.force_above(2, normal_force, 3));
  const Real sum = sphere.force_above(1, normal_force, 3) + std::sqrt(3 * sphere.pi_w_R() * excess);
  const Real part = Real(normal_force) * normal_force / sum;
  const Real a = std::cbrt(3 * Real(sphere.relative_radius) * part / (4 * Real(sphere.contact_modulus)));
  return state(sphere, normal_force, approach_at(sphere, a), a);
}

AdhesiveState Jkr::at_approach(double approach) const {
  const Real L = std::cbrt(length_cubed(sphere));
  const Real unit = L * L / sphere.relative_radius;
  require_in("approach", require_finite("approach", approach), static_cast<double>(-3 * unit / 4), infinity);
  const Real t = excess_root(std::max<Real>(0, (3 * unit + 4 * Real(approach)) / unit));
  const Real a = L * (1 + t) * (1 + t) / 2;
  return state(sphere, force_at(sphere, a), approach, a);
}

AdhesiveState Jkr::load_pull_off() const {
  const Real a = std::cbrt(9 * length_cubed(sphere) / 8);
  return {static_cast<double>(-3 * sphere.pi_w_R() / 2), static_cast<double>(approach_at(sphere, a)),
          static_cast<double>(a), 0};
}

AdhesiveState Jkr::displacement_pull_off() const {
  const Real L = std::cbrt(length_cubed(sphere));
  return {static_cast<double>(-5 * sphere.pi_w_R() / 6),
          static_cast<double>(-3 * L * L / (4 * Real(sphere.relative_radius))), static_cast<double>(L / 2), infinity};
}

AdhesiveState Jkr::jump_in() const {
  const Real a = std::cbrt(2 * length_cubed(sphere));
  return state(sphere, -4 * sphere.pi_w_R() / 3, 0, a);
}

AdhesiveState Jkr::no_load() const {
  const Real a = std::cbrt(9 * length_cubed(sphere) / 2);
  return state(sphere, 0, approach_at(sphere, a), a);
}

double Jkr::pressure(double contact_radius, double r) const {
  const Real a = require_positive("contact_radius", contact_radius);
  require_in("r", r, 0, contact_radius, Ends::right_open);
  const Real E = sphere.contact_modulus;
  const Real depth = std::sqrt((a - r) * (a + r));
  const Real tension = std::sqrt(2 * pi * a * sphere.work_of_adhesion / E);
  return static_cast<double>(E / pi * (2 * depth / sphere.relative_radius - tension / depth));
}

}  // namespace patchgrip::contact
