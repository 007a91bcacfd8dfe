#include <patchgrip/contact/flat_end_cone.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <patchgrip/contact/increasing_root.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

FlatEndCone FlatEndCone::of(double end_radius, double slope) {
  return {require_positive("end_radius", end_radius), require_positive("slope", slope)};
}

FlatEndCircle FlatEndCone::circle(double a) const {
  require_in("contact_radius", a, b_, max_radius(), Ends::open);
  return FlatEndCircle::of_radius(b_, a);
}

// Starts are the limits of a large flat end and of a sharp cone.
FlatEndCircle FlatEndCone::radius_of_approach(double approach) const {
  const auto value = [&](double S) { return this->approach(FlatEndCircle::of_reach(b_, S)); };
  const auto slope = [&](double S) {
    const auto a = FlatEndCircle::of_reach(b_, S);
    return approach_slope(a) * (S / a.radius);
  };
  return FlatEndCircle::of_reach(b_, increasing_root(value, slope, approach, approach / slope_));
}

FlatEndCircle FlatEndCone::radius_of_force(double force) const {
  const auto value = [&](double S) { return this->force(FlatEndCircle::of_reach(b_, S)); };
  const auto slope = [&](double S) { return 2 * slope_ * (S * std::atan(S / b_) + b_); };
  const double load = force / slope_;
  const double start = std::min(load / b_ / 2, std::sqrt(load));
  return FlatEndCircle::of_reach(b_, increasing_root(value, slope, force, start));
}

}  // namespace patchgrip::contact
