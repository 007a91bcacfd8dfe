// The Hessian of D where it is infinite, the pole on a ring, a line or a point load: that 2^-50 of the velocity beside
// it. What the rounding of a velocity does to a wrench is bounded with it.
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

}  // namespace patchgrip::friction
