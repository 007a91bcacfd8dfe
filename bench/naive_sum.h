// The sum that most simulations use: a Hertz disc as n x n points, Coulomb friction at each (point_sum.h), the shares
//
//     p_i h^2 / F_N,   h = 2 a / n
//
// the midpoint rule for (4.47) on the square around the disc. Cells whose midpoint lies outside are left out, the
// pressures are computed once. The shares are those of the pressure as it stands: their sum is not quite 1, to which
// point_sum() of a zone (zone.h) scales them.
//
// Error    about h^2 / a^2 in force and moment, more for poles at a midpoint, where the sum jumps.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <patchgrip/bench/point_sum.h>

namespace patchgrip::bench {

class NaiveSum : public PointSum {
 public:
  NaiveSum(double radius, int n) : PointSum(points(radius, n)) {}

 private:
  static std::vector<PointLoad> points(double radius, int n) {
    std::vector<PointLoad> result;
    const double h = 2 * radius / n;
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const double x = (column + 0.5) * h - radius;
        const double y = (row + 0.5) * h - radius;
        const double depth = 1 - (x * x + y * y) / (radius * radius);
        if (depth > 0)
          result.push_back({x, y, 3 / (2 * std::numbers::pi * radius * radius) * std::sqrt(depth) * h * h});
      }
    }
    return result;
  }
};

}  // namespace patchgrip::bench
