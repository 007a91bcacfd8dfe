#include <patchgrip/contact/power_profile.h>

namespace patchgrip::contact {

PowerProfile::PowerProfile(double height, double at_radius, double exponent)
    : height_(height),
      length_(at_radius),
      exponent_(exponent),
      constant_(static_cast<double>(gamma_constant<long double>(exponent))) {}

PowerProfile PowerProfile::through(double height, double at_radius, double exponent) {
  return {require_positive("height", height), require_positive("at_radius", at_radius),
          require_in("exponent", exponent, 0, 1000, Ends::left_open)};
}

PowerProfile PowerProfile::of_coefficient(double coefficient, double exponent) {
  return {require_positive("coefficient", coefficient), 1, require_in("exponent", exponent, 0, 1000, Ends::left_open)};
}

// One Newton step repairs what the rounded exponents 1/m and 1/(m + 1) cost where the ratio is far from one.
double PowerProfile::radius_of_approach(double approach) const {
  const double a = length_ * std::pow(approach / (constant_ * height_), 1 / exponent_);
  return a + a * (approach / this->approach(a) - 1) / exponent_;
}

double PowerProfile::radius_of_force(double force) const {
  const double m = exponent_;
  const double a = length_ * std::pow(force / length_ / (2 * m / (m + 1) * constant_ * height_), 1 / (m + 1));
  return a + a * (force / this->force(a) - 1) / (m + 1);
}

}  // namespace patchgrip::contact
