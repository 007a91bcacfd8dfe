// A measured surface, or any on a grid, pressed on a plane, a ball or a curved body: the numerical half-space.
#pragma once

#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/cli/steepness.h>
#include <patchgrip/contact/half_space/press.h>

namespace patchgrip::cli {

// Nothing where neither body is a height map.
const HeightMapFile* height_map_of(const BodyPair& pair);

// The pressure of the two bodies, told at `bodies` in the scene, one of them a height map; on cells `coarser` times as
// long and wide, heights averaged. Throws SceneError; std::runtime_error where it does not converge.
contact::PressedHalfSpace press_map(const BodyPair& pair, double contact_modulus, const StaticLoad& load,
                                    const Place& bodies, int coarser = 1);

// By its peak pressure, where the grid resolves that; else by what its cells carry at most.
Steepness steepness_of(const contact::PressedHalfSpace& pressed, double contact_modulus);

Pressed press_height_map(const BodyPair& pair, double contact_modulus, const PressScene& scene);

}  // namespace patchgrip::cli
