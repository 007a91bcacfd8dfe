// Second derivatives of D judged: 50-digit differences of a reference gradient, and the sizes of what differs.
#pragma once

#include <algorithm>
#include <cmath>

#include <patchgrip/friction/twist.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

// |v| + length |w|: with it and the length every component of a Hessian becomes a number of order 1.
inline double speed_of(const Twist& v, double length) { return std::hypot(v.vx, v.vy) + length * std::fabs(v.w); }

// Five points a column; `gradient` answers a Wrench50 at three Real50. `step` is relative to the speed: the error is
// about step^4 while the pole stays more than `step` lengths away from rims, edges and vertices.
template <class Gradient>
Hessian hessian_by_differences(const Gradient& gradient, const Twist& v, double length, double step = 1e-10) {
  const Real50 h = Real50(step) * speed_of(v, length);
  const auto column = [&](int x, int y, int w) {
    const Real50 k = w ? h / length : h;
    const auto at = [&](int i) { return gradient(v.vx + i * x * k, v.vy + i * y * k, v.w + i * w * k); };
    const Wrench50 p1 = at(1), m1 = at(-1), p2 = at(2), m2 = at(-2);
    const auto slope = [&](auto member) {
      return static_cast<double>((8 * (p1.*member - m1.*member) - (p2.*member - m2.*member)) / (12 * k));
    };
    return Wrench{slope(&Wrench50::fx), slope(&Wrench50::fy), slope(&Wrench50::m)};
  };
  const Wrench x = column(1, 0, 0);
  const Wrench y = column(0, 1, 0);
  const Wrench w = column(0, 0, 1);
  return {x.fx, x.fy, x.m, y.fy, y.m, w.m};
}

// Largest component of `h` times the speed, moments divided by the length.
inline double scaled_size(const Hessian& h, const Twist& v, double length) {
  const double l = length;
  return speed_of(v, l) * std::max({std::fabs(h.xx), std::fabs(h.xy), std::fabs(h.yy), std::fabs(h.xw / l),
                                    std::fabs(h.yw / l), std::fabs(h.ww / (l * l))});
}

inline double scaled_difference(const Hessian& a, const Hessian& b, const Twist& v, double length) {
  return scaled_size({a.xx - b.xx, a.xy - b.xy, a.xw - b.xw, a.yy - b.yy, a.yw - b.yw, a.ww - b.ww}, v, length);
}

inline Wrench operator*(const Hessian& h, const Twist& v) {
  return {h.xx * v.vx + h.xy * v.vy + h.xw * v.w, h.xy * v.vx + h.yy * v.vy + h.yw * v.w,
          h.xw * v.vx + h.yw * v.vy + h.ww * v.w};
}

// |H v| with moments divided by the length: D is homogeneous, so H v = 0.
inline double along_itself(const Hessian& h, const Twist& v, double length) {
  const Wrench t = h * v;
  return std::max({std::fabs(t.fx), std::fabs(t.fy), std::fabs(t.m / length)});
}

// Smallest u.H u times the speed over the 13 directions of a cube's symmetry axes, u scaled by the length.
inline double least_curvature(const Hessian& h, const Twist& v, double length) {
  double least = INFINITY;
  for (const int x : {0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int w : {-1, 0, 1}) {
        const Twist u{double(x), double(y), w / length};
        least = std::min(least, power(h * u, u));
      }
    }
  }
  return least * speed_of(v, length);
}

}  // namespace patchgrip::friction
