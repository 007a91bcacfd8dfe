#include <patchgrip/verification/claims/rubber.h>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/fingertip/power_law.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/sphere.h>

namespace patchgrip::verification {
namespace {

using Hertz = contact::AxisymmetricContact<contact::Paraboloid>;

constexpr double modulus = 4;  // E* = 4 G for nu = 1/2

}  // namespace

PressedHemisphere rubber_hemisphere() {
  using Exact = contact::AxisymmetricContact<contact::Sphere>;
  const std::string reason = "large strains, and a base that is held";
  PressedHemisphere rubber{{0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4}, {}};
  const std::vector<double> right(rubber.approaches.size(), 1);
  std::vector<double> hertz, sphere, hertz_radius, sphere_radius;
  for (const double d : rubber.approaches) {
    const auto flat = Hertz::at_approach(contact::Paraboloid::of_radius(1), d, modulus);
    const auto round = Exact::at_approach(contact::Sphere::of_radius(1), d, modulus);
    hertz.push_back(flat.force());
    hertz_radius.push_back(flat.radius());
    sphere.push_back(round.force());
    sphere_radius.push_back(round.radius());
  }
  rubber.quantities = {
      {"force of Hertz", "N", hertz, hertz.back(), 0, reason, Claim::differs},
      {"force of the exact sphere", "N", sphere, sphere.back(), 0, reason, Claim::differs},
      {"radius of Hertz", "m", hertz_radius, hertz_radius.back(), 0, reason, Claim::differs},
      {"radius of the exact sphere", "m", sphere_radius, sphere_radius.back(), 0, reason, Claim::differs},
      {"radius over Hertz's under the load", "1", right, 1, 0.08,
       "8 %: what the held base makes of it at 0.4 R, where 7.5 % was found"},
      {"radius over a power of the load", "1", right, 1, 0.05,
       "5 %: one exponent for loads of nearly three decades; 4 % was found"},
      {"exponent of that power", "1", {1. / 3}, 1. / 3, 0, reason, Claim::differs}};
  return rubber;
}

PressedHemisphere fingertip() {
  const std::vector<double> approaches{0.005, 0.01, 0.02, 0.05, 0.1}, one(approaches.size(), 1);
  return {approaches,
          {number("torsional stiffness over 16 E a^3 / 9, a = 0.07 R", "1", 1, 0.05,
                  "5 %: a tip that is pressed has strains of order a / R; 4 % was found"),
           {"torsional stiffness over 16 E a^3 / 9", "1", one, 1, 0, "strains of order a / R", Claim::differs},
           {"shear stiffness over 16 E a / 9", "1", one, 1, 0, "the tip between plate and base yields as well",
            Claim::differs}}};
}

std::vector<std::vector<double>> values_of(const std::vector<double>& forces, const std::vector<double>& radii) {
  std::vector<contact::MeasuredRadius> points;
  for (std::size_t k = 0; k < forces.size(); ++k) points.push_back({forces[k], radii[k]});
  const contact::PowerLaw law = contact::PowerLawFit::to(points).law;
  std::vector<double> over_hertz, over_power;
  for (const auto& [force, radius] : points) {
    over_hertz.push_back(radius / Hertz::under_force(contact::Paraboloid::of_radius(1), force, modulus).radius());
    over_power.push_back(radius / law.contact_radius(force));
  }
  return {forces, forces, radii, radii, over_hertz, over_power, {law.gamma}};
}

}  // namespace patchgrip::verification
