// Triangles between scattered points within an outline: for a pressure that is measured here and there.
//
// Constrained Delaunay triangulation (CGAL) of the points and the rings, not refined: no point is added. A point that
// lies on a ring, to 1e-9 of the outline's size, divides its edge or takes the place of its vertex.
//
// The nodes are the points in their order, then the vertices that no point takes the place of. There the pressure of a
// smooth contact falls to 0; where it ends in a step, points on the rim say so:
//
//     std::vector<double> pressures = ...;  // of the points
//     const Triangulation mesh = triangulate_between(points, outer, holes);
//     pressures.resize(mesh.points.size(), 0);
//     const PressureMesh patch = PressureMesh::linear(mesh, pressures);
//
// Domain   rings as polygon.h takes them; points within them, no two the same; points times vertices at most 2^32.
// Units    [m].
// Throws   std::invalid_argument, naming point, ring or vertex.
#pragma once

#include <vector>

#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>

namespace patchgrip::friction {

Triangulation triangulate_between(const std::vector<Point>& points, const std::vector<Point>& outer,
                                  const std::vector<std::vector<Point>>& holes);

}  // namespace patchgrip::friction
