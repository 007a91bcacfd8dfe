// A picture of a grasp: contacts with their friction cones, the forces of the first answer, its load and its escape.
//
// Cones open into the object, by mu; forces and load are drawn to one scale, the escape to its own. A load's moment is
// drawn along its axis, to the scale of forces at the distance `length`.
#pragma once

#include <string>

#include <patchgrip/cli/grasp/grasp_answer.h>

namespace patchgrip::cli {

// SVG, 120 mm by 110 mm.
std::string picture_of(const GraspAnswer& answer, const GraspScene& scene);

}  // namespace patchgrip::cli
