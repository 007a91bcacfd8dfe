#include <patchgrip/friction/sampled/triangulate.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/polygon_rings.h>

namespace patchgrip::friction {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertices = CGAL::Triangulation_vertex_base_2<Kernel>;
using Faces = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Delaunay>;
using Rings = std::vector<std::vector<kernels::Vertex>>;

// sin^2 of the least angle for which the refinement is known to end.
constexpr double least_sine_squared = 0.125;
constexpr double most_squares = 0x1p20;

double area_of(const Rings& rings) {
  double twice = 0;
  for (const auto& ring : rings) {
    const auto& [x0, y0] = ring[0];
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      twice += (ring[i].x - x0) * (ring[i + 1].y - y0) - (ring[i].y - y0) * (ring[i + 1].x - x0);
  }
  return twice / 2;
}

// A point within a hole: the refinement leaves out what it reaches from there without crossing a ring.
Kernel::Point_2 point_within(const std::vector<kernels::Vertex>& ring) {
  Delaunay triangles;
  CGAL::Polygon_2<Kernel> polygon;
  for (const auto& p : ring) polygon.push_back({p.x, p.y});
  triangles.insert_constraint(polygon.vertices_begin(), polygon.vertices_end(), true);
  for (const auto face : triangles.finite_face_handles()) {
    const auto centre = CGAL::centroid(triangles.triangle(face));
    if (polygon.has_on_bounded_side(centre)) return centre;
  }
  return polygon[0];
}

}  // namespace

Triangulation triangulate(const std::vector<Point>& outer, const std::vector<std::vector<Point>>& holes,
                          double largest_edge) {
  contact::require_positive("largest_edge", largest_edge);
  const Rings rings = oriented_rings(outer, holes);
  const double least = std::sqrt(area_of(rings) / most_squares);
  if (largest_edge < least)
    contact::refuse("largest_edge", largest_edge, "must be at least " + std::to_string(least) + " for this area");

  Delaunay triangles;
  std::vector<Kernel::Point_2> within_holes;
  for (const auto& ring : rings) {
    std::vector<Kernel::Point_2> points;
    for (const auto& p : ring) points.emplace_back(p.x, p.y);
    triangles.insert_constraint(points.begin(), points.end(), true);
    if (&ring != &rings[0]) within_holes.push_back(point_within(ring));
  }
  CGAL::refine_Delaunay_mesh_2(triangles, within_holes.begin(), within_holes.end(),
                               Criteria(least_sine_squared, largest_edge));

  Triangulation mesh;
  std::map<Delaunay::Vertex_handle, std::size_t> index;
  for (const auto face : triangles.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    auto& corners = mesh.triangles.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const auto [at, added] = index.try_emplace(face->vertex(i), mesh.points.size());
      if (added) mesh.points.push_back({face->vertex(i)->point().x(), face->vertex(i)->point().y()});
      corners[static_cast<std::size_t>(i)] = at->second;
    }
  }
  return mesh;
}

}  // namespace patchgrip::friction
