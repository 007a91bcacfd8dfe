// What is drawn and judged: kinds of cases, and the errors found in one.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <patchgrip/friction/limit_surface/gauge.h>
#include <patchgrip/tests/friction/bounds/draw.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction::bounds {

// A bound that the library prints, and the error that 50 digits find.
struct Finding {
  std::string_view quantity;
  double bound;
  double error;
};

// No findings: not even 50 digits tell.
struct Case {
  std::string_view region;
  std::vector<Finding> findings;
};

inline std::string_view region(bool far) { return far ? "far" : "near"; }

// `reference` is the error of the exact one, of the moment `reference * length`.
inline Case judged(bool far, const BoundedWrench& computed, const Wrench50& exact, double reference = 0,
                   double length = 0) {
  const Real50 dx = computed.value.fx - exact.fx, dy = computed.value.fy - exact.fy, dm = computed.value.m - exact.m;
  return {region(far),
          {{"force", computed.force_error + reference, static_cast<double>(sqrt(dx * dx + dy * dy))},
           {"moment", computed.moment_error + reference * length, static_cast<double>(abs(dm))}}};
}

// Whether a bracket holds its own value, and a gauge that lies between `least` and `largest`.
inline Finding judged(std::string_view quantity, const Gauge& g, const Real50& least, const Real50& largest) {
  constexpr double none = -1;  // no error is that small
  if (!(g.lower <= g.value && g.value <= g.upper)) return {quantity, none, 0};
  const Real50 excess = g.value - largest, deficit = least - g.value;
  if (excess > deficit) return {quantity, g.value - g.lower, static_cast<double>(std::max(excess, Real50(0)))};
  return {quantity, g.upper - g.value, static_cast<double>(std::max(deficit, Real50(0)))};
}

struct Kind {
  std::string name;
  std::function<Case(Draw&)> draw;
  bool tight = true;  // in the median bounds are less than 100 errors near and 200 far
};

// Keeps one patch with its reference for `uses` draws: references are slow to make.
template <class Make>
std::function<Case(Draw&)> reuse(int uses, Make make) {
  return [uses, make, left = 0, current = std::function<Case(Draw&)>()](Draw& draw) mutable {
    if (left-- == 0) {
      current = make(draw);
      left = uses - 1;
    }
    return current(draw);
  };
}

using Kinds = std::vector<Kind>;

Kinds round_kinds();
Kinds framed_kinds();
Kinds ellipse_kinds();
Kinds polygon_kinds();
Kinds sampled_kinds();
Kinds local_kinds();
Kinds gauge_kinds();
Kinds cheap_gauge_kinds();

}  // namespace patchgrip::friction::bounds
