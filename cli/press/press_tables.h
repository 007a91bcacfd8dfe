// Tables that `patchgrip press` writes: the surface along a line, or the answers of a sweep.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <patchgrip/cli/press/press_scene.h>
#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/cli/table.h>

namespace patchgrip::cli {

// x, y, pressure, displacement and gap with their errors, then the pressures of the laws beside; of a contact on a grid
// every cell, unless the scene asks for a line.
Table surface_table(const PressScene& scene, const Pressed& pressed);

// At one value of the sweep. What is refused or does not converge says at which.
Pressed press_swept(const PressScene& scene, std::size_t index);

// The swept quantity, then every quantity of the answer with its error, then those of the laws beside. Warnings name
// their values; in the same words they are one. A value that has no answer (a pull beyond the pull-off) leaves the rest
// of its row empty, and a warning says how many are so and why the first is. Throws SceneError where no value has an
// answer: what was wrong with the first.
Table sweep_table(const PressScene& scene, std::vector<std::string>& warnings);

}  // namespace patchgrip::cli
