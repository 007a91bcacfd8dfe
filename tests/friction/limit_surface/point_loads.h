// Pressures without an area: point loads, on a line or not, where limit surfaces have facets and ridges.
#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

struct PointLoad {
  double x, y, share;
};

// D = sum of share |v_P|.
class PointLoads {
 public:
  explicit PointLoads(std::vector<PointLoad> loads) : loads_(std::move(loads)) {}

  double dissipation(const Twist& v) const noexcept { return power(gradient(v), v); }

  Wrench gradient(const Twist& v) const noexcept {
    Wrench g;
    for (const PointLoad& p : loads_) {
      const double x = v.vx - v.w * p.y, y = v.vy + v.w * p.x, speed = std::hypot(x, y);
      if (speed == 0) continue;
      g.fx += p.share * x / speed;
      g.fy += p.share * y / speed;
      g.m += p.share * (p.x * y - p.y * x) / speed;
    }
    return g;
  }

  // What rounding of v_P leaves of its direction is not known: all of a load is, next to it.
  BoundedWrench bounded_gradient(const Twist& v) const noexcept {
    constexpr double unit = 0x1p-53;
    BoundedWrench g{gradient(v)};
    for (const PointLoad& p : loads_) {
      const double x = v.vx - v.w * p.y, y = v.vy + v.w * p.x, speed = std::hypot(x, y);
      if (speed == 0) continue;
      const double terms = std::hypot(v.vx, v.vy) + std::fabs(v.w) * std::hypot(p.x, p.y);
      const double error = p.share * std::min(2.0, unit * (2 * terms / speed + 4));
      g.force_error += error;
      g.moment_error += std::hypot(p.x, p.y) * error;
    }
    return g;
  }

  Hessian hessian(const Twist& v) const {
    Hessian h;
    for (const PointLoad& p : loads_) {
      const double x = v.vx - v.w * p.y, y = v.vy + v.w * p.x, speed = std::hypot(x, y);
      if (speed == 0) throw std::domain_error("twist has its pole on a point load");
      const double k = p.share / (speed * speed * speed);
      const double q[3] = {-y, x, p.y * y + p.x * x};
      h.xx += k * q[0] * q[0], h.xy += k * q[0] * q[1], h.xw += k * q[0] * q[2];
      h.yy += k * q[1] * q[1], h.yw += k * q[1] * q[2], h.ww += k * q[2] * q[2];
    }
    return h;
  }

  PressureMoments moments() const noexcept {
    PressureMoments s;
    for (const PointLoad& p : loads_) s.x += p.share * p.x, s.y += p.share * p.y;
    for (const PointLoad& p : loads_) s.polar += p.share * (std::pow(p.x - s.x, 2) + std::pow(p.y - s.y, 2));
    return s;
  }

  double area_radius() const noexcept { return std::sqrt(moments().polar); }

 private:
  std::vector<PointLoad> loads_;
};

}  // namespace patchgrip::friction
