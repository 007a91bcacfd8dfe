#include <patchgrip/verification/claims/bodies.h>

#include <utility>

namespace patchgrip::verification {

ElasticPair elastic_pair() {
  const auto first = contact::Material::elastic(3000, 0.3), second = contact::Material::elastic(500, 0.45);
  PressedBody press = pressed_paraboloid(contact::contact_modulus(first, second));
  return {first, second, std::move(press)};
}

PressedEllipse pressed_ellipse(double small_over_large) {
  constexpr double small = 1000;
  const auto material = contact::Material::elastic(1000 * (1 - 0.09), 0.3);  // E* = 1 kPa
  const auto radii = contact::RelativeRadii::of(small, small / small_over_large);
  // b is about 1 m: F = 4/3 E* b^3 / R_small times what the shape makes of it.
  const auto unit = contact::HertzEllipse::under_force(1, radii, 1000);
  const double force = 1 / (unit.b * unit.b * unit.b);
  const auto ellipse = contact::HertzEllipse::under_force(force, radii, 1000);
  return {material,
          small,
          radii.large,
          ellipse,
          {number("approach", "m", ellipse.approach, 1.5e-3, "0.15 %: tetrahedra, some to the minor semi-axis"),
           number("a, from <x^2>_p", "m", ellipse.a, 3e-3, "the rim cuts elements"),
           number("b, from <y^2>_p", "m", ellipse.b, 3e-3, "the rim cuts elements")}};
}

}  // namespace patchgrip::verification
