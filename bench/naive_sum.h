// The sum that most simulations use: a Hertz disc as n x n points, Coulomb friction at each.
//
//     grad D ~ sum p_i h^2 / F_N (v_x, v_y, x_i v_y - y_i v_x) / |v|,    v = (vx - w y_i, vy + w x_i),   h = 2 a / n
//
// the midpoint rule for (4.47) on the square around the disc. Cells whose midpoint lies outside are left out, the
// pressures are computed once.
//
// Error    about h^2 / a^2 in force and moment, more for poles at a midpoint, where the sum jumps.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

class NaiveSum {
 public:
  NaiveSum(double radius, int n) {
    const double h = 2 * radius / n;
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const double x = (column + 0.5) * h - radius;
        const double y = (row + 0.5) * h - radius;
        const double depth = 1 - (x * x + y * y) / (radius * radius);
        if (depth > 0)
          points_.push_back({x, y, 3 / (2 * std::numbers::pi * radius * radius) * std::sqrt(depth) * h * h});
      }
    }
  }

  friction::Wrench gradient(const friction::Twist& t) const noexcept {
    friction::Wrench sum;
    for (const Point& p : points_) {
      const double vx = t.vx - t.w * p.y;
      const double vy = t.vy + t.w * p.x;
      const double speed = std::sqrt(vx * vx + vy * vy);
      const double share = speed > 0 ? p.share / speed : 0;
      sum.fx += share * vx;
      sum.fy += share * vy;
      sum.m += share * (p.x * vy - p.y * vx);
    }
    return sum;
  }

 private:
  struct Point {
    double x, y;   // [m]
    double share;  // of the normal force
  };

  std::vector<Point> points_;
};

}  // namespace patchgrip::bench
