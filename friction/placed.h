// Any patch moved and turned in the contact plane: its own frame has its origin at (x, y) of the contact frame and its
// x axis at `angle` to the other's, counter-clockwise.
//
//     D(vx, vy, w) = D_patch(R^T (vx - w y, vy + w x), w),    R = [cos -sin; sin cos]
//     force = R force_patch,    moment = m_patch + x fy - y fx
//
// The velocity at the patch's own origin is rounded once: formed by a fused multiply-add and, where the patch is
// turned, turned in extended precision; so is the wrench on its way back. What that one rounding does to force and
// moment is H dv with the patch's own Hessian H, |dv| <= 2^-53 |v|, and is added to their bounds, twice because H
// changes on the way. No length of the patch would do for H: it is as large as 1 / (width |w|) in the narrowest part of
// a zone. Without a turn (angle = 0) nothing is computed for it.
//
// Units    x, y [m], angle [rad].
// Error    carried; measured in tests/friction/placed_test.cc.
// Throws   std::invalid_argument unless x, y and angle are finite.
// Fails    a point load bends D without limit. At its own origin it is told exactly where the pole is; inside several
//          patches that are moved as a whole it is not, and with the pole closer to it than some roundings the error is
//          not bounded: place such parts one by one (several.h).
#pragma once

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/hessian_beside.h>
#include <patchgrip/friction/point_shares.h>
#include <patchgrip/friction/stribeck_excess.h>

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
        cos_(std::cos(static_cast<long double>(angle_))),
        sin_(std::sin(static_cast<long double>(angle_))) {}

  Placed(P patch, double x, double y) : Placed(std::move(patch), PlanarFrame{x, y, 0}) {}

  double dissipation(const Twist& v) const noexcept { return patch_.dissipation(local(v)); }

  Wrench gradient(const Twist& v) const noexcept { return moved(patch_.gradient(local(v))); }

  BoundedWrench bounded_gradient(const Twist& v) const noexcept {
    const Twist u = local(v);
    BoundedWrench g = patch_.bounded_gradient(u);
    const Shift shift = shift_at(u);
    g.force_error += shift.force;
    g.moment_error += shift.moment;
    return in_contact_frame(g);
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
    const auto [x, y] = turned(s.x, s.y);
    return {static_cast<double>(x_ + x), static_cast<double>(y_ + y), s.polar};
  }

  double area_radius() const noexcept { return patch_.area_radius(); }

  // Those at the patch's own origin, and where it is not turned those whose place is a double.
  std::vector<PointShare> point_shares() const {
    std::vector<PointShare> shares = friction::point_shares(patch_);
    const auto exact = [](double a, double b) { return a + b - a == b && a + b - b == a; };
    std::erase_if(shares, [&](const PointShare& p) {
      return !(p.x == 0 && p.y == 0) && (is_turned() || !exact(x_, p.x) || !exact(y_, p.y));
    });
    for (PointShare& p : shares) p.x += x_, p.y += y_;
    return shares;
  }

  const P& patch() const noexcept { return patch_; }
  double x() const noexcept { return x_; }
  double y() const noexcept { return y_; }
  double angle() const noexcept { return angle_; }

  // The twist as the patch's own frame sees it, its velocity rounded.
  Twist local(const Twist& v) const noexcept {
    if (!is_turned()) return {std::fma(-v.w, y_, v.vx), std::fma(v.w, x_, v.vy), v.w};
    const long double ux = product_and_sum(-v.w, y_, v.vx), uy = product_and_sum(v.w, x_, v.vy);
    return {static_cast<double>(cos_ * ux + sin_ * uy), static_cast<double>(cos_ * uy - sin_ * ux), v.w};
  }

  // Of the velocity u = local(v): a turn takes eight roundings of extended precision.
  double rounding_of(const Twist& u) const noexcept {
    return (unit + (is_turned() ? 8 * fine_unit : 0)) * std::hypot(u.vx, u.vy);
  }

  // By how much the rounding of u = local(v) can move the patch's force and moment. The first is the mean of 1 / |u_P|
  // over the pressure times a length of velocity.
  struct Shift {
    double force = 0;   // [1]
    double moment = 0;  // [m]
  };
  Shift shift_at(const Twist& u) const noexcept {
    const double dv = rounding_of(u);
    if (!(dv > 0)) return {};
    const Hessian h = hessian_beside(patch_, u);
    return {2 * dv * (h.xx + h.yy), 2 * dv * std::hypot(h.xw, h.yw)};
  }

  // A wrench of the patch, bounded in its own frame, as the contact frame sees it, with the rounding of the way there.
  BoundedWrench in_contact_frame(BoundedWrench g) const noexcept {
    const double arm = std::hypot(x_, y_);
    g.moment_error += arm * g.force_error;
    const double force = std::hypot(g.value.fx, g.value.fy);
    if (is_turned()) g.force_error += (unit + 4 * fine_unit) * force;
    g.value = moved(g.value);
    if (arm > 0) g.moment_error += 8 * fine_unit * arm * force + unit * std::fabs(g.value.m);
    return g;
  }

 private:
  static constexpr double unit = 0x1p-53;
  static constexpr double fine_unit = static_cast<double>(std::numeric_limits<long double>::epsilon() / 2);

  struct FineVector {
    long double x, y;
  };

  bool is_turned() const noexcept { return angle_ != 0; }

  // a b + c, to two roundings of a long double however much it cancels.
  static long double product_and_sum(double a, double b, double c) noexcept {
    const double product = a * b;
    return (static_cast<long double>(c) + product) + std::fma(a, b, -product);
  }

  FineVector turned(double x, double y) const noexcept {
    if (!is_turned()) return {x, y};
    return {cos_ * x - sin_ * y, sin_ * x + cos_ * y};
  }

  Wrench moved(const Wrench& g) const noexcept {
    const FineVector f = turned(g.fx, g.fy);
    return {static_cast<double>(f.x), static_cast<double>(f.y), static_cast<double>(g.m + (x_ * f.y - y_ * f.x))};
  }

  Hessian turned(const Hessian& h) const noexcept {
    if (!is_turned()) return h;
    const auto c = static_cast<double>(cos_), s = static_cast<double>(sin_);
    // R H and then (R H) R^T
    const double ax = c * h.xx - s * h.xy, ay = c * h.xy - s * h.yy;
    const double bx = s * h.xx + c * h.xy, by = s * h.xy + c * h.yy;
    return {c * ax - s * ay, s * ax + c * ay, c * h.xw - s * h.yw, s * bx + c * by, s * h.xw + c * h.yw, h.ww};
  }

  P patch_;
  double x_, y_;  // [m]
  double angle_;  // [rad]
  long double cos_, sin_;
};

template <class P>
requires requires(const P& patch, const Twist& u) { stribeck_excess(patch, u); }
BoundedWrench stribeck_excess(const Placed<P>& placed, const Twist& u) noexcept {
  const Twist own = placed.local(u);
  BoundedWrench E = stribeck_excess(placed.patch(), own);
  if (const double du = placed.rounding_of(own); du > 0) {
    // The integrand changes by no more than du / |u_P|; by less along u_P, with an arm of r (local_stribeck.h).
    const PressureMoments s = placed.patch().moments();
    const auto [T, S] = reciprocal_speeds(placed.patch(), own);
    E = with_change(E, s, du * T, du * (S + std::sqrt(0.58 * T * s.polar)));
  }
  return placed.in_contact_frame(E);
}

}  // namespace patchgrip::friction
