// Planar twist, friction wrench and instantaneous pole: the conventions of the whole library.
//
// Contact frame: right-handed, origin in the contact plane, z along the normal. The twist is the motion of body A
// relative to body B at the origin; a point P = (x, y) of the patch slides with
//
//     v_P = (vx - w y, vy + w x)                                                        (seed 4.40, 4.42)
//
// The wrench is what friction does to body A, its moment taken about the origin, so the friction power
// fx vx + fy vy + m w is never positive. While w != 0 the motion is a rotation about the instantaneous pole
//
//     M = (-vy / w, vx / w)                                                             (seed 4.46)
//
// and a pure translation (w = 0) has its pole at infinity.
//
// Units    vx, vy [m/s], w [rad/s]; fx, fy [N], m [N m]; pole [m]. Per unit mu F_N a wrench is [1], [1], [m].
#pragma once

#include <cmath>
#include <limits>

namespace patchgrip::friction {

struct Twist {
  double vx = 0;
  double vy = 0;
  double w = 0;
};

struct Wrench {
  double fx = 0;
  double fy = 0;
  double m = 0;
};

struct Pole {
  double x = 0;
  double y = 0;
};

// Rotation about `pole` with angular velocity `spin` [rad/s].
constexpr Twist twist_about(const Pole& pole, double spin) noexcept { return {spin * pole.y, -spin * pole.x, spin}; }

constexpr double power(const Wrench& t, const Twist& v) noexcept { return t.fx * v.vx + t.fy * v.vy + t.m * v.w; }

// The same twist, or not-a-number in every component if one of them is not finite.
inline Twist finite_or_nan(const Twist& v) noexcept {
  if (std::isfinite(v.vx) && std::isfinite(v.vy) && std::isfinite(v.w)) return v;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, nan, nan};
}

// Second derivatives of a function of the twist in (vx, vy, w); symmetric.
struct Hessian {
  double xx = 0;
  double xy = 0;
  double xw = 0;
  double yy = 0;
  double yw = 0;
  double ww = 0;
};

// A wrench and how wrong it can be: |computed force - true force| <= force_error, likewise the moment.
struct BoundedWrench {
  Wrench value;
  double force_error = 0;
  double moment_error = 0;
};

}  // namespace patchgrip::friction
