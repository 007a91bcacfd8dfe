#include <patchgrip/contact/adhesion/dmt.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr double infinity = std::numeric_limits<double>::infinity();

AdhesiveState state(const AdhesiveSphere& s, Real force, Real approach, Real a) {
  return {static_cast<double>(force), static_cast<double>(approach), static_cast<double>(a),
          static_cast<double>(2 * s.contact_modulus * a)};
}

}  // namespace

AdhesiveState Dmt::under_force(double normal_force) const {
  require_in("normal_force", require_finite("normal_force", normal_force), static_cast<double>(-2 * sphere.pi_w_R()),
             infinity);
  // The rounded limit itself may lie a little below the exact one.
  const Real pressing = std::max<Real>(0, sphere.force_above(1, normal_force, 2));
  const Real a = std::cbrt(3 * Real(sphere.relative_radius) * pressing / (4 * Real(sphere.contact_modulus)));
  return state(sphere, normal_force, a * a / sphere.relative_radius, a);
}

AdhesiveState Dmt::at_approach(double approach) const {
  const Real depth = require_non_negative("approach", approach);
  const Real a = std::sqrt(sphere.relative_radius * depth);
  return state(sphere, 4 * Real(sphere.contact_modulus) * a * depth / 3 - 2 * sphere.pi_w_R(), approach, a);
}

double Dmt::pressure(double contact_radius, double r) const {
  const Real a = require_non_negative("contact_radius", contact_radius);
  require_in("r", r, 0, contact_radius);
  return static_cast<double>(2 * Real(sphere.contact_modulus) / (std::numbers::pi_v<Real> * sphere.relative_radius) *
                             std::sqrt((a - r) * (a + r)));
}

}  // namespace patchgrip::contact
