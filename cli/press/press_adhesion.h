// Two balls, hollows or planes that attract each other.
#pragma once

#include <patchgrip/cli/press/pressed.h>

namespace patchgrip::cli {

Pressed press_adhesive(double relative_radius, double contact_modulus, const PressScene& scene);

}  // namespace patchgrip::cli
