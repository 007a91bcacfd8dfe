#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

HertzEllipse ellipse(Real force, Real approach, Real a, const EllipseShape<Real>& shape) {
  const Real b = shape.k * a;
  const auto representable = [](const char* name, Real value) {
    return require_representable(name, static_cast<double>(value));
  };
  return {representable("normal_force", force),
          representable("approach", approach),
          representable("semi_axis_a", a),
          representable("semi_axis_b", b),
          static_cast<double>(shape.one_minus_k),
          static_cast<double>(shape.eccentricity),
          representable("peak_pressure", 3 * force / (2 * pi * a * b)),
          representable("stiffness", 3 * force / (2 * approach))};
}

}  // namespace

EllipseShape<long double> shape_of(const RelativeRadii& radii) {
  // Near the circle the difference of the radii is what is known best.
  if (radii.one_minus_ratio <= 0.5) return EllipseShape<Real>::of_one_minus_ratio(radii.one_minus_ratio);
  return EllipseShape<Real>::of_ratio(Real(radii.small) / radii.large);
}

HertzEllipse HertzEllipse::under_force(double normal_force, const RelativeRadii& radii, double contact_modulus) {
  const Real force = require_positive("normal_force", normal_force);
  const Real modulus = require_positive("contact_modulus", contact_modulus);
  const auto shape = shape_of(radii);
  const Real a = std::cbrt(3 * force * radii.large * shape.integrals.D / (pi * modulus));
  return ellipse(force, 3 * force * shape.integrals.K / (2 * pi * a * modulus), a, shape);
}

HertzEllipse HertzEllipse::at_approach(double approach, const RelativeRadii& radii, double contact_modulus) {
  const Real depth = require_positive("approach", approach);
  const Real modulus = require_positive("contact_modulus", contact_modulus);
  const auto shape = shape_of(radii);
  const Real a = std::sqrt(2 * radii.large * depth * shape.integrals.D / shape.integrals.K);
  return ellipse(2 * pi * a * modulus * depth / (3 * shape.integrals.K), depth, a, shape);
}

}  // namespace patchgrip::contact
