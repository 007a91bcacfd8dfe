// The gauge of a load: how much friction a patch needs to hold it.
//
//     g(t) = max over v of  t . v / D(v)      [N]                                        (seed 4.52, 4.53)
//
// is the smallest mu F_N that holds the load t: the patch sticks while g(t) <= mu F_N. The limit surface is g = mu F_N.
// The twist that attains the maximum is the slip that the load would start; the friction wrench then is -mu F_N grad D
// of it, parallel to -t.
//
// Units    load [N], [N], [N m] as twist.h; g [N].
// Error    lower <= g(t) <= upper, rounding included, as far as the patch's own bounded_gradient() holds. The bracket
//          is wide by the first order of the slip's error, `value` wrong by the second: to rounding once converged.
#pragma once

#include <optional>

#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

enum class GaugeStatus {
  converged,  // the bracket is as narrow as the settings ask for, or as rounding of the patch allows
  ridge,  // the same, but other slips serve as well: all pressure lies on one line, and the pole anywhere on a part of
          // it between two point loads or beyond their ends
  facet,  // the same, and proven to slip about a point load, where many loads start one slip (point_slip.h)
  stalled,     // the bracket holds, but is wider than asked for, and nothing more is known of the slip
  not_finite,  // the load is not finite: value, bracket and twist are not-a-number
};

struct Gauge {
  double value = 0;  // g(t) [N]
  double lower = 0;  // [N]
  double upper = 0;  // [N]
  Twist twist;       // slip that the load starts, with D(twist) = 1: the gradient of g, and value = t . twist
  int evaluations = 0;
  GaugeStatus status = GaugeStatus::converged;
};

struct GaugeSettings {
  double relative_gap = 1e-12;  // (upper - lower) / value where rounding allows it, in [1e-15, 1)
  int max_evaluations = 100;    // of grad D, >= 1; loads next to a kink may take a few more

  // Throws std::invalid_argument, naming the setting.
  void check() const;
};

// Of a load that is not finite, and of none: its gauge is 0, and it starts no slip.
std::optional<Gauge> trivial_gauge(const Wrench& load) noexcept;

// e with 2^e near the size of a load that is finite and not zero, moments divided by `length`: scaled by 2^-e, which
// rounds nothing, its squares neither over- nor underflow.
int load_exponent(const Wrench& load, double length) noexcept;

}  // namespace patchgrip::friction
