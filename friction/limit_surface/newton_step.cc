#include <patchgrip/friction/limit_surface/newton_step.h>

#include <algorithm>
#include <cmath>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;

// What Newton's matrix is raised by, of its trace: ten times what the elimination of three rows rounds, ten units.
constexpr double raise = 100 * unit;

// A curvature of D below this many raises is none that rounding of the gradient could tell: the pole would be uncertain
// by unit / (least_curvature * raise), a millionth of a radius.
constexpr double least_curvature = 1e4;

// Where the Hessian is infinite (the pole on a line load) it is taken with the pole a little aside.
Twist moved_aside(const Twist& v, double length) noexcept {
  const double shift = beside * length * v.w;
  return {v.vx + 0.8 * shift, v.vy - 0.6 * shift, v.w};
}

}  // namespace

std::optional<NewtonStep> newton_step(const PatchView& patch, const PressureFrame& frame, const Vector& t,
                                      const Twist& v, const Vector& g, double D, double value) noexcept {
  Hessian h;
  if (!patch.hessian(patch.patch, v, h) && !patch.hessian(patch.patch, moved_aside(v, frame.length), h))
    return std::nullopt;
  h = frame.about_centroid(h);
  // H is that of v: D(k v) H(k v) = D(v) H(v)
  const double m00 = D * h.xx + g[0] * g[0], m01 = D * h.xy + g[0] * g[1], m02 = D * h.xw + g[0] * g[2];
  const double m11 = D * h.yy + g[1] * g[1], m12 = D * h.yw + g[1] * g[2];
  const double m22 = D * h.ww + g[2] * g[2];
  const double floor = raise * (m00 + m11 + m22);
  const Vector r = moved(t, -value, g);
  // Cholesky
  const double d0 = m00 + floor;
  const double l1 = m01 / d0, l2 = m02 / d0;
  const double d1 = std::max(m11 + floor - l1 * m01, floor);
  const double l3 = (m12 - l1 * m02) / d1;
  const double d2 = std::max(m22 + floor - l2 * m02 - l3 * l3 * d1, floor);
  const double z0 = r[0];
  const double z1 = r[1] - l1 * z0;
  const double z2 = r[2] - l2 * z0 - l3 * z1;
  const double s2 = z2 / d2;
  const double s1 = z1 / d1 - l3 * s2;
  const double s0 = z0 / d0 - l1 * s1 - l2 * s2;
  if (!std::isfinite(s0 + s1 + s2)) return std::nullopt;
  return NewtonStep{{s0, s1, s2}, std::min(d1, d2) <= least_curvature * floor};
}

}  // namespace patchgrip::friction
