// Two triangles of a mesh that lie over each other in the plane: a fold, a second sheet, a piece that comes twice.
//
// Convex shapes are apart where the normal of one of their edges says so. How deep two triangles lie in each other is
// the least way along such a normal that parts them; a node that is rounded and so not quite on the edge of its
// neighbour is forgiven, to `overlap_tolerance` of the least height of the two triangles.
//
// Domain   triangles in either orientation; those without area lie over none.
// Cost     n log n, and a test of each pair whose boxes along x and y meet: some ten a triangle, in a fan of m slivers
//          about m^2 / 8.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include <patchgrip/friction/sampled/pressure_mesh.h>

namespace patchgrip::friction {

constexpr double overlap_tolerance = 1e-3;

// Indices of two such triangles, the lower first; nothing where there are none.
std::optional<std::pair<std::size_t, std::size_t>> overlapping_triangles(const Triangulation& mesh);

}  // namespace patchgrip::friction
