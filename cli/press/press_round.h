// Two bodies that touch in a circle: balls, and stamps of revolution on a plane.
#pragma once

#include <patchgrip/cli/press/pressed.h>

namespace patchgrip::cli {

Pressed press_balls(const BodyPair& pair, const PressScene& scene);
Pressed press_stamp(const BodyPair& pair, const PressScene& scene);

}  // namespace patchgrip::cli
