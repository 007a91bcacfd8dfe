// The gauge of a Hertz disc to rounding, in a few nanoseconds.
//
// The closed limit curve with the pole inside (m >= 9 pi/128, per mu F_N and a; f = F / mu F_N),
//
//     f^2 = (pi^2/48)(1 - q)(2 + q)^2,      q^2 = 8 m/pi - 1/2
//
// and the one through hypergeometric functions beyond, each solved for g beforehand (kernels/hertz_gauge.h). The seed's
// curve 0 = 256 m^2/(9 pi^2) - (1 - f^2)(1 - f^2/4)^2 is a fit: its m is off by up to 2.1e-3.
//
// Domain   every load; pure forces and moments too.
// Units    load [N], [N], [N m] about the centre; g [N].
// Error    value <= 8 units of 2^-53; pole <= 1e-14 of itself; tests/friction/limit_surface/hertz_gauge_test.cc.
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <cmath>

#include <patchgrip/friction/kernels/hertz_gauge.h>
#include <patchgrip/friction/limit_surface/gauge_model.h>
#include <patchgrip/friction/limit_surface/round_load.h>

namespace patchgrip::friction {

class HertzGauge {
 public:
  static HertzGauge of_radius(double radius);

  static constexpr double largest_excess() noexcept { return 8 * 0x1p-53; }
  static constexpr double largest_deficit() noexcept { return 8 * 0x1p-53; }

  double value(const Wrench& load) const noexcept {
    return of_round_load(load, radius_, [](const kernels::HertzLoad& t) { return kernels::hertz_gauge(t); });
  }

  // The gauge and the twist that the load starts, as in Gauge.
  GaugeAndTwist slip(const Wrench& load) const noexcept {
    const kernels::HertzLoad t = round_load(load, radius_);
    if (!in_range(t)) [[unlikely]]
      return rescaled_slip(load);
    const kernels::HertzSlip s = kernels::hertz_slip(t);
    return {s.gauge, {s.V_per_F * load.fx, s.V_per_F * load.fy, std::copysign(s.W * inverse_radius_, load.m)}};
  }

  Gauge gauge(const Wrench& load) const noexcept;

  double radius() const noexcept { return radius_; }

 private:
  explicit HertzGauge(double radius) noexcept : radius_(radius), inverse_radius_(1 / radius) {}
  GaugeAndTwist rescaled_slip(const Wrench& load) const noexcept;

  double radius_;  // a [m]
  double inverse_radius_;
};

static_assert(GaugeModel<HertzGauge>);

}  // namespace patchgrip::friction
