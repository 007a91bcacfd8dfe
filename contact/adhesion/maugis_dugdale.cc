#include <patchgrip/contact/adhesion/maugis_dugdale.h>
#include <patchgrip/contact/adhesion/tabor.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr double infinity = std::numeric_limits<double>::infinity();

Real stiffness_modulus(const AdhesiveSphere& s) { return 4 * Real(s.contact_modulus) / 3; }  // K

Real unit_radius(const AdhesiveSphere& s) { return std::cbrt(s.pi_w_R() * s.relative_radius / stiffness_modulus(s)); }

// Relative error of a radius found from a force that is itself within rounding: slope x + (3/2) A^3 x^2 = force error,
// where F'' >= 3 A on the stable branch.
double radius_error(const MaugisCurve<Real>::Point& point) {
  const Real force_error = 0x1p-60L * std::max<Real>(point.force_term, 1);
  const Real linear = std::max<Real>(0, point.slope * point.A);
  const Real root = std::sqrt(linear * linear + 6 * point.A * point.A * point.A * force_error);
  return static_cast<double>(1.1L * 0x1p-53L + std::min<Real>(1, 2 * force_error / (linear + root)));
}

}  // namespace

MaugisDugdale MaugisDugdale::of(const AdhesiveSphere& sphere, double attraction) {
  const Real lambda = unrounded_maugis_parameter(sphere, attraction);
  require_in("maugis_parameter", static_cast<double>(lambda), 1e-8, 1e8);
  return {sphere, attraction, lambda};
}

MaugisState MaugisDugdale::state(const Point& point, double relative_radius_error) const {
  const Real unit = unit_radius(sphere_);
  const Real a = unit * point.A;
  return {static_cast<double>(sphere_.pi_w_R() * point.force),
          static_cast<double>(unit * unit / sphere_.relative_radius * point.approach),
          require_representable("contact_radius", static_cast<double>(a)),
          require_representable("outer_radius", static_cast<double>(a + a * point.n)),
          static_cast<double>(a * point.n),
          relative_radius_error};
}

MaugisState MaugisDugdale::at_radius(double contact_radius) const {
  const Real a = require_positive("contact_radius", contact_radius);
  MaugisState at = state(curve_.at_radius(a / unit_radius(sphere_)), 1.1 * 0x1p-53);
  at.contact_radius = contact_radius;
  return at;
}

MaugisState MaugisDugdale::under_force(double normal_force) const {
  require_in("normal_force", require_finite("normal_force", normal_force),
             static_cast<double>(sphere_.pi_w_R() * pull_off_.force), infinity);
  const auto point = curve_.under_force(normal_force / sphere_.pi_w_R(), pull_off_);
  MaugisState at = state(point, radius_error(point));
  at.normal_force = normal_force;
  return at;
}

MaugisState MaugisDugdale::pull_off() const { return state(pull_off_, 2 * 0x1p-53); }

double MaugisDugdale::pressure(const MaugisState& state, double r) const {
  require_non_negative("r", r);
  if (r >= state.outer_radius) return 0;
  if (r >= state.contact_radius) return -attraction_;
  const Real a = state.contact_radius, ring = state.ring_width;
  const Real depth = std::sqrt((a - r) * (a + r));
  const Real reach = std::sqrt(ring * (2 * a + ring));  // sqrt(c^2 - a^2)
  return static_cast<double>(
      2 / pi * (sphere_.contact_modulus * depth / sphere_.relative_radius - attraction_ * std::atan2(reach, depth)));
}

double pull_off_fit(double maugis_parameter) {
  const double power = 4.04 * std::pow(require_positive("maugis_parameter", maugis_parameter), 1.4);
  return 1.75 - 0.25 * (1 - 2 / (1 + power));
}

}  // namespace patchgrip::contact
