// A round contact under the load of a scene.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <stdexcept>
#include <utility>

#include <patchgrip/cli/press/press_scene.h>
#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/sphere.h>

namespace patchgrip::cli {

// 1 - a/R to which press lets a sphere sink in. Closer to the equator pressure and displacement change within what is
// left of the digits of r, and the loads are beyond any theory of half-spaces by orders of magnitude.
constexpr double least_of_sphere = 1e-9;

template <contact::Profile P>
contact::AxisymmetricContact<P> pressed_by(P profile, const StaticLoad& load, double modulus) {
  using Contact = contact::AxisymmetricContact<P>;
  switch (load.kind) {
    case LoadKind::normal_force:
      return Contact::under_force(std::move(profile), load.value, modulus);
    case LoadKind::approach:
      return Contact::at_approach(std::move(profile), load.value, modulus);
    default:
      return Contact::at_radius(std::move(profile), load.value, modulus);
  }
}

// Throws std::invalid_argument for what the library does not allow, and for a sphere that sinks in to its equator.
template <contact::Profile P>
contact::AxisymmetricContact<P> loaded(P profile, const StaticLoad& load, double modulus) {
  auto contact = pressed_by(std::move(profile), load, modulus);
  if constexpr (std::same_as<P, contact::Sphere>) {
    if (contact.circle().one_minus_ratio() < least_of_sphere) {
      const double deepest = (1 - least_of_sphere) * contact.profile().radius();
      const auto limit = contact::AxisymmetricContact<P>::at_radius(contact.profile(), deepest, modulus);
      throw std::invalid_argument(
          fmt::format("press lets a sphere sink in to a/R = 1 - {:g}, approach {:.6g} m, normal_force {:.6g} N",
                      least_of_sphere, limit.approach(), limit.force()));
    }
  }
  return contact;
}

}  // namespace patchgrip::cli
