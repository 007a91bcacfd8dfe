// The rings of a polygonal patch, checked: simple, holes inside and disjoint, the interior to the left of every edge.
//
// Exact predicates (CGAL), so a patch is refused or accepted for what its coordinates say, not for rounding.
// Throws   std::invalid_argument, naming ring and vertex.
#pragma once

#include <vector>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/friction/polygon.h>

namespace patchgrip::friction {

// Outer ring first and counter-clockwise, then the holes, clockwise.
std::vector<std::vector<kernels::Vertex>> oriented_rings(const std::vector<Point>& outer,
                                                         const std::vector<std::vector<Point>>& holes);

}  // namespace patchgrip::friction
