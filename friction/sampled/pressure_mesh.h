// Friction of a pressure on triangles: linear between the nodes, or constant on each triangle.
//
// The distance integrals are exact for such pressures (sampled/edge_jumps.h), so a pole on a node, an edge or in a
// triangle is like any other. What remains is that the pressure is sampled: linear between the values of a smooth one
// it converges with order 2 in the length of the edges, of Hertz's sqrt(distance from the rim) with order 3/2
// (sampled_order_test.cc).
//
// Domain   triangles in either orientation, with an area; pressures finite and >= 0, at least one positive. Triangles
//          that overlap are not looked for here; overlapping_triangles() finds them, and the scene reader refuses them:
//          their pressures add up, and so do their areas in area_radius(). At most 2^24 triangles. One whose size is
//          below the rounding of its distance from the centre of pressure, 2^-53 of it, has no area as seen from there.
// Units    points [m]; pressures in any unit, they are scaled to the normal force 1.
// Error    sampled_patch.h
// Throws   std::invalid_argument, naming point, triangle or pressure.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/sampled/sampled_patch.h>

namespace patchgrip::friction {

struct Triangulation {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;  // indices of points
};

class PressureMesh : public SampledPatch {
 public:
  static constexpr std::size_t most_triangles = std::size_t{1} << 24;

  // A pressure per point, linear between them.
  static PressureMesh linear(const Triangulation& mesh, const std::vector<double>& nodal_pressures);
  // A pressure per triangle.
  static PressureMesh constant(const Triangulation& mesh, const std::vector<double>& pressures);

  // The same, not exact but faster for many triangles: tolerance in [1e-14, 1e-3].
  static PressureMesh linear_within(double tolerance, const Triangulation& mesh,
                                    const std::vector<double>& nodal_pressures);
  static PressureMesh constant_within(double tolerance, const Triangulation& mesh,
                                      const std::vector<double>& pressures);

 private:
  using SampledPatch::SampledPatch;
};

}  // namespace patchgrip::friction
