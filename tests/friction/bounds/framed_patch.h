// A patch in a frame of its own, with its reference there; moments as seen from the contact frame.
#pragma once

#include <memory>
#include <vector>

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/friction/bounds/exact_friction.h>
#include <patchgrip/tests/friction/frame_reference.h>
#include <patchgrip/tests/friction/polygon_reference.h>

namespace patchgrip::friction::bounds {

struct FramedPatch {
  AnyPatch patch;
  Gradient50 gradient;
  double x, y, radius;
  Moments50 moments;
};

inline std::vector<kernels::Vertex> rectangle_ring(double lx, double ly) {
  return {{-lx / 2, -ly / 2}, {lx / 2, -ly / 2}, {lx / 2, ly / 2}, {-lx / 2, ly / 2}};
}

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

}  // namespace patchgrip::friction::bounds
