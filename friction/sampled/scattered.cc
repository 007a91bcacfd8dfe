#include <patchgrip/friction/sampled/scattered.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/polygon_rings.h>

namespace patchgrip::friction {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

enum class Side : std::uint8_t { unknown, within, outside };
constexpr std::size_t no_node = ~std::size_t{0};

using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Faces =
    CGAL::Triangulation_face_base_with_info_2<Side, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Delaunay =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>>;
using Ring = std::vector<std::size_t>;  // of nodes

constexpr double on_the_rim = 1e-9;  // of the outline's diagonal
constexpr double most_pairs = 0x1p32;

[[noreturn]] void refuse(const std::vector<Point>& points, std::size_t i, std::string_view rule) {
  std::ostringstream what;
  what << "points[" << i << "] = [" << points[i].x << ", " << points[i].y << "] is not allowed: " << rule;
  throw std::invalid_argument(what.str());
}

double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

double diagonal(const std::vector<Point>& ring) {
  const auto [left, right] = std::ranges::minmax(ring, {}, &Point::x);
  const auto [low, high] = std::ranges::minmax(ring, {}, &Point::y);
  return std::hypot(right.x - left.x, high.y - low.y);
}

// Where along the edge p lies, if it is no farther from it than `reach`.
std::optional<double> along(const Point& from, const Point& to, const Point& p, double reach) {
  const double length = distance(from, to);
  const double x = (to.x - from.x) / length, y = (to.y - from.y) / length;
  const double ahead = (p.x - from.x) * x + (p.y - from.y) * y;
  const double beside = (p.y - from.y) * x - (p.x - from.x) * y;
  if (std::fabs(beside) <= reach && ahead > 0 && ahead < length) return ahead;
  return std::nullopt;
}

class Outline {
 public:
  Outline(const std::vector<Point>& points, double reach)
      : nodes_(points), on_ring_(points.size(), false), reach_(reach) {}

  // Its vertices and the points that lie on it, in their order.
  Ring add(const std::vector<Point>& vertices) {
    std::vector<std::size_t> corners;
    for (const Point& vertex : vertices) corners.push_back(corner(vertex));
    std::vector<std::vector<std::pair<double, std::size_t>>> between(vertices.size());
    for (std::size_t i = 0; i < on_ring_.size(); ++i) {
      for (std::size_t e = 0; e < vertices.size() && !on_ring_[i]; ++e) {
        const auto ahead = along(vertices[e], vertices[(e + 1) % vertices.size()], nodes_[i], reach_);
        if (!ahead) continue;
        between[e].emplace_back(*ahead, i);
        on_ring_[i] = true;
      }
    }
    Ring ring;
    for (std::size_t e = 0; e < vertices.size(); ++e) {
      ring.push_back(corners[e]);
      std::ranges::sort(between[e]);
      for (const auto& [ahead, node] : between[e]) ring.push_back(node);
    }
    return ring;
  }

  std::vector<Point> points_of(const Ring& ring) const {
    std::vector<Point> points;
    for (const std::size_t node : ring) points.push_back(nodes_[node]);
    return points;
  }

  const std::vector<Point>& nodes() const { return nodes_; }
  bool on_ring(std::size_t point) const { return on_ring_[point]; }

 private:
  // The nearest point within reach, or a node of its own.
  std::size_t corner(const Point& vertex) {
    std::size_t nearest = no_node;
    double least = reach_;
    for (std::size_t i = 0; i < on_ring_.size(); ++i) {
      const double d = distance(nodes_[i], vertex);
      if (on_ring_[i] || d > least) continue;
      nearest = i;
      least = d;
    }
    if (nearest == no_node) {
      nodes_.push_back(vertex);
      return nodes_.size() - 1;
    }
    on_ring_[nearest] = true;
    return nearest;
  }

  std::vector<Point> nodes_;
  std::vector<bool> on_ring_;  // of the given points
  double reach_;
};

// Marks what a walk from outside reaches, each ring that it crosses leading in or out again.
void mark_sides(Delaunay& triangles) {
  for (const auto face : triangles.all_face_handles()) face->info() = Side::unknown;
  std::vector<Delaunay::Face_handle> reached{triangles.infinite_face()};
  reached.front()->info() = Side::outside;
  while (!reached.empty()) {
    const auto face = reached.back();
    reached.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->info() != Side::unknown) continue;
      const bool crossed = triangles.is_constrained({face, i});
      next->info() = crossed == (face->info() == Side::outside) ? Side::within : Side::outside;
      reached.push_back(next);
    }
  }
}

void require_finite(const std::vector<Point>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) refuse(points, i, "coordinates must be finite");
  }
}

void require_few(const std::vector<Point>& points, const std::vector<Point>& outer,
                 const std::vector<std::vector<Point>>& holes) {
  std::size_t vertices = outer.size();
  for (const auto& hole : holes) vertices += hole.size();
  const auto count = static_cast<double>(points.size());
  if (count * static_cast<double>(vertices) > most_pairs) {
    contact::refuse("points", count, "their number times that of the vertices must be at most 2^32");
  }
}

// Rings of nodes, outer ring first, checked as those of polygon.h.
std::vector<Ring> divided_rings(Outline& outline, const std::vector<Point>& outer,
                                const std::vector<std::vector<Point>>& holes) {
  std::vector<Ring> rings{outline.add(outer)};
  std::vector<std::vector<Point>> openings;
  for (const auto& hole : holes) openings.push_back(outline.points_of(rings.emplace_back(outline.add(hole))));
  (void)oriented_rings(outline.points_of(rings[0]), openings);
  return rings;
}

void require_within(const std::vector<Point>& points, const Outline& outline, const std::vector<Ring>& rings) {
  std::vector<CGAL::Polygon_2<Kernel>> polygons;
  for (const Ring& ring : rings) {
    auto& polygon = polygons.emplace_back();
    for (const Point& p : outline.points_of(ring)) polygon.push_back({p.x, p.y});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (outline.on_ring(i)) continue;
    const Kernel::Point_2 p(points[i].x, points[i].y);
    if (!polygons[0].has_on_bounded_side(p)) refuse(points, i, "must lie within the vertices of the outline");
    for (std::size_t h = 1; h < polygons.size(); ++h) {
      if (polygons[h].has_on_bounded_side(p)) {
        refuse(points, i, "must lie outside of holes[" + std::to_string(h - 1) + "]");
      }
    }
  }
}

std::vector<Delaunay::Vertex_handle> insert(Delaunay& triangles, const std::vector<Point>& nodes) {
  std::vector<Delaunay::Vertex_handle> handles;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto near = handles.empty() ? Delaunay::Face_handle() : handles.back()->face();
    const auto vertex = triangles.insert({nodes[i].x, nodes[i].y}, near);
    if (triangles.number_of_vertices() == i) {
      refuse(nodes, i, "is the same as points[" + std::to_string(vertex->info()) + "]");
    }
    vertex->info() = i;
    handles.push_back(vertex);
  }
  return handles;
}

}  // namespace

Triangulation triangulate_between(const std::vector<Point>& points, const std::vector<Point>& outer,
                                  const std::vector<std::vector<Point>>& holes) {
  (void)oriented_rings(outer, holes);
  require_finite(points);
  require_few(points, outer, holes);
  Outline outline(points, on_the_rim * diagonal(outer));
  const std::vector<Ring> rings = divided_rings(outline, outer, holes);
  require_within(points, outline, rings);

  Delaunay triangles;
  const auto vertices = insert(triangles, outline.nodes());
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      triangles.insert_constraint(vertices[ring[i]], vertices[ring[(i + 1) % ring.size()]]);
    }
  }
  mark_sides(triangles);

  Triangulation mesh{outline.nodes(), {}};
  for (const auto face : triangles.finite_face_handles()) {
    if (face->info() != Side::within) continue;
    mesh.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return mesh;
}

}  // namespace patchgrip::friction
