// Random patches of every kind, moved and turned.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/tests/friction/bounds/framed_patch.h>
#include <patchgrip/tests/friction/bounds/polygon_ring.h>
#include <patchgrip/tests/friction/ellipse_reference.h>
#include <patchgrip/tests/friction/polygon_reference.h>

namespace patchgrip::friction::bounds {

inline FramedPatch framed_rectangle(double lx, double ly, const PlanarFrame& frame) {
  const auto reference =
      std::make_shared<PolygonReference>(std::vector<std::vector<kernels::Vertex>>{rectangle_ring(lx, ly)});
  const Gradient50 gradient = [reference](const auto& vx, const auto& vy, const auto& w) {
    return reference->gradient(vx, vy, w);
  };
  return {
      Placed(Rectangle::of_sides(lx, ly), frame), in_frame(gradient, frame), frame.x, frame.y, std::hypot(lx, ly) / 2,
      {frame.x, frame.y, reference->moments()[2]}};
}

inline FramedPatch draw_turned_rectangle(Draw& draw) {
  const double lx = draw.log_uniform(1e-3, 1e2), ly = lx * draw.log_uniform(1e-2, 1e2);
  return framed_rectangle(lx, ly, draw_frame(draw, 10 * std::hypot(lx, ly)));
}

// Of the power family of the exponent n.
template <class P>
FramedPatch draw_framed_disc(Draw& draw, double n) {
  static const auto source = std::make_shared<kernels::PowerFamily<Real50>>(n);
  const double a = draw.log_uniform(1e-2, 10);
  const PlanarFrame frame = draw_frame(draw, 10);
  const Gradient50 gradient = [a](const auto& vx, const auto& vy, const auto& w) {
    return round_wrench(*source, a, vx, vy, w);
  };
  return {Placed(P::of_radius(a), frame),
          in_frame(gradient, frame),
          frame.x,
          frame.y,
          a,
          {frame.x, frame.y, Real50(a) * a / (Real50(n) + 1.5)}};
}

inline FramedPatch draw_framed_point(Draw& draw) {
  const PlanarFrame frame = draw_frame(draw, 10);
  return {Placed(PointLoad{}, frame), in_frame(point_gradient, frame), frame.x, frame.y, 10, {frame.x, frame.y, 0}};
}

inline FramedPatch draw_framed_ellipse(Draw& draw, double least_aspect, double largest_aspect) {
  const double a = draw.log_uniform(1e-3, 1e2), aspect = draw.log_uniform(least_aspect, largest_aspect);
  const double b = draw.coin() ? a * aspect : a / aspect, major = std::max(a, b);
  const PlanarFrame frame = draw_frame(draw, 20 * major);
  const Gradient50 gradient = [reference = EllipseReference(a, b)](const auto& vx, const auto& vy, const auto& w) {
    return reference.gradient(vx, vy, w);
  };
  return {Placed(HertzEllipse::of_semi_axes(a, b), frame),        in_frame(gradient, frame), frame.x, frame.y, major,
          {frame.x, frame.y, (Real50(a) * a + Real50(b) * b) / 5}};
}

inline FramedPatch draw_polygon(Draw& draw, double aspect) {
  const double size = draw.log_uniform(1e-4, 1e1);
  const auto outer = draw_outline(draw, size, aspect);
  const auto reference = std::make_shared<PolygonReference>(std::vector<std::vector<kernels::Vertex>>{vertices(outer)});
  const Polygon patch = Polygon::uniform(outer);
  const PressureMoments s = patch.moments();
  const auto m = reference->moments();
  return {patch, [reference](const auto& vx, const auto& vy, const auto& w) { return reference->gradient(vx, vy, w); },
          s.x,   s.y,
          size,  {m[0], m[1], m[2]}};
}

// Two to six unlike parts; poles are drawn about one of them. Its law is Coulomb, of one coefficient.
inline FramedPatch draw_several(Draw& draw, bool with_points) {
  std::vector<Several::Part> parts;
  std::vector<Weighted50> weighted;
  FramedPatch one = draw_framed_disc<HertzDisc>(draw, 1);
  Real50 sum = 0, x = 0, y = 0, polar = 0;
  for (int i = draw.integer(2, 6); i > 0; --i) {
    const int kind = draw.integer(0, with_points ? 3 : 2);
    FramedPatch part = kind == 0   ? draw_framed_disc<HertzDisc>(draw, 1)
                       : kind == 1 ? draw_framed_disc<Ring>(draw, -0.5)
                       : kind == 2 ? draw_turned_rectangle(draw)
                                   : draw_framed_point(draw);
    const double F = draw.log_uniform(1e-2, 1e2), mu = draw.uniform(0.01, 2);
    const Real50 weight = Real50(F) * mu;
    parts.push_back({part.patch, F, mu});
    weighted.push_back({part.gradient, weight});
    sum += weight;
    x += weight * part.moments.x;
    y += weight * part.moments.y;
    polar += weight * (part.moments.polar + part.moments.x * part.moments.x + part.moments.y * part.moments.y);
    one = std::move(part);
  }
  x /= sum;
  y /= sum;
  return {Several::of_parts(parts),           weighted_mean(weighted), one.x, one.y, one.radius,
          {x, y, polar / sum - x * x - y * y}};
}

}  // namespace patchgrip::friction::bounds
