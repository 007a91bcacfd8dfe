#include <patchgrip/friction/flat_punch_disc.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

FlatPunchDisc FlatPunchDisc::of_radius(double radius) {
  return {contact::require_positive("radius", radius), 2.0 / 3, {}};
}

}  // namespace patchgrip::friction
