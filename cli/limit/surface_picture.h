// A picture of the limit surface: forces to the sides, moment up, coloured by the slip that is next, with the loads.
//
// The surface is convex, so what faces the viewer hides everything else. The moment is drawn as m / L. A load that
// slips is joined to the point of the surface that it passed; one that holds is drawn as the point in which its ray
// would leave. Loads bear their numbers, from 1, those of one mark together; where all places beside a mark would touch
// another number, they are left out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchgrip/cli/limit/limit_mesh.h>
#include <patchgrip/cli/limit/load_answer.h>

namespace patchgrip::cli {

constexpr std::size_t most_loads_drawn = 100;

struct PictureRequest {
  std::string title;
  double azimuth, elevation;       // of the viewer [rad]
  std::optional<double> capacity;  // mu F_N [N]; without it forces are drawn per mu F_N, and no loads
  std::vector<LoadAnswer> loads;   // at most most_loads_drawn; their numbers are their places
};

// SVG, 120 mm by 110 mm. Throws Interrupted.
std::string picture_of(const LimitMesh& mesh, const PictureRequest& request);

}  // namespace patchgrip::cli
