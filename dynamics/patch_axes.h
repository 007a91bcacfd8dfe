// From a patch that has turned and grown to the one given, and back.
//
//     v_own = R(-angle) v,        D_s(V, w) = D(V, s w),        B_s = {(f, m) : (f, m / s) in B}
//
// of a patch whose lengths are s (`size`) times those given, about the origin, its pressure scaled alike.
//
// Units    angle [rad]; size [1], > 0; wrenches and twists as friction/twist.h.
// Throws   nothing.
#pragma once

#include <cmath>

#include <patchgrip/dynamics/bristle_metric.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::dynamics {

// A wrench or twist in axes that differ by an angle.
inline Vector3 turned(const Vector3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

// What the patch given feels of a wrench and a twist of the one `size` times as large.
inline friction::Wrench shrunk(const Vector3& f, double size) { return {f[0], f[1], f[2] / size}; }
inline friction::Twist grown(const Vector3& v, double size) { return {v[0], v[1], size * v[2]}; }

// What the larger one carries where the one given carries `r`.
inline Vector3 carried(const friction::Wrench& r, double size) { return {r.fx, r.fy, size * r.m}; }

}  // namespace patchgrip::dynamics
