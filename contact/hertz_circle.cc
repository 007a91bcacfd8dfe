#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace patchgrip::contact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

double relative_radius(double first, double second) {
  const long double one = require_radius("first_radius", first);
  const long double other = require_radius("second_radius", second);
  // R_1 R_2 / (R_1 + R_2) would be infinity / infinity for a plane; 1/R_1 + 1/R_2 would cancel for a ball in a socket.
  const auto radius = [&] {
    if (one == infinity) return static_cast<double>(other);
    if (other == infinity) return static_cast<double>(one);
    return static_cast<double>(one * other / (one + other));
  }();
  if (!(radius > 0 && radius < infinity)) {
    refuse("relative_radius", radius,
           "must be positive and finite: a hollow must be wider than the ball in it, and one body must be curved");
  }
  return require_representable("relative_radius", radius);
}

HertzCircle HertzCircle::under_force(double normal_force, double relative_radius, double contact_modulus) {
  const long double force = require_positive("normal_force", normal_force);
  const long double modulus = require_positive("contact_modulus", contact_modulus);
  const Paraboloid shape = Paraboloid::of_radius(relative_radius);
  const long double radius = shape.radius_of_force(force / modulus);
  const long double approach = shape.approach(radius);
  const long double pressure = modulus * shape.pressure(0.0L, radius);
  return {require_representable("contact_radius", static_cast<double>(radius)),
          require_representable("approach", static_cast<double>(approach)),
          require_representable("peak_pressure", static_cast<double>(pressure))};
}

}  // namespace patchgrip::contact
