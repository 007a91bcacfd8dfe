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
// Error    of force and moment at the slip of each point: that of grad D (friction/patch.h), of R, of a shape that
//          follows from bodies (input_error.h), and the difference from half as many cells where the pressure is
//          computed on a grid. Bounds, but for the last, which is an estimate.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <patchgrip/cli/scene/contact_reader.h>
#include <patchgrip/contact/estimate.h>
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
    if (parallel == parallels) return 1 + static_cast<std::size_t>((parallels - 1) * meridians);
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

// Throws Interrupted.
LimitMesh mesh_of(const Contact& contact, const contact::Estimate& resistance, double length, int meridians,
                  int parallels);

}  // namespace patchgrip::cli
