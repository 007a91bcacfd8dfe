// A measured surface, or any on a grid, pressed on a plane, a ball or a curved body: the numerical half-space.
#pragma once

#include <patchgrip/cli/press/pressed.h>

namespace patchgrip::cli {

// Nothing where neither body is a height map. Throws SceneError for a file that cannot be read.
const HeightMapFile* height_map_of(const BodyPair& pair);

Pressed press_height_map(const BodyPair& pair, double contact_modulus, const PressScene& scene);

}  // namespace patchgrip::cli
