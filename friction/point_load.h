// Friction of a point load: the whole normal load at one point, the origin of its own frame (placed.h moves it).
//
//     D(v) = |(vx, vy)|,    grad D = ((vx, vy) / |(vx, vy)|, 0)                         (point friction, seed 4.31)
//
// The limit surface of a point is a disc: it bears no moment about itself. As a part of several patches (several.h) a
// point mass makes a flat facet; two of them, or a line, make ridges.
//
// Domain   every pole. With the pole on the point D has a kink: gradient() answers 0, the subgradient of least norm.
// Error    <= 3 units of 2^-53 of the force; tests/friction/point_load_test.cc.
// Fails    the Hessian is infinite with the pole on the point: hessian() throws std::domain_error there.
#pragma once

#include <cmath>
#include <stdexcept>
#include <vector>

#include <patchgrip/friction/point_shares.h>

namespace patchgrip::friction {

class PointLoad {
 public:
  double dissipation(const Twist& v) const noexcept { return std::hypot(v.vx, v.vy); }

  Wrench gradient(const Twist& v) const noexcept {
    const double speed = std::hypot(v.vx, v.vy);
    if (speed == 0) return {};
    return {v.vx / speed, v.vy / speed, 0};
  }

  BoundedWrench bounded_gradient(const Twist& v) const noexcept {
    const Wrench g = gradient(v);
    return {g, 3 * 0x1p-53 * std::hypot(g.fx, g.fy), 0};
  }

  Hessian hessian(const Twist& v) const {
    const double speed = std::hypot(v.vx, v.vy);
    if (speed == 0 && v.w == 0)
      throw std::domain_error("twist = 0 is not allowed: the Hessian of D exists only in motion");
    if (speed == 0) throw std::domain_error("twist has its pole on the point load: the Hessian of D is infinite there");
    const double ex = v.vx / speed;
    const double ey = v.vy / speed;
    return {ey * ey / speed, -ex * ey / speed, 0, ex * ex / speed, 0, 0};
  }

  PressureMoments moments() const noexcept { return {}; }
  double area_radius() const noexcept { return 0; }
  std::vector<PointShare> point_shares() const { return {{0, 0, 1}}; }
};

}  // namespace patchgrip::friction
