#include <patchgrip/contact/hertz_ellipse_approximation.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace patchgrip::contact {

HertzEllipseApproximation HertzEllipseApproximation::under_force(double normal_force, const RelativeRadii& radii,
                                                                 double contact_modulus) {
  require_positive("normal_force", normal_force);
  require_positive("contact_modulus", contact_modulus);
  const double q = require_in("radius_ratio", radii.small / radii.large, smallest_ratio, 1);

  const double geometric = std::sqrt(radii.small) * std::sqrt(radii.large);
  const double greenwood = radii.large * std::cbrt(2 * q * q / (1 + q));
  const double mean = std::cbrt(0.75 * normal_force / contact_modulus * greenwood);  // sqrt(a b)
  const double root_of_ratio = std::cbrt(q);                                         // sqrt(b / a)
  const double pressure = 1.5 * normal_force / (std::numbers::pi * mean * mean);

  // What is left at the circle is rounding: of p_0, the most of all, half of it from the cube roots.
  constexpr double rounding = 16 * 0x1p-53;
  const double L2 = std::log(q) * std::log(q);
  const double ratio = rounding + 0.0031 * L2 * std::sqrt(L2) / (1 + 0.04 * L2);
  const double area = rounding + 3.9e-4 * L2 * L2 / (1 + 0.1 * L2 + 3e-4 * L2 * L2);
  const double depth = rounding + 0.014 * L2 / (1 + 0.074 * L2 + 1e-4 * L2 * L2);
  return {require_representable("semi_axis_a", mean / root_of_ratio),
          require_representable("semi_axis_b", mean * root_of_ratio),
          require_representable("peak_pressure", pressure),
          require_representable("approach", mean * mean / geometric),
          std::sqrt((1 + area) / (1 - ratio)) - 1,
          std::max(1 - std::sqrt(1 - ratio), std::sqrt(1 + area) - 1),
          area / (1 + area),
          depth};
}

}  // namespace patchgrip::contact
