// The seed's gauge of a Hertz disc: its polynomial for the stick radius.
//
//     g = R / rho_H,   rho_H = 1 - 2.42 c^2 + 4.64 c^3 - 3.83 c^4 + 1.20 c^5                                (seed 4.56)
//     R = sqrt(F^2 + M^2 / a^2),   c = |M| / (a R) = |cos theta|
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
#include <patchgrip/friction/limit_surface/round_load.h>

namespace patchgrip::friction {

class SeedGauge {
 public:
  static constexpr double largest_excess = 4.4e-3;
  static constexpr double largest_deficit = 1.62e-3;

  static SeedGauge of_radius(double radius) { return SeedGauge(contact::require_positive("radius", radius)); }

  double value(const Wrench& load) const noexcept {
    return of_round_load(load, radius_, [](const kernels::HertzLoad& t) {
      const double R = std::sqrt(t.F2 + t.M * t.M);
      const double c = t.M / R;
      return R / (1 + c * c * (-2.42 + c * (4.64 + c * (-3.83 + c * 1.20))));
    });
  }

 private:
  explicit SeedGauge(double radius) noexcept : radius_(radius) {}

  double radius_;  // a [m]
};

}  // namespace patchgrip::friction
