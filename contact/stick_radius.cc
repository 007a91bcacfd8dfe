#include <patchgrip/contact/complete_elliptic.h>
#include <patchgrip/contact/falling_root.h>
#include <patchgrip/contact/require.h>
#include <patchgrip/contact/stick_radius.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr Real half_pi = std::numbers::pi_v<Real> / 2;
constexpr Real ln2 = std::numbers::ln2_v<Real>;

// From L = artanh s.
StickRatio ratio(Real L) {
  const Real shrink = std::exp(-2 * L);
  const Real slip = 2 * shrink / (1 + shrink);
  const Real stick = std::tanh(L);
  return {static_cast<double>(stick), static_cast<double>(slip),
          static_cast<double>(L < 0.5L ? std::log(stick) : std::log1p(-slip)),
          static_cast<double>(L < 0.5L ? std::log1p(-stick) : ln2 - 2 * L - std::log1p(shrink))};
}

// Hardly anything sticks: s = 4 exp(-chi) to rounding, and below the range of any type.
StickRatio small_ratio(Real chi) {
  const Real log_stick = 2 * ln2 - chi;
  const Real stick = std::exp(log_stick);
  return {static_cast<double>(stick), static_cast<double>(1 - stick), static_cast<double>(log_stick),
          static_cast<double>(std::log1p(-stick))};
}

// Nearly everything sticks, or one root in ln L: the left side over the right one grows with L.
StickRatio solve(Real chi) {
  if (chi > 60) return small_ratio(chi);
  if (chi < 0.03L) return ratio(half_pi / chi);  // 1 - s < 1e-45: K = pi/2
  const auto lacking = [&](Real log_L) {
    const Real L = std::exp(log_L);
    const Real s = std::tanh(L);
    const Real slip = 2 / (std::exp(2 * L) + 1);
    return std::log(s * CompleteElliptic<Real>::of_axes(s, slip).K / (chi * L));
  };
  // chi L lies between s and s ln(4/s) + pi/2.
  return ratio(
      std::exp(falling_root<Real>(lacking, std::log(3 * std::exp(-chi)), std::log(half_pi / chi * (1 + chi)))));
}

}  // namespace

StickRatio StickRatio::of(double beta_over_mu) { return solve(require_positive("beta_over_mu", beta_over_mu)); }

StickRatio seed_printed_stick_ratio(double printed_beta_over_mu) {
  return solve(2 / static_cast<Real>(require_positive("printed_beta_over_mu", printed_beta_over_mu)));
}

}  // namespace patchgrip::contact
