// The gauge of a Hertz disc to 1e-9, never too small: a load that it holds is held.
//
// As hertz_gauge.h, with a shorter polynomial outside and without the Newton step inside, where the gauge is stationary
// in the pole: each raised by its own largest error (fit/gauge_fit.cc).
//
//     (1 - largest_deficit) g <= value <= (1 + largest_excess) g
//
// Domain, units   as hertz_gauge.h.
// Error    largest_excess, the rounding of both included; tests/friction/limit_surface/hertz_gauge_test.cc.
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/limit_surface/round_load.h>

namespace patchgrip::friction {

class FastHertzGauge {
 public:
  static constexpr double largest_excess = 1.01e-9;
  static constexpr double largest_deficit = 0;

  static FastHertzGauge of_radius(double radius) { return FastHertzGauge(contact::require_positive("radius", radius)); }

  double value(const Wrench& load) const noexcept {
    return of_round_load(load, radius_, [](const kernels::HertzLoad& t) { return kernels::safe_hertz_gauge(t); });
  }

 private:
  explicit FastHertzGauge(double radius) noexcept : radius_(radius) {}

  double radius_;  // a [m]
};

}  // namespace patchgrip::friction
