// Coulomb friction of point loads, added one by one:
//
//     grad D ~ sum of share_i (v_x, v_y, x_i v_y - y_i v_x) / |v|,    v = (vx - w y_i, vy + w x_i)
//
// A point at rest adds nothing.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

struct PointLoad {
  double x, y;   // [m]
  double share;  // of the normal force
};

class PointSum {
 public:
  explicit PointSum(std::vector<PointLoad> points) : points_(std::move(points)) {}

  friction::Wrench gradient(const friction::Twist& t) const noexcept {
    friction::Wrench sum;
    for (const PointLoad& p : points_) {
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
  std::vector<PointLoad> points_;
};

}  // namespace patchgrip::bench
