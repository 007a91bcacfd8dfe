// Triangles that fill a polygon with holes: what a pressure p(x, y) is sampled on.
//
// Constrained Delaunay triangulation of the rings, refined (Ruppert; CGAL) until no edge is longer than asked for and
// no angle is below asin(1/(2 sqrt 2)) = 20.7 degrees, unless the rings themselves have a smaller one.
//
// Domain   rings as polygon.h takes them; largest edge positive and finite, the area at most 2^20 squares of it.
// Units    [m].
// Throws   std::invalid_argument, naming ring, vertex or parameter.
#pragma once

#include <vector>

#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>

namespace patchgrip::friction {

Triangulation triangulate(const std::vector<Point>& outer, const std::vector<std::vector<Point>>& holes,
                          double largest_edge);

// p at every point, for PressureMesh::linear.
template <class Pressure>
std::vector<double> sample(const Triangulation& mesh, const Pressure& pressure) {
  std::vector<double> values;
  values.reserve(mesh.points.size());
  for (const Point& point : mesh.points) values.push_back(pressure(point.x, point.y));
  return values;
}

}  // namespace patchgrip::friction
