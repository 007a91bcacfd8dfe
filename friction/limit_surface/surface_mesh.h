// The limit surface as a closed triangle mesh, with the slip at every vertex.
//
// The directions of an icosahedron's edges halved `refinements` times, in (fx, fy, M / L) about the centroid of the
// pressure with L = M_0 the gauge's unit of moment (1 / g(0, 0, 1)), are scaled onto the surface, t / g(t). So
// triangles are of like size as drawn with moments per L, forces and moments reach 1 alike, and no vertex is crowded to
// a pole as with longitudes and latitudes. The surface is convex, so all triangles face outwards.
//
// The slip is normal to the surface, scaled to D = 1: t . twist = 1. What it turns about is the pole; a vertex with a
// pole at infinity is a pure translation.
//
// Units    loads per mu F_N: [1], [1], [m] about the origin of the contact frame.
// Error    worst_gap: largest width of the vertices' brackets, relative. Between vertices the mesh lies inside.
// Throws   std::invalid_argument unless refinements lies in [0, 7] (163842 vertices).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <patchgrip/friction/limit_surface/limit_surface.h>

namespace patchgrip::friction {

struct SurfaceVertex {
  Wrench load;
  Twist slip;

  std::optional<Pole> pole() const noexcept {
    if (slip.w == 0) return std::nullopt;
    return Pole{-slip.vy / slip.w, slip.vx / slip.w};
  }
};

using Triangle = std::array<std::uint32_t, 3>;

struct SurfaceMesh {
  std::vector<SurfaceVertex> vertices;
  std::vector<Triangle> triangles;  // counter-clockwise from outside in (fx, fy, m)
  double moment_scale = 0;          // L [m]
  double worst_gap = 0;
};

struct Sphere {
  std::vector<std::array<double, 3>> points;
  std::vector<Triangle> triangles;
};

Sphere icosphere(int refinements);

template <Patch P>
SurfaceMesh surface_mesh(const LimitSurface<P>& surface, int refinements) {
  const Sphere sphere = icosphere(refinements);
  const PressureMoments s = surface.patch().moments();
  SurfaceMesh mesh;
  mesh.triangles = sphere.triangles;
  mesh.moment_scale = 1 / surface.gauge({0, 0, 1}).value;
  for (const auto& [x, y, z] : sphere.points) {
    const Wrench t{x, y, mesh.moment_scale * z + (s.x * y - s.y * x)};
    const Gauge g = surface.gauge(t);
    mesh.vertices.push_back({{t.fx / g.value, t.fy / g.value, t.m / g.value}, g.twist});
    mesh.worst_gap = std::max(mesh.worst_gap, (g.upper - g.lower) / g.value);
  }
  return mesh;
}

}  // namespace patchgrip::friction
