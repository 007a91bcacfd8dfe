// Kernel of the seed's polynomials (seed_hertz_disc.h). slope() is the exact derivative of the polynomial for f.
#pragma once

#include <cmath>
#include <numbers>

#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction::kernels {

struct SeedKernel {
  static bool pole_inside(const RoundTwist& t) noexcept { return t.V2 <= t.W2; }

  static RoundGradient gradient(const RoundTwist& t) noexcept {
    constexpr double m0 = 3 * std::numbers::pi / 16;
    if (pole_inside(t)) {
      const double k = 1 / t.W;
      const double z = t.V2 * k * k;
      return {k * (1.178 - 0.294 * z), m0 * (1 - z * (1 - 0.375 * z))};
    }
    const double k = 1 / std::sqrt(t.V2);
    const double u = t.W * k;
    const double z = u * u;
    return {k * (1 - 0.096 * z - 0.020 * z * z), m0 * u * (0.335 + 0.040 * z)};
  }

  static double slope(const RoundTwist& t) noexcept {
    if (pole_inside(t)) return 1.178 - 0.882 * t.V2 / t.W2;
    return 0.192 + 0.080 * t.W2 / t.V2;
  }

  static CurvePoint inside(double x) noexcept { return at({{x, 0, 1}, 1}); }
  static CurvePoint outside(double u) noexcept { return at({{1, 0, u}, 1}); }

 private:
  static CurvePoint at(const RoundTwist& t) noexcept {
    const RoundGradient g = gradient(t);
    return {g.force_per_speed * t.vx, g.moment_per_radius, slope(t)};
  }
};

}  // namespace patchgrip::friction::kernels
