// Support functions of convex bodies of wrenches, in the frame of the centre of pressure.
//
// The limit surface of a patch is the boundary of B = {t : t . v <= D(v) for all v}: D is the support function of B,
// and D(v) is attained at the wrench grad D(v). Models of the limit surface are bodies of the same kind. They are
// compared in a frame where B is close to the unit ball:
//
//     v = (vx - w y, vy + w x, w l),    t = (fx, fy, (m - x fy + y fx) / l),    l = S(x, y) = M_0 / (mu F_N)
//
// with the centre of pressure (x, y), so that D = 1 for every translation of speed 1 and for the spin w = 1 / l.
//
// Domain   every patch whose pressure lies not in one point: there l = 0, and B is flat.
// Units    twist as twist.h; l [m]; v, t and D of the frame [m/s], [N] per mu F_N.
// Error    relative: |value - h(v)| <= error h(v), and wrench / (1 + error) lies in the body. A patch's error of force
//          and moment counts with 1 and 2 / l, as B contains (0, 0, l / 2): S(M) >= l / 2 everywhere, because
//          |M - c| <= S(M) and l <= S(c) <= S(M) + |M - c|: l is taken at its least.
// Throws   CentredFrame::of: std::invalid_argument as CentralMoment.
#pragma once

#include <cmath>
#include <functional>
#include <limits>

#include <patchgrip/friction/limit_surface/central_moment.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

struct SupportValue {
  double value;
  Wrench wrench;  // where it is attained
  double error;
};

using SupportFunction = std::function<SupportValue(const Twist&)>;

struct CentredFrame {
  static constexpr double unit = std::numeric_limits<double>::epsilon() / 2;

  template <Patch P>
  static CentredFrame of(const P& patch) {
    const PressureMoments s = patch.moments();
    const CentralMoment m(patch.bounded_gradient(twist_about({s.x, s.y}, 1)), s.x, s.y);
    return {s.x, s.y, m.value - m.error};
  }

  Twist local(const Twist& v) const noexcept { return {std::fma(-v.w, y, v.vx), std::fma(v.w, x, v.vy), v.w * length}; }
  Wrench local(const Wrench& t) const noexcept { return {t.fx, t.fy, (t.m - x * t.fy + y * t.fx) / length}; }

  Twist global(const Twist& v) const noexcept {
    const double w = v.w / length;
    return {std::fma(w, y, v.vx), std::fma(-w, x, v.vy), w};
  }
  Wrench global(const Wrench& t) const noexcept { return {t.fx, t.fy, t.m * length + x * t.fy - y * t.fx}; }

  double x, y;    // centre of pressure [m]
  double length;  // l [m]
};

// D in the frame. Holds a copy of the patch.
template <Patch P>
SupportFunction support_function(const P& patch, const CentredFrame& frame) {
  return [patch, frame](const Twist& local) -> SupportValue {
    constexpr double unit = CentredFrame::unit;
    const Twist v = frame.global(local);
    const BoundedWrench g = patch.bounded_gradient(v);
    const double arm = std::hypot(frame.x, frame.y);
    const double moment_error = g.moment_error + arm * (g.force_error + 4 * unit);
    const Wrench t = frame.local(g.value);
    return {power(t, local), t, g.force_error + 2 * moment_error / frame.length + 8 * unit};
  };
}

}  // namespace patchgrip::friction
