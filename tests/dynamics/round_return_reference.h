// The closest point of a round limit surface in 50 digits.
#pragma once

#include <optional>

#include <patchgrip/dynamics/round_return_mapping.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::dynamics {

using friction::Real50;

// Of the power family n: f and m over the pole's place s = x / (1 + x).
class RoundReturnReference {
 public:
  struct Closest {
    Real50 force, moment;  // sizes
    Real50 V, w;           // of the slip, V = |(u_x, u_y)|
  };

  explicit RoundReturnReference(double n) : family_(n) {}

  // None if it sticks. `near` is the pole's distance per radius of a slip that is nearly right.
  std::optional<Closest> closest(double radius, const friction::Wrench& trial, double limit, const RoundStiffness& K,
                                 double near) const {
    const Real50 a = radius, L = limit;
    const Real50 F = sqrt(Real50(trial.fx) * trial.fx + Real50(trial.fy) * trial.fy) / L;
    const Real50 M = abs(Real50(trial.m)) / (a * L);
    const Real50 rho = Real50(K.k) * a * a / K.k_r;
    // F - f across to rho x (M - m), as (1 - s, s) times each.
    const auto rest = [&](const Real50& s) {
      const auto [f, m] = at(s);
      return Real50((1 - s) * (F - f) - rho * s * (M - m));
    };
    Real50 s = near < 1 ? Real50(near) / (1 + Real50(near)) : 1 / (1 + 1 / Real50(near));
    Real50 aside = s < 0.5 ? s * (1 + 1e-7) : 1 - (1 - s) * (1 - 1e-7);
    if (s == 0 || s == 1) aside = s;
    Real50 r = rest(s), r_aside = rest(aside);
    for (int i = 0; i < 12 && r != r_aside && abs(s - aside) > 1e-46 * s * (1 - s); ++i) {
      const Real50 next = s - r * (s - aside) / (r - r_aside);
      if (!(next >= 0 && next <= 1)) break;
      aside = s, r_aside = r;
      s = next, r = rest(s);
    }
    const auto [f, m] = at(s);
    const Real50 along = s * (F - f) + (1 - s) * (M - m);
    if (!(along > 0)) return std::nullopt;
    const Real50 lambda = along / ((1 - s) * (1 - s) + rho * s * s);  // times the length of the normal
    return Closest{L * f, L * a * m, L * a * a / K.k_r * lambda * s, L * a / K.k_r * lambda * (1 - s)};
  }

 private:
  struct Point {
    Real50 f, m;
  };

  Point at(const Real50& s) const {
    const auto g = friction::round_wrench(family_, 1, s, 0, 1 - s);
    return {g.fx, g.m};
  }

  friction::kernels::PowerFamily<Real50> family_;
};

}  // namespace patchgrip::dynamics
