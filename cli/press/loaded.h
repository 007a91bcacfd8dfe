// A round contact under the load of a scene.
#pragma once

#include <utility>

#include <patchgrip/cli/press/press_scene.h>
#include <patchgrip/contact/axisymmetric.h>

namespace patchgrip::cli {

template <contact::Profile P>
contact::AxisymmetricContact<P> loaded(P profile, const StaticLoad& load, double modulus) {
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

}  // namespace patchgrip::cli
