#include <patchgrip/contact/flat_end_paraboloid.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <patchgrip/contact/increasing_root.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

FlatEndParaboloid FlatEndParaboloid::of(double end_radius, double curvature_radius) {
  return {require_positive("end_radius", end_radius), require_positive("curvature_radius", curvature_radius)};
}

FlatEndCircle FlatEndParaboloid::circle(double a) const {
  require_in("contact_radius", a, b_, max_radius(), Ends::open);
  return FlatEndCircle::of_radius(b_, a);
}

// S^2 (S^2 + b^2) = (delta R)^2
FlatEndCircle FlatEndParaboloid::radius_of_approach(double approach) const {
  const double x = 2 * (approach / b_) * (R_ / b_);
  return FlatEndCircle::of_reach(b_, b_ * x / (std::numbers::sqrt2 * std::sqrt(1 + std::hypot(1, x))));
}

// With S alone large or small one of the two terms of F is left.
FlatEndCircle FlatEndParaboloid::radius_of_force(double force) const {
  const auto value = [&](double S) { return this->force(FlatEndCircle::of_reach(b_, S)); };
  const auto slope = [&](double S) { return 2 * (2 * S * (S / R_) + b_ / R_ * b_); };
  const double start = std::min(force / b_ * (R_ / b_) / 2, std::cbrt(0.75 * force * R_));
  return FlatEndCircle::of_reach(b_, increasing_root(value, slope, force, start));
}

}  // namespace patchgrip::contact
