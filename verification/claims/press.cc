#include <patchgrip/verification/claims/press.h>

#include <fmt/format.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <utility>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/sphere.h>

namespace patchgrip::verification {
namespace {

constexpr double radius = 1;                                               // a [m]
const auto material = contact::Material::elastic(1000 * (1 - 0.09), 0.3);  // E* = 1 kPa

const double rigid_modulus = contact::contact_modulus(material, contact::Material::rigid());

// A flat punch of radius x has <r^2> = 2 x^2 / 3.
template <contact::Profile P>
double rms_radius(const contact::AxisymmetricContact<P>& press) {
  const auto share = [&](double x) { return 2. / 3 * x * x * press.punch_load_density(x); };
  return std::sqrt(boost::math::quadrature::gauss<double, 60>::integrate(share, 0., press.radius()));
}

template <contact::Profile P>
PressedBody pressed(const P& profile, std::string height, double modulus = rigid_modulus) {
  const auto press = contact::AxisymmetricContact<P>::at_radius(profile, radius, modulus);
  const std::vector<double> radii{0.25, 0.5, 0.75};
  std::vector<double> pressures;
  for (const double r : radii) pressures.push_back(press.pressure(r));
  return {material,
          press.force(),
          press.approach(),
          std::move(height),
          [profile](double r) { return profile.height(r); },
          [press](double r) { return press.pressure(r); },
          radii,
          {number("approach", "m", press.approach(), 3.3e-4, "0.05 % in force is 0.033 % in approach"),
           number("rms radius of p", "m", rms_radius(press), 5e-4, "as the force"),
           number("p(0)", "Pa", press.pressure(0), 2e-3, "one node of a linear multiplier: h^2 of the pressure"),
           {"p(r), a/4 <= r <= 3a/4", "Pa", pressures, press.pressure(0), 5e-3,
            "of p(0); between nodes, off the axis and short of the kink at r = a"},
           pressure_distance(0.02, "the kink of p at r = a costs O(h): 1.8 % at 20 elements per radius")},
          ""};
}

}  // namespace

PressedBody pressed_paraboloid(double contact_modulus) {
  constexpr double R = 1000 * radius;
  return pressed(contact::Paraboloid::of_radius(R), fmt::format("sqr(X(1))/{}", 2 * R), contact_modulus);
}

std::vector<Quantity> paraboloid_at_approach() {
  const auto quantities = pressed_paraboloid().quantities;
  return {number("force", "N", pressed_paraboloid().force, 5e-4, "0.05 %: the mesh, and the penalty that gives way"),
          quantities[3]};
}

PressedBody pressed_sphere(double contact_over_sphere_radius) {
  const double R = radius / contact_over_sphere_radius;
  return pressed(contact::Sphere::of_radius(R), fmt::format("({0:.17g}-sqrt(sqr({0:.17g})-sqr(X(1))))", R));
}

PressedBody pressed_paraboloid_at_moved_points() {
  constexpr double R = 10 * radius;
  auto body = pressed(contact::Paraboloid::of_radius(R), fmt::format("sqr(X(1)+u(1))/{}", 2 * R));
  body.slope = fmt::format("(X(1)+u(1))/{}", R);
  for (auto& quantity : body.quantities) {
    quantity.claim = Claim::differs;
    quantity.reason =
        "small strains: the points under the body move inwards by u_r, which half-space theory leaves out";
  }
  return body;
}

}  // namespace patchgrip::verification
