// The limit curve of a round patch: force against moment from a pole at the centre to a translation.
//
//     f(x) = S'(x),   m(x) = S - x S',   x = r_M / a = tan psi,   psi from 0 to pi/2 in even steps
//
// Its revolution about the axis of moments is the limit surface. The slip is normal to it: (sin psi, cos psi).
//
// Units    f per mu F_N, m per mu F_N a [1]; psi [rad].
// Error    as gradient() of the patch (round_patch.h).
// Throws   std::invalid_argument unless points >= 2.
#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

struct LimitCurvePoint {
  double psi;
  double f;
  double m;
};

template <class Kernel>
std::vector<LimitCurvePoint> limit_curve(const RoundPatch<Kernel>& patch, int points) {
  if (points < 2)
    throw std::invalid_argument("points = " + std::to_string(points) + " is not allowed: must be at least 2");
  std::vector<LimitCurvePoint> curve;
  for (int i = 0; i < points; ++i) {
    const double psi = std::numbers::pi / 2 * i / (points - 1);
    const bool last = i == points - 1;  // where cos is not quite 0
    const RoundTwist v({last ? 1 : std::sin(psi), 0, last ? 0 : std::cos(psi)}, 1);
    const RoundGradient g = patch.kernel().gradient(v);
    curve.push_back({psi, g.force_per_speed * v.vx, v.w > 0 ? g.moment_per_radius : 0});
  }
  return curve;
}

}  // namespace patchgrip::friction
