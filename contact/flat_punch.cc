#include <patchgrip/contact/flat_punch.h>

#include <cmath>
#include <limits>
#include <numbers>

#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

FlatPunch FlatPunch::under_force(double radius, double normal_force, double contact_modulus) {
  require_positive("radius", radius);
  require_positive("contact_modulus", contact_modulus);
  require_positive("normal_force", normal_force);
  const double approach = normal_force / (2 * contact_modulus * radius);
  return {radius, contact_modulus, normal_force, require_representable("approach", approach)};
}

FlatPunch FlatPunch::at_approach(double radius, double approach, double contact_modulus) {
  require_positive("radius", radius);
  require_positive("contact_modulus", contact_modulus);
  require_positive("approach", approach);
  const double force = 2 * contact_modulus * radius * approach;
  return {radius, contact_modulus, require_representable("normal_force", force), approach};
}

double FlatPunch::pressure(double r) const {
  r = std::fabs(r);
  if (r > radius) return 0;
  return force / (2 * std::numbers::pi * radius * (std::sqrt(radius - r) * std::sqrt(radius + r)));
}

double FlatPunch::displacement(double r) const {
  r = std::fabs(r);
  if (r <= radius) return approach;
  // Of the arcsin near the rim and of the arctan far away the condition number is larger.
  const double u = radius / r;
  const double angle = 4 * u * u > 3 ? std::atan2(radius, std::sqrt(r - radius) * std::sqrt(r + radius)) : std::asin(u);
  return 2 * approach / std::numbers::pi * angle;
}

}  // namespace patchgrip::contact
