#include <patchgrip/contact/hertz_axis_stress.h>

#include <patchgrip/contact/increasing_root.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

HertzAxisStress HertzAxisStress::of(double peak_pressure, double contact_radius, double poisson_ratio) {
  return {require_positive("peak_pressure", peak_pressure), require_positive("contact_radius", contact_radius),
          require_in("poisson_ratio", poisson_ratio, -1, 0.5, Ends::left_open)};
}

// 1 + nu = N / D, N = 3 s / (1 + s^2)^2, D = arctan(1/s) - s / (1 + s^2): rising up to 1.6 at s = 0.57.
double HertzAxisStress::depth_of_max_shear() const {
  const auto numerator = [](double s) { return 3 * s / ((1 + s * s) * (1 + s * s)); };
  const auto denominator = [](double s) { return std::atan(1 / s) - s / (1 + s * s); };
  const auto value = [&](double s) { return numerator(s) / denominator(s); };
  const auto slope = [&](double s) {
    const double w = 1 / (1 + s * s);
    return (3 * (1 - 3 * s * s) * w * w * w + 2 * w * w * value(s)) / denominator(s);
  };
  const double target = 1 + nu_;
  return a_ * increasing_root(value, slope, target, 0.3 * target, 0, 0.57);
}

}  // namespace patchgrip::contact
