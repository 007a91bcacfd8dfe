// Contacts, forces and the escape of a grasp as vectors for other programs.
#pragma once

#include <string>

#include <patchgrip/cli/grasp/grasp_answer.h>

namespace patchgrip::cli {

// Legacy VTK PolyData: a point at each contact, with its outward normal [1], the force on the object [N] where the
// first load is held, and its velocity in the escape twist of the first load.
std::string to_vtk(const GraspAnswer& answer, const GraspScene& scene);

}  // namespace patchgrip::cli
