// The seed's gauge of a Hertz disc: its polynomial for the stick radius.
//
//     g = R / rho_H,   rho_H = 1 - 2.42 c^2 + 4.64 c^3 - 3.83 c^4 + 1.20 c^5                                (seed 4.56)
//     R = sqrt(F^2 + M^2 / a^2),   c = |M| / (a R) = |cos theta|
//
// The slip is the gradient of g, with dg/dR and dg/dc of these.
//
// Kept beside hertz_gauge.h for comparison. It errs on both sides: too small, so that a load that slips is said to
// stick, for c in [0.189, 0.354] and [0.980, 1] (by 1.6e-3 for a pure moment), else too large.
//
//     (1 - largest_deficit) g <= value <= (1 + largest_excess) g
//
// Domain   every load.
// Units    load [N], [N], [N m] about the centre; g [N].
// Error    as above; tests/friction/limit_surface/hertz_gauge_test.cc.
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <cmath>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/limit_surface/gauge_model.h>
#include <patchgrip/friction/limit_surface/round_load.h>

namespace patchgrip::friction {

class SeedGauge {
 public:
  static constexpr double largest_excess() noexcept { return 4.4e-3; }
  static constexpr double largest_deficit() noexcept { return 1.62e-3; }

  static SeedGauge of_radius(double radius) { return SeedGauge(contact::require_positive("radius", radius)); }

  double value(const Wrench& load) const noexcept {
    return of_round_load(load, radius_, [](const kernels::HertzLoad& t) {
      const double R = std::sqrt(t.F2 + t.M * t.M);
      return R / stick_radius(t.M / R);
    });
  }

  Gauge gauge(const Wrench& load) const noexcept {
    if (const auto known = trivial_gauge(load)) return *known;
    const ScaledLoad scaled(load, radius_);
    const kernels::HertzLoad t = round_load(scaled.load, radius_);
    const double R2 = t.F2 + t.M * t.M, R = std::sqrt(R2), c = t.M / R, rho = stick_radius(c);
    const double slope = c * (-4.84 + c * (13.92 + c * (-15.32 + c * 6.00)));  // d rho / d c
    // dg/dF = F / R / rho - R slope / rho^2 * (-M F / R^3), and dc/dM = F^2 / R^3.
    const double along = (1 + c * slope / rho) / (R * rho);  // dg/dF over F
    const double spin = (c - t.F2 / R2 * slope / rho) / rho;
    const Twist twist{along * scaled.load.fx, along * scaled.load.fy, std::copysign(spin / radius_, scaled.load.m)};
    return scaled.back(bracketed(R / rho, twist, largest_excess(), largest_deficit()));
  }

 private:
  explicit SeedGauge(double radius) noexcept : radius_(radius) {}

  static double stick_radius(double c) noexcept { return 1 + c * c * (-2.42 + c * (4.64 + c * (-3.83 + c * 1.20))); }

  double radius_;  // a [m]
};

static_assert(GaugeModel<SeedGauge>);

}  // namespace patchgrip::friction
