// Two triangles of a mesh that lie over each other in the plane: a fold, a second sheet, a piece that comes twice.
//
// Convex shapes are apart where the normal of one of their edges says so. How deep two triangles lie in each other is
// the least way along such a normal that parts them. A node that is rounded, and so not quite on the edge of its
// neighbour, is forgiven: a depth up to 1e-3 of the least height of the two triangles, or to 1e-6 of their longest
// edge, some roundings in single precision, which turn a sliver over.
//
// Domain   triangles in either orientation; those without area lie over none.
// Cost     n log n, and a test of each pair whose boxes along x and y meet: some ten a triangle; about m^2 / 8 in a fan
//          of m slivers, and as many in m layers of needles that lie askew to x and y, each in the boxes of all.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include <patchgrip/friction/sampled/pressure_mesh.h>

namespace patchgrip::friction {

// Indices of two such triangles, the lower first; nothing where there are none.
std::optional<std::pair<std::size_t, std::size_t>> overlapping_triangles(const Triangulation& mesh);

}  // namespace patchgrip::friction
