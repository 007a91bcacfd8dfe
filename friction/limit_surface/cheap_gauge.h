// What gauges of a shape about the centre of pressure share (ellipsoid_gauge.h, quartic_gauge.h): loads of every size,
// and the bracket of the true gauge.
//
// A shape has a value, homogeneous of degree 1, whose powers are formed: those of 2^-e t, near 1. The moment about the
// centre of pressure (x, y) is rounded by a part of |m| + |x fy| + |y fx|; an error d of it asks for 2 d / l at most,
// as B contains (0, 0, l / 2) there (support_function.h).
//
// Domain   every load; one that is not finite has a gauge that is not a number.
// Units    load [N], [N], [N m] about the origin; gauge [N].
// Error    the bracket holds, with rounding of the value and of the moment about the centre.
// Throws   nothing.
#pragma once

#include <cmath>
#include <limits>

#include <patchgrip/friction/limit_surface/gauge_model.h>
#include <patchgrip/friction/limit_surface/scaled_load.h>
#include <patchgrip/friction/limit_surface/support_ratio.h>

namespace patchgrip::friction {

// The powers of a load that a value is the root of say whether it may be taken as it is.
inline bool in_range(double power) noexcept { return power > 0x1p-900 && power < 0x1p900; }

// `value` of a load that is out of range, by scaling it.
template <class Value>
[[gnu::noinline]] double of_load_out_of_range(const Wrench& t, const CentredFrame& frame, const Value& value) noexcept {
  if (const auto known = trivial_gauge(t)) return known->value;
  const ScaledLoad scaled(t, frame.length);
  return scaled.back(value(scaled.load));
}

// The bracket that value and twist of a load stand for, both functions of a scaled load.
template <class Value, class TwistOf>
Gauge bracketed_gauge(const Wrench& t, const CentredFrame& frame, const GaugeSides& sides, const Value& value,
                      const TwistOf& twist) noexcept {
  if (const auto known = trivial_gauge(t)) return *known;
  constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
  const ScaledLoad scaled(t, frame.length);
  const auto& [fx, fy, m] = scaled.load;
  const double g = value(scaled.load);
  const double lost = std::fabs(m) + std::fabs(frame.x * fy) + std::fabs(frame.y * fx);
  const double error = rounding * (g + 2 * (1 + sides.largest_excess) * lost / frame.length);
  return scaled.back(bracketed(g, twist(scaled.load), sides.largest_excess, sides.largest_deficit, error));
}

}  // namespace patchgrip::friction
