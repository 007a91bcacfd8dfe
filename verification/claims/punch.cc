#include <patchgrip/verification/claims/punch.h>

#include <cmath>

#include <patchgrip/contact/dundurs.h>
#include <patchgrip/contact/stick_radius.h>

namespace patchgrip::verification {

Punch flat_punch() {
  const auto material = contact::Material::elastic(1000 * (1 - 0.09), 0.3);  // E* = 1 kPa
  const double modulus = contact::contact_modulus(material, contact::Material::rigid());
  const auto punch = contact::FlatPunch::under_force(1, 1, modulus);
  const std::vector<double> radii{0, 0.25, 0.5, 0.75, 0.9};
  std::vector<double> pressures;
  for (const double r : radii) pressures.push_back(punch.pressure(r));
  return {material,
          punch,
          radii,
          {number("approach", "m", punch.approach, 5e-4, "0.05 % in force, which is linear in the approach"),
           {"p(r), r <= 0.9 a", "Pa", pressures, punch.pressure(0), 5e-3,
            "of p(0); elements a twentieth as large at the edge, where p is infinite"}}};
}

std::vector<Quantity> flat_punch_at_approach() {
  const Punch punch = flat_punch();
  return {number("force", "N", punch.library.force, 5e-4, punch.quantities[0].reason), punch.quantities[1]};
}

RoughPunch rough_punch() {
  constexpr double mu = 0.1;
  const auto material = contact::Material::elastic(1000, 0.45);
  const double beta = contact::Dundurs::of(contact::Material::rigid(), material).beta;
  const double stick = contact::StickRatio::of(std::fabs(beta) / mu).stick;
  return {material,
          1,
          mu,
          {number("stick radius", "m", stick, 0.01,
                  "uncoupled (Goodman): low by 1 % at beta_D = 0.2, here it is 0.09; FE sees the edge to an element")}};
}

}  // namespace patchgrip::verification
