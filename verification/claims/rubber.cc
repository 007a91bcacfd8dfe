#include <patchgrip/verification/claims/rubber.h>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/fingertip/power_law.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/sphere.h>

namespace patchgrip::verification {
namespace {

constexpr double modulus = 4;  // E* = 4 G for nu = 1/2

}  // namespace

RubberHemisphere rubber_hemisphere() {
  using Hertz = contact::AxisymmetricContact<contact::Paraboloid>;
  using Exact = contact::AxisymmetricContact<contact::Sphere>;
  const std::string reason = "large strains, and a base that is held";
  RubberHemisphere rubber{{0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4}, {}};
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
      {"radius over that of a power law", "1", std::vector<double>(hertz.size(), 1), 1, 0, reason, Claim::differs}};
  return rubber;
}

std::vector<double> over_power_law(std::span<const double> forces, std::span<const double> radii) {
  std::vector<contact::MeasuredRadius> points;
  for (std::size_t k = 0; k < forces.size(); ++k) points.push_back({forces[k], radii[k]});
  const contact::PowerLaw law = contact::PowerLawFit::to(points).law;
  std::vector<double> ratios;
  for (const auto& [force, radius] : points) ratios.push_back(radius / law.contact_radius(force));
  return ratios;
}

}  // namespace patchgrip::verification
