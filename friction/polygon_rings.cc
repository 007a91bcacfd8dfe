#include <patchgrip/friction/polygon_rings.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/intersections.h>

namespace patchgrip::friction {
namespace {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Ring = CGAL::Polygon_2<Exact>;

[[noreturn]] void refuse(const std::string& ring, const std::string& what, const std::string& rule) {
  throw std::invalid_argument(ring + " " + what + ": " + rule);
}

Ring simple_ring(const std::string& name, const std::vector<Point>& points) {
  if (points.size() < 3) {
    refuse(name, "has " + std::to_string(points.size()) + " vertices", "a ring needs at least 3");
  }
  Ring ring;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) {
      refuse(name,
             "vertex " + std::to_string(i) + " = [" + std::to_string(points[i].x) + ", " + std::to_string(points[i].y) +
                 "]",
             "coordinates must be finite");
    }
    ring.push_back({points[i].x, points[i].y});
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    if (ring[i] == ring[next]) {
      refuse(name, "vertices " + std::to_string(i) + " and " + std::to_string(next) + " coincide",
             "each edge must have a length");
    }
  }
  if (!ring.is_simple())
    refuse(name, "crosses or touches itself", "the edges of a ring may meet only at common vertices");
  if (ring.orientation() == CGAL::COLLINEAR) refuse(name, "encloses no area", "its vertices must not lie on one line");
  return ring;
}

bool touch(const Ring& a, const Ring& b) {
  for (auto e = a.edges_begin(); e != a.edges_end(); ++e) {
    for (auto f = b.edges_begin(); f != b.edges_end(); ++f) {
      if (CGAL::do_intersect(*e, *f)) return true;
    }
  }
  return false;
}

std::vector<kernels::Vertex> oriented(Ring ring, CGAL::Orientation orientation) {
  if (ring.orientation() != orientation) ring.reverse_orientation();
  std::vector<kernels::Vertex> result;
  for (const auto& p : ring.container()) result.push_back({p.x(), p.y()});
  return result;
}

}  // namespace

std::vector<std::vector<kernels::Vertex>> oriented_rings(const std::vector<Point>& outer,
                                                         const std::vector<std::vector<Point>>& holes) {
  std::vector<Ring> rings{simple_ring("vertices", outer)};
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const std::string name = "holes[" + std::to_string(i) + "]";
    Ring hole = simple_ring(name, holes[i]);
    if (touch(hole, rings[0]) || rings[0].bounded_side(hole[0]) != CGAL::ON_BOUNDED_SIDE) {
      refuse(name, "leaves or touches the outer ring", "a hole must lie inside");
    }
    for (std::size_t j = 1; j < rings.size(); ++j) {
      if (touch(hole, rings[j]) || rings[j].bounded_side(hole[0]) == CGAL::ON_BOUNDED_SIDE ||
          hole.bounded_side(rings[j][0]) == CGAL::ON_BOUNDED_SIDE) {
        refuse(name, "meets holes[" + std::to_string(j - 1) + "]", "holes must be disjoint");
      }
    }
    rings.push_back(std::move(hole));
  }
  std::vector<std::vector<kernels::Vertex>> result{oriented(rings[0], CGAL::COUNTERCLOCKWISE)};
  for (std::size_t j = 1; j < rings.size(); ++j) result.push_back(oriented(rings[j], CGAL::CLOCKWISE));
  return result;
}

}  // namespace patchgrip::friction
