// The pole that a puck comes to rest about: a body on a round patch under its centre of mass, without a load.
//
// With x = v / (a |w|) = r_M / a and q = m a^2 / J Coulomb's law gives dx/dt ~ q x m(x) - f(x): motion and spin
// end together, with x at the root of
//
//     f(x) = q x m(x),        f'(0) / m(0) < q < 1 / lim x m(x)
//
// (of p ~ (1 - r^2 / a^2)^(n - 1/2): n + 1 < q < 2 n + 3). Below, x tends to 0: what ends is a spin; above, to
// infinity.
//
// Units    q, x [1].
// Error    a few units of rounding times the condition of the root; tests/dynamics/coast_down_test.cc.
// Throws   std::invalid_argument unless q > 0.
#pragma once

#include <cstdint>
#include <limits>

#include <boost/math/tools/toms748_solve.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::dynamics {

// Any RoundPatch.
template <class P>
double coast_down_pole(const P& disc, double q) {
  contact::require_positive("q", q);
  // f / x - q m over s = x / (1 + x), as V = s, W = 1 - s.
  const auto rest = [&](double s) {
    const friction::RoundGradient g = disc.kernel().gradient(friction::RoundTwist({s, 0, 1 - s}, 1));
    return g.force_per_speed - q * g.moment_per_radius / (1 - s);
  };
  const double far = 1 - 0x1p-40;  // q m / u is what it is at infinity to 2^-80
  const double first = rest(0), last = rest(far);
  if (first >= 0) return 0;
  if (last <= 0) return std::numeric_limits<double>::infinity();
  std::uintmax_t steps = 200;
  const auto [lo, hi] = boost::math::tools::toms748_solve(rest, 0., far, first, last,
                                                          boost::math::tools::eps_tolerance<double>(53), steps);
  const double s = (lo + hi) / 2;
  return s / (1 - s);
}

}  // namespace patchgrip::dynamics
