// The Hessian of D where it is infinite, the pole on a ring, a line or a point load: that 2^-50 of the velocity beside
// it. What the rounding of a velocity does to a wrench is bounded with it.
//
// It has the mean of 1 / |u_P| over the pressure, its trace T, and that of q^2 / |u_P|, H_ww about the centroid, where q
// is the arm of what is across u_P. The mean of q / |u_P| is sqrt(T H_ww) at most (Cauchy, Schwarz).
//
// Fails    a rounding moves the force of a point load with the pole on it by more than any Hessian tells.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

// Infinite at rest.
template <Patch P>
Hessian hessian_beside(const P& patch, const Twist& u) noexcept {
  const double aside = 0x1p-50 * std::hypot(u.vx, u.vy);
  for (const Twist& v : {u, Twist{u.vx + 0.8 * aside, u.vy - 0.6 * aside, u.w}}) {
    try {
      return patch.hessian(v);
    } catch (const std::domain_error&) {
    }
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, infinity, infinity, infinity, infinity, infinity};
}

struct ReciprocalSpeeds {
  double mean;      // of 1 / |u_P| [s/m]
  double arm_mean;  // of q / |u_P|, at most [s]
};

template <Patch P>
ReciprocalSpeeds reciprocal_speeds(const P& patch, const Twist& u) noexcept {
  const Hessian h = hessian_beside(patch, u);
  const PressureMoments s = patch.moments();
  const double T = h.xx + h.yy;
  const double ww = h.ww + 2 * (s.y * h.xw - s.x * h.yw) + (s.y * s.y * h.xx - 2 * s.x * s.y * h.xy + s.x * s.x * h.yy);
  return {T, std::sqrt(T * std::fabs(ww))};
}

}  // namespace patchgrip::friction
