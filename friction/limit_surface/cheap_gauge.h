// What every cheap gauge answers: a value, and how far the true gauge can be on either side of it. The twist is that of
// the model, of whose own dissipation it has D = 1.
#pragma once

#include <cmath>
#include <limits>

#include <patchgrip/friction/limit_surface/gauge.h>
#include <patchgrip/friction/limit_surface/support_ratio.h>

namespace patchgrip::friction {

// The bracket of the true gauge that `value` of a model with these sides stands for. Rounding of value and of the
// moment about the centre of pressure counts in: a moment error of d asks for 2 d / l at most, as B contains
// (0, 0, l / 2) there.
inline Gauge bracketed(double value, const Twist& twist, const GaugeSides& sides, const CentredFrame& frame,
                       const Wrench& t) noexcept {
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  const double lost = std::fabs(t.m) + std::fabs(frame.x * t.fy) + std::fabs(frame.y * t.fx);
  const double error = rounding * (value + 2 * lost / frame.length);
  Gauge g;
  g.value = value;
  g.lower = std::fmax(0, value - error * (1 + sides.largest_excess)) / (1 + sides.largest_excess);
  g.upper = (value + error) / (1 - sides.largest_deficit);
  g.twist = twist;
  if (!std::isfinite(value)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    g = {nan, nan, nan, {nan, nan, nan}, 0, GaugeStatus::not_finite};
  }
  return g;
}

}  // namespace patchgrip::friction
