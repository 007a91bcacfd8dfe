#include <patchgrip/contact/sphere.h>

#include <patchgrip/contact/increasing_root.h>

namespace patchgrip::contact {
namespace {

double approach_slope_of_s(double s) {
  const double sech = 1 / std::cosh(s);
  return std::tanh(s) + s * sech * sech;
}

}  // namespace

// sinh^2 V = cosh^2 s (tanh^2 s - r^2/R^2); near the equator the difference is that of the distances from it.
double Sphere::pressure(double r, const SphereCircle& a) const {
  const double y0 = r / R_;
  const double q = std::tanh(a.s);
  const double difference = a.s < 0.5 ? q - y0 : (R_ - r) / R_ - a.one_minus_ratio();
  if (!(difference > 0)) return 0;
  return pressure_within(r, std::cosh(a.s) * std::sqrt(difference) * std::sqrt(q + y0));
}

double Sphere::displacement(double r, const SphereCircle& a) const {
  const double radius = a;
  const double lacking = R_ * a.one_minus_ratio();
  const double beyond = a.s < 0.5 ? r - radius : (r - R_) + lacking;
  if (!(beyond > 0)) return approach(a) - height(r);
  return displacement_around(r, beyond, lacking, radius, a.s);
}

SphereCircle Sphere::circle(double a) const {
  return {R_, artanh_ratio(require_in("contact_radius", a, 0, R_, Ends::open))};
}

SphereCircle Sphere::radius_of_approach(double approach) const {
  const double d = approach / R_;
  const auto value = [](double s) { return s * std::tanh(s); };
  return {R_, increasing_root(value, approach_slope_of_s, d, d < 1 ? std::sqrt(d) : d)};
}

SphereCircle Sphere::radius_of_force(double force) const {
  const double f = force / R_ / R_;
  const auto value = [](double s) { return unit_force(std::tanh(s), s); };
  const auto slope = [](double s) { return 2 * std::tanh(s) * approach_slope_of_s(s); };
  return {R_, increasing_root(value, slope, f, f < 1 ? std::cbrt(0.75 * f) : f)};
}

}  // namespace patchgrip::contact
