// Grids, meshes and motions that sampled patches are tried on.
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {

using testing::log_uniform;
using testing::uniform;

template <class Pressure>
PressureCells sampled_cells(std::size_t nx, std::size_t ny, double dx, double dy, double x0, double y0,
                            const Pressure& pressure) {
  PressureCells cells{nx, ny, dx, dy, x0, y0, {}};
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i)
      cells.pressures.push_back(
          pressure(x0 + (static_cast<double>(i) + 0.5) * dx, y0 + (static_cast<double>(j) + 0.5) * dy));
  }
  return cells;
}

// Corners of a grid of nx x ny quadrilaterals on [0, 1] x [0, height], shaken by up to `shake` of a side, each cut in
// two, every other one clockwise.
inline Triangulation shaken_mesh(std::size_t nx, std::size_t ny, double height, double shake, std::mt19937_64& engine) {
  Triangulation mesh;
  for (std::size_t j = 0; j <= ny; ++j) {
    for (std::size_t i = 0; i <= nx; ++i) {
      const double x = static_cast<double>(i) + uniform(engine, -shake, shake);
      const double y = static_cast<double>(j) + uniform(engine, -shake, shake);
      mesh.points.push_back({x / static_cast<double>(nx), height * y / static_cast<double>(ny)});
    }
  }
  for (std::size_t j = 0; j < ny; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      const std::size_t a = j * (nx + 1) + i, b = a + nx + 1;
      mesh.triangles.push_back({a, a + 1, b});
      mesh.triangles.push_back({a + 1, b, b + 1});
    }
  }
  return mesh;
}

template <class Pressure>
std::vector<double> nodal(const Triangulation& mesh, const Pressure& pressure) {
  std::vector<double> p;
  for (const Point& point : mesh.points) p.push_back(pressure(point.x, point.y));
  return p;
}

inline Twist motion_about(double x, double y, std::mt19937_64& engine) {
  const double spin = (engine() % 2 == 0 ? 1 : -1) * log_uniform(engine, 1e-3, 1e3);
  return twist_about({x, y}, spin);
}

// A pole within some radii of the centroid, up to 1e8 of them away, or at infinity.
template <class P>
Twist random_motion(const P& patch, std::mt19937_64& engine) {
  const PressureMoments s = patch.moments();
  const double a = patch.area_radius();
  const double angle = uniform(engine, -std::numbers::pi, std::numbers::pi);
  const auto kind = engine() % 8;
  if (kind == 0) return {std::cos(angle), std::sin(angle), 0};
  const double r = a * (kind == 1   ? log_uniform(engine, 1e-12, 1)
                        : kind <= 3 ? log_uniform(engine, 2, 1e8)
                                    : uniform(engine, 0, 3));
  return motion_about(s.x + r * std::cos(angle), s.y + r * std::sin(angle), engine);
}

}  // namespace patchgrip::friction
