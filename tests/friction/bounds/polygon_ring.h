// Rings of vertices: random star-shaped ones, from round to needles, and rectangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/tests/friction/bounds/draw.h>

namespace patchgrip::friction::bounds {

inline std::vector<Point> draw_ring(Draw& draw, double cx, double cy, double size, double aspect, double turn) {
  const int n = draw.integer(3, 10);
  std::vector<Point> ring;
  for (int k = 0; k < n; ++k) {
    const double r = size * draw.uniform(0.5, 1);
    const double phi = 2 * std::numbers::pi * (k + draw.uniform(0, 0.8)) / n;
    const double x = r * std::cos(phi);
    const double y = aspect * r * std::sin(phi);
    ring.push_back({cx + x * std::cos(turn) - y * std::sin(turn), cy + x * std::sin(turn) + y * std::cos(turn)});
  }
  return ring;
}

// One of three lies away from the origin.
inline std::vector<Point> draw_outline(Draw& draw, double size, double aspect) {
  const double away = draw.integer(0, 2) == 0 ? 20 * size : 0;
  const double x = draw.uniform(-away, away), y = draw.uniform(-away, away), turn = draw.angle();
  return draw_ring(draw, x, y, size, aspect, turn);
}

inline std::vector<kernels::Vertex> rectangle_ring(double lx, double ly) {
  return {{-lx / 2, -ly / 2}, {lx / 2, -ly / 2}, {lx / 2, ly / 2}, {-lx / 2, ly / 2}};
}

inline std::vector<kernels::Vertex> vertices(const std::vector<Point>& ring, bool reverse = false) {
  std::vector<kernels::Vertex> result;
  for (const Point& p : ring) result.push_back({p.x, p.y});
  if (reverse) std::reverse(result.begin(), result.end());
  return result;
}

}  // namespace patchgrip::friction::bounds
