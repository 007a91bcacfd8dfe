#include <patchgrip/contact/relative_radii.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr double infinity = std::numeric_limits<double>::infinity();

// 1/one + sign/other: one subtraction of what is given, so relatively exact also where the two nearly cancel.
Real curvature_sum(double one, double other, int sign) {
  const Real first = one, second = other;
  if (one == infinity) return sign / second;
  if (other == infinity) return 1 / first;
  return (second + static_cast<Real>(sign) * first) / first / second;
}

}  // namespace

RelativeRadii RelativeRadii::of_bodies(const PrincipalRadii& p, const PrincipalRadii& m, double alpha) {
  require_radius("R1p", p.R1);
  require_radius("R2p", p.R2);
  require_radius("R1m", m.R1);
  require_radius("R2m", m.R2);
  const Real c = std::cos(static_cast<Real>(require_finite("alpha", alpha)));
  const Real s = std::sin(static_cast<Real>(alpha));

  const Real along = curvature_sum(p.R1, m.R1, 1), across = curvature_sum(p.R2, m.R2, 1);
  const Real mixed = curvature_sum(p.R1, m.R2, 1), other = curvature_sum(p.R2, m.R1, 1);
  const Real cosine_part = along * across * c * c;
  const Real sine_part = mixed * other * s * s;
  const Real det = cosine_part + sine_part;
  // The part that is positive has factors of one sign: their sum does not cancel.
  const Real sum = cosine_part > sine_part ? along + across : mixed + other;
  if (!(det > 0 && sum > 0)) {
    refuse("relative_curvature", static_cast<double>(det > 0 ? sum : det),
           "must be positive in every direction: the bodies would touch along a line or in more than a point");
  }

  const Real dp = curvature_sum(p.R1, p.R2, -1);
  const Real dm = curvature_sum(m.R1, m.R2, -1);
  const Real difference = std::hypot((dp + dm) * c, (dp - dm) * s);
  const Real larger = sum + difference;
  // Of the larger relative curvature; (dp + dm) c^2 + (dp - dm) s^2 = dp + dm cos 2 alpha.
  const Real angle = std::atan2(2 * dm * s * c, (dp + dm) * c * c + (dp - dm) * s * s) / 2;
  constexpr Real quarter_turn = std::numbers::pi_v<Real> / 2;
  return {require_representable("R_small", static_cast<double>(2 / larger)),
          require_representable("R_large", static_cast<double>(larger / (2 * det))),
          static_cast<double>(2 * difference / larger),
          static_cast<double>(angle > 0 ? angle - quarter_turn : angle + quarter_turn),
          static_cast<double>(1.01L + 0x1p-9L * (std::fabs(cosine_part) + std::fabs(sine_part)) / det)};
}

RelativeRadii RelativeRadii::of(double small, double large) {
  require_positive("R_small", small);
  require_positive("R_large", large);
  if (small > large) refuse("R_small", small, "must not exceed R_large");
  return {small, large, static_cast<double>((static_cast<Real>(large) - small) / large), 0};
}

RelativeRadii RelativeRadii::of_one_minus_ratio(double one_minus_ratio, double large) {
  require_in("one_minus_ratio", one_minus_ratio, 0, 0.5);
  require_positive("R_large", large);
  return {require_representable("R_small", static_cast<double>((1 - static_cast<Real>(one_minus_ratio)) * large)),
          large, one_minus_ratio, 0};
}

}  // namespace patchgrip::contact
