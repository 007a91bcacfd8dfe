// Rectangles and polygons, with holes, and down to needles.
#include <algorithm>
#include <cmath>

#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/friction/bounds/exact_friction.h>
#include <patchgrip/tests/friction/bounds/kind.h>
#include <patchgrip/tests/friction/bounds/polygon_ring.h>
#include <patchgrip/tests/friction/polygon_reference.h>

namespace patchgrip::friction::bounds {
namespace {

using kernels::Vertex;

// Poles are drawn next to edges and vertices, too.
template <class P>
Case polygon_case(Draw& draw, const P& patch, const std::vector<std::vector<Vertex>>& rings) {
  const PolygonReference reference(rings);
  const PressureMoments s = patch.moments();
  double radius = 0;
  for (const Vertex& p : rings[0]) radius = std::max(radius, std::hypot(p.x - s.x, p.y - s.y));
  const auto [twist, far] = draw_twist(draw, s.x, s.y, radius, [&](Draw& d) -> Pole {
    const auto& ring = rings[d.index(rings.size())];
    const std::size_t i = d.index(ring.size());
    const Vertex& p = ring[i];
    const Vertex& q = ring[(i + 1) % ring.size()];
    const double t = d.coin() ? 0 : d.uniform(0, 1);
    const double off = d.coin() ? 0 : radius * d.log_uniform(1e-16, 1e-6);
    return Pole{p.x + t * (q.x - p.x) + off, p.y + t * (q.y - p.y) + (d.coin() ? off : 0)};
  });
  const DrawnLaw drawn = draw_law(draw);
  const auto m = reference.moments();
  return judged(far, friction_wrench(drawn.law, drawn.normal_force, patch, twist),
                exact_friction(drawn, {m[0], m[1], m[2]}, reference.gradient(twist), twist));
}

Case rectangle(Draw& draw, double least_aspect, double largest_aspect) {
  const double lx = draw.log_uniform(1e-6, 1e2), aspect = draw.log_uniform(least_aspect, largest_aspect);
  const double ly = draw.coin() ? lx * aspect : lx / aspect;
  return polygon_case(draw, Rectangle::of_sides(lx, ly), {rectangle_ring(lx, ly)});
}

Case polygon(Draw& draw, double aspect) {
  const auto outer = draw_outline(draw, draw.log_uniform(1e-4, 1e1), aspect);
  return polygon_case(draw, Polygon::uniform(outer), {vertices(outer)});
}

Case polygon_with_hole(Draw& draw) {
  const double size = draw.log_uniform(1e-4, 1e1);
  const double aspect = draw.coin() ? 1 : draw.log_uniform(1e-2, 1);
  const double turn = draw.angle();
  std::vector<Point> outer, hole;
  do {
    outer = draw_ring(draw, 0, 0, size, aspect, turn);
    hole = draw_ring(draw, 0, 0, size * draw.uniform(0.05, 0.2), aspect, turn);
  } while (outer.size() < 6);
  return polygon_case(draw, Polygon::uniform(outer, {hole}), {vertices(outer), vertices(hole, true)});
}

}  // namespace

Kinds polygon_kinds() {
  return {{"rectangle", [](Draw& draw) { return rectangle(draw, 1, 1e2); }},
          {"needle_rectangle", [](Draw& draw) { return rectangle(draw, 1e3, 1e6); }},
          {"polygon", [](Draw& draw) { return polygon(draw, draw.coin() ? 1 : draw.log_uniform(1e-2, 1)); }},
          {"needle_polygon", [](Draw& draw) { return polygon(draw, draw.log_uniform(1e-6, 1e-3)); }},
          {"polygon_with_hole", polygon_with_hole}};
}

}  // namespace patchgrip::friction::bounds
