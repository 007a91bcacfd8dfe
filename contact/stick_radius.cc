#include <patchgrip/contact/complete_elliptic.h>
#include <patchgrip/contact/falling_root.h>
#include <patchgrip/contact/require.h>
#include <patchgrip/contact/stick_radius.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr Real half_pi = std::numbers::pi_v<Real> / 2;
constexpr Real ln2 = std::numbers::ln2_v<Real>;

// From L + l = artanh s, where l is below the rounding of L.
StickRatio ratio(Real L, Real l = 0) {
  const Real shrink = std::exp(-2 * L) * (1 - 2 * l);
  const Real slip = 2 * shrink / (1 + shrink);
  const Real stick = std::tanh(L);
  return {static_cast<double>(stick), static_cast<double>(slip),
          static_cast<double>(L < 0.5L ? std::log(stick) : std::log1p(-slip)),
          static_cast<double>(L < 0.5L ? std::log1p(-stick) : ln2 - 2 * L - std::log1p(shrink))};
}

// Hardly anything sticks: s = 4 exp(-chi) but for chi s^2, and below the range of any type.
StickRatio small_ratio(Real chi) {
  const Real log_stick = 2 * ln2 - chi;
  const Real stick = 4 * std::exp(-chi);
  return {static_cast<double>(stick), static_cast<double>(1 - stick), static_cast<double>(log_stick),
          static_cast<double>(std::log1p(-stick))};
}

// Nearly everything sticks: K = pi/2. The exponential would show what L = (pi/2) / chi is rounded off by.
StickRatio large_ratio(Real chi) {
  constexpr Real half_pi_rest = std::numeric_limits<Real>::digits == 64 ? -2.50827880633416601173e-20L : 0;
  const Real L = half_pi / chi;
  return ratio(L, (std::fma(-L, chi, half_pi) + half_pi_rest) / chi);
}

// One root in ln L: the left side over the right one grows with L.
StickRatio solve(Real chi) {
  if (chi > 24) return small_ratio(chi);
  if (chi < 0.06L) return large_ratio(chi);  // 1 - s < 1e-22
  const auto right_side = [&](Real L) {
    const Real s = std::tanh(L);
    const Real slip = 2 / (std::exp(2 * L) + 1);
    return s * CompleteElliptic<Real>::of_axes(s, slip).K / chi;
  };
  const auto lacking = [&](Real log_L) {
    const Real L = std::exp(log_L);
    return std::log(right_side(L) / L);
  };
  // chi L lies between s and s ln(4/s) + pi/2.
  const Real L =
      std::exp(falling_root<Real>(lacking, std::log(3 * std::exp(-chi)), std::log(half_pi / chi * (1 + chi))));
  return ratio(L > 3 ? right_side(L) : L);  // the right side hardly depends on a large L: a step without its error
}

}  // namespace

StickRatio StickRatio::of(double beta_over_mu) { return solve(require_positive("beta_over_mu", beta_over_mu)); }

StickRatio seed_printed_stick_ratio(double printed_beta_over_mu) {
  return solve(2 / static_cast<Real>(require_positive("printed_beta_over_mu", printed_beta_over_mu)));
}

}  // namespace patchgrip::contact
