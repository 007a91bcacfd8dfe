// The gauge of a Hertz disc to 1e-9, never too small: a load that it holds is held.
//
// As hertz_gauge.h, with a shorter polynomial outside and without the Newton step inside, where the gauge is stationary
// in the pole: each raised by its own largest error (fit/gauge_fit.cc).
//
//     (1 - largest_deficit) g <= value <= (1 + largest_excess) g
//
// The slip is the exact one of hertz_gauge.h.
//
// Domain, units   as hertz_gauge.h.
// Error    largest_excess, the rounding of both included; tests/friction/limit_surface/hertz_gauge_test.cc.
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <patchgrip/friction/limit_surface/hertz_gauge.h>

namespace patchgrip::friction {

class FastHertzGauge {
 public:
  static constexpr double largest_excess() noexcept { return 1.01e-9; }
  static constexpr double largest_deficit() noexcept { return 8 * 0x1p-53; }  // by rounding alone

  static FastHertzGauge of_radius(double radius) { return FastHertzGauge(HertzGauge::of_radius(radius)); }

  double value(const Wrench& load) const noexcept {
    return of_round_load(load, exact_.radius(),
                         [](const kernels::HertzLoad& t) { return kernels::safe_hertz_gauge(t); });
  }

  Gauge gauge(const Wrench& load) const noexcept {
    if (const auto known = trivial_gauge(load)) return *known;
    const ScaledLoad scaled(load, exact_.radius());
    return scaled.back(
        bracketed(value(scaled.load), exact_.slip(scaled.load).twist, largest_excess(), largest_deficit()));
  }

 private:
  explicit FastHertzGauge(const HertzGauge& exact) noexcept : exact_(exact) {}

  HertzGauge exact_;
};

static_assert(GaugeModel<FastHertzGauge>);

}  // namespace patchgrip::friction
