#include <patchgrip/friction/hertz_disc.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

HertzDisc HertzDisc::of_radius(double radius) { return {contact::require_positive("radius", radius), 0.4, {}}; }

}  // namespace patchgrip::friction
