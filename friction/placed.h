// Any patch moved and turned in the contact plane: its own frame has its origin at (x, y) of the contact frame and its
// x axis at `angle` to the other's, counter-clockwise.
//
//     D(vx, vy, w) = D_patch(R^T (vx - w y, vy + w x), w),    R = [cos -sin; sin cos]
//     force = R force_patch,    moment = m_patch + x fy - y fx
//
// The velocity at the patch's own origin is formed with one rounding per component (fused multiply-add), and a bound on
// what even that and the turn do to force and moment is added: it is a pole moved by a few roundings, H dv with the
// patch's own Hessian. Without a turn (angle = 0) nothing is computed for it, and at the origin nothing at all.
//
// Units    x, y [m], angle [rad].
// Error    carried; measured in tests/friction/placed_test.cc.
// Throws   std::invalid_argument unless x, y and angle are finite.
// Fails    a point load bends D without limit. At its own origin it is told exactly where the pole is; inside several
//          patches that are moved as a whole it is not, and with the pole closer to it than some roundings the error is
//          not bounded: place such parts one by one (several.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

struct PlanarFrame {
  double x = 0;      // of its origin [m]
  double y = 0;      // [m]
  double angle = 0;  // of its x axis, counter-clockwise [rad]
};

template <Patch P>
class Placed {
 public:
  Placed(P patch, const PlanarFrame& frame)
      : patch_(std::move(patch)),
        x_(contact::require_finite("centre_x", frame.x)),
        y_(contact::require_finite("centre_y", frame.y)),
        angle_(contact::require_finite("angle", frame.angle)),
        cos_(std::cos(angle_)),
        sin_(std::sin(angle_)) {}

  Placed(P patch, double x, double y) : Placed(std::move(patch), PlanarFrame{x, y, 0}) {}

  double dissipation(const Twist& v) const noexcept { return patch_.dissipation(local(v)); }

  Wrench gradient(const Twist& v) const noexcept { return moved(turned(patch_.gradient(local(v)))); }

  BoundedWrench bounded_gradient(const Twist& v) const noexcept {
    const Twist u = local(v);
    return in_contact_frame(patch_.bounded_gradient(u), u);
  }

  // With u = A v, A = [1 0 -y; 0 1 x; 0 0 1], the Hessian is A^T H A, H turned.
  Hessian hessian(const Twist& v) const {
    const Hessian h = turned(patch_.hessian(local(v)));
    const double xw = h.xw - y_ * h.xx + x_ * h.xy;
    const double yw = h.yw - y_ * h.xy + x_ * h.yy;
    return {h.xx, h.xy, xw, h.yy, yw, h.ww - y_ * (h.xw + xw) + x_ * (h.yw + yw)};
  }

  PressureMoments moments() const noexcept {
    const PressureMoments s = patch_.moments();
    const Wrench c = turned(Wrench{s.x, s.y, 0});
    return {c.fx + x_, c.fy + y_, s.polar};
  }

  double area_radius() const noexcept { return patch_.area_radius(); }
  const P& patch() const noexcept { return patch_; }
  double x() const noexcept { return x_; }
  double y() const noexcept { return y_; }
  double angle() const noexcept { return angle_; }

  // The twist as the patch's own frame sees it.
  Twist local(const Twist& v) const noexcept {
    const double ux = std::fma(-v.w, y_, v.vx);
    const double uy = std::fma(v.w, x_, v.vy);
    if (!is_turned()) return {ux, uy, v.w};
    return {cos_ * ux + sin_ * uy, cos_ * uy - sin_ * ux, v.w};
  }

  // What the patch answers to that twist u, as the contact frame sees it, with the rounding of u and of the way back.
  BoundedWrench in_contact_frame(BoundedWrench g, const Twist& u) const noexcept {
    constexpr double unit = 0x1p-53;
    const double speed = std::hypot(u.vx, u.vy);
    const double radius = patch_.area_radius();
    const double lever = std::max(radius, std::sqrt(patch_.moments().polar));
    const double slope = speed + radius * std::fabs(u.w);
    // Moving v by a relative rounding moves force and moment by at most |H| |dv|, and H (|v| + a |w|) <= 16 but for a
    // ring whose rim the pole meets closer than doubles tell. A turn takes four roundings more: cosine and sine,
    // products, sum.
    const double roundings = is_turned() ? 5 : 1;
    const double shift = slope > 0 ? 16 * roundings * unit * speed / slope : 0;
    const double force = std::hypot(g.value.fx, g.value.fy);
    const double arm = std::fabs(x_) + std::fabs(y_);
    g.force_error += shift + (is_turned() ? 4 * unit * force : 0);
    g.moment_error += shift * lever + arm * (g.force_error + 3 * unit * force);
    g.value = moved(turned(g.value));
    g.moment_error += 2 * unit * std::fabs(g.value.m);
    return g;
  }

 private:
  bool is_turned() const noexcept { return angle_ != 0; }

  Wrench turned(const Wrench& g) const noexcept {
    if (!is_turned()) return g;
    return {cos_ * g.fx - sin_ * g.fy, sin_ * g.fx + cos_ * g.fy, g.m};
  }

  Wrench moved(const Wrench& g) const noexcept { return {g.fx, g.fy, g.m + (x_ * g.fy - y_ * g.fx)}; }

  Hessian turned(const Hessian& h) const noexcept {
    if (!is_turned()) return h;
    const double c = cos_, s = sin_;
    // R H and then (R H) R^T
    const double ax = c * h.xx - s * h.xy, ay = c * h.xy - s * h.yy;
    const double bx = s * h.xx + c * h.xy, by = s * h.xy + c * h.yy;
    return {c * ax - s * ay, s * ax + c * ay, c * h.xw - s * h.yw, s * bx + c * by, s * h.xw + c * h.yw, h.ww};
  }

  P patch_;
  double x_, y_;  // [m]
  double angle_;  // [rad]
  double cos_, sin_;
};

}  // namespace patchgrip::friction
