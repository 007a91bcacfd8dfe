// Any patch moved in the contact plane: its own origin at (x, y) of the contact frame, axes parallel.
//
//     D(vx, vy, w) = D_patch(vx - w y, vy + w x, w),    moment = m_patch + x fy - y fx
//
// The velocity at the patch's own origin is formed with one rounding per component (fused multiply-add), and a bound on
// what even that does to force and moment is added: it is a pole moved by a rounding, H dv with the patch's own
// Hessian.
//
// Units    x, y [m].
// Error    carried; measured in tests/friction/placed_test.cc.
// Throws   std::invalid_argument unless x and y are finite.
#pragma once

#include <cmath>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

template <Patch P>
class Placed {
 public:
  Placed(P patch, double x, double y)
      : patch_(std::move(patch)),
        x_(contact::require_finite("centre_x", x)),
        y_(contact::require_finite("centre_y", y)) {}

  double dissipation(const Twist& v) const noexcept { return patch_.dissipation(local(v)); }

  Wrench gradient(const Twist& v) const noexcept { return moved(patch_.gradient(local(v))); }

  BoundedWrench bounded_gradient(const Twist& v) const noexcept {
    constexpr double unit = 0x1p-53;
    const Twist u = local(v);
    BoundedWrench g = patch_.bounded_gradient(u);
    const double speed = std::hypot(u.vx, u.vy);
    const double radius = patch_.area_radius();
    const double slope = speed + radius * std::fabs(u.w);
    // Moving v by a relative rounding moves force and moment by at most |H| |dv|, and H (|v| + a |w|) <= 16 but for a
    // ring whose rim the pole meets closer than doubles tell.
    const double shift = slope > 0 ? 16 * unit * speed / slope : 0;
    const double force = std::hypot(g.value.fx, g.value.fy);
    const double arm = std::fabs(x_) + std::fabs(y_);
    g.force_error += shift;
    g.moment_error += shift * radius + arm * (g.force_error + 3 * unit * force);
    g.value = moved(g.value);
    g.moment_error += 2 * unit * std::fabs(g.value.m);
    return g;
  }

  // With u = A v, A = [1 0 -y; 0 1 x; 0 0 1], the Hessian is A^T H A.
  Hessian hessian(const Twist& v) const {
    const Hessian h = patch_.hessian(local(v));
    const double xw = h.xw - y_ * h.xx + x_ * h.xy;
    const double yw = h.yw - y_ * h.xy + x_ * h.yy;
    return {h.xx, h.xy, xw, h.yy, yw, h.ww - y_ * (h.xw + xw) + x_ * (h.yw + yw)};
  }

  PressureMoments moments() const noexcept {
    const PressureMoments s = patch_.moments();
    return {s.x + x_, s.y + y_, s.polar};
  }

  double area_radius() const noexcept { return patch_.area_radius(); }
  const P& patch() const noexcept { return patch_; }
  double x() const noexcept { return x_; }
  double y() const noexcept { return y_; }

 private:
  Twist local(const Twist& v) const noexcept { return {std::fma(-v.w, y_, v.vx), std::fma(v.w, x_, v.vy), v.w}; }

  Wrench moved(const Wrench& g) const noexcept { return {g.fx, g.fy, g.m + (x_ * g.fy - y_ * g.fx)}; }

  P patch_;
  double x_, y_;  // [m]
};

}  // namespace patchgrip::friction
