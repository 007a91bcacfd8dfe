// The limit surface as a mesh: one point for each of a net of slip directions, which are its outward normals.
//
//     t = R grad D(v),   v = (cos b cos a, cos b sin a, sin b / L) about the centroid of the pressure
//
// with meridians of constant a and parallels of constant b; R = mu F_N, or 1 where friction is not given. b = pi/2 and
// -pi/2 are pure rotations about the centroid, b = 0 the translations, whose poles lie at infinity.
//
// Cheap and exact to rounding, as no gauge is asked; friction/limit_surface/surface_mesh.h spreads its vertices evenly
// over the loads instead.
//
// Units    wrench [N], [N], [N m] (per unit R: [1], [1], [m]); L [m].
// Error    of each point as friction/patch.h: bounds on force and moment.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

struct LimitPoint {
  friction::BoundedWrench wrench;
  friction::Twist slip;  // normal of the surface in (fx, fy, m)
};

struct LimitMesh {
  // Corners of a cell, seen from outside counter-clockwise; next to a pure rotation the last one repeats.
  using Cell = std::array<std::size_t, 4>;

  std::size_t at(int parallel, int meridian) const noexcept {
    if (parallel == 0) return 0;
    if (parallel == parallels) return points.size() - 1;
    return 1 + static_cast<std::size_t>((parallel - 1) * meridians + (meridian % meridians));
  }

  Cell cell(int parallel, int meridian) const noexcept {
    const std::size_t upper = at(parallel, meridian);
    const std::size_t lower = at(parallel + 1, meridian);
    if (parallel == 0) return {upper, lower, at(1, meridian + 1), upper};
    if (parallel + 1 == parallels) return {upper, lower, at(parallel, meridian + 1), upper};
    return {upper, lower, at(parallel + 1, meridian + 1), at(parallel, meridian + 1)};
  }

  // Where the pole of a slip is, d from the centroid: d / (d + i), i the radius of gyration. 0 in the centroid, 1 at
  // infinity.
  double pole_share(const friction::Twist& v) const noexcept {
    const double speed = std::hypot(v.vx - v.w * moments.y, v.vy + v.w * moments.x);
    return speed / (speed + std::sqrt(moments.polar) * std::fabs(v.w));
  }

  std::vector<LimitPoint> points;
  int meridians, parallels;
  double length;                      // L [m]
  friction::PressureMoments moments;  // of the pressure
};

template <friction::Patch P>
LimitMesh mesh_of(const P& patch, double resistance, double length, int meridians, int parallels) {
  LimitMesh mesh{{}, meridians, parallels, length, patch.moments()};
  const auto add = [&](double along, double across, double spin) {
    const double w = spin / length;
    // The velocity of the frame's origin; that of the centroid is (along, across).
    const friction::Twist v{along + w * mesh.moments.y, across - w * mesh.moments.x, w};
    friction::BoundedWrench t = patch.bounded_gradient(v);
    const double unit = 0x1p-53 * resistance;
    t.force_error = resistance * t.force_error + unit * std::hypot(t.value.fx, t.value.fy);
    t.moment_error = resistance * t.moment_error + unit * std::fabs(t.value.m);
    t.value = {resistance * t.value.fx, resistance * t.value.fy, resistance * t.value.m};
    mesh.points.push_back({t, v});
  };
  add(0, 0, 1);
  for (int i = 1; i < parallels; ++i) {
    const double b = std::numbers::pi * (0.5 - static_cast<double>(i) / parallels);
    const double spin = 2 * i == parallels ? 0 : std::sin(b);
    for (int j = 0; j < meridians; ++j) {
      const double a = 2 * std::numbers::pi * j / meridians;
      add(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), spin);
    }
  }
  add(0, 0, -1);
  return mesh;
}

}  // namespace patchgrip::cli
