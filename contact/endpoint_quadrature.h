// Integral of a function that is smooth inside and may be singular, or nearly so, at either end.
//
// Double-exponential (tanh-sinh) quadrature; nodes crowd at the ends, and the integrand is told its distance from both
// without cancellation. The scalar decides the number of digits.
//
// Domain   at an end no worse than the inverse of a root.
// Error    the step is halved, which doubles the digits, until two results agree in three quarters of the digits:
//          mostly below 8, at most 64 units of rounding of int |f|, for f accurate to rounding. The bound that comes
//          along is the last difference and 16 such units. For what is not smooth inside two results never agree so
//          well; then it is 16 times the last difference, a fair guess and no proof.
#pragma once

#include <cmath>
#include <limits>

#include <boost/math/quadrature/tanh_sinh.hpp>

#include <patchgrip/contact/estimate.h>

namespace patchgrip::contact {

// f(x - lo, hi - x)
template <class Real, class Integrand>
BasicEstimate<Real> bounded_integral(const Integrand& f, const Real& lo, const Real& hi) {
  using std::sqrt;
  // Shared by threads: it locks where it grows. Nodes keep the fourth root of the smallest number off the ends.
  static boost::math::quadrature::tanh_sinh<Real> rule(12, Real(sqrt(sqrt(std::numeric_limits<Real>::min()))));
  const Real half = (hi - lo) / 2;
  if (!(half > 0)) return {0, 0};
  const Real tolerance = boost::math::tools::forth_root_epsilon<Real>() * boost::math::tools::root_epsilon<Real>();
  // The rule's second argument is 1 - x in the upper half of [-1, 1], -1 - x in the lower.
  const auto told = [&](const Real&, const Real& c) -> Real {
    return c < 0 ? f(Real(-c * half), Real((2 + c) * half)) : f(Real((2 - c) * half), Real(c * half));
  };
  Real difference = 0;
  Real absolute = 0;
  const Real value = half * rule.integrate(told, tolerance, &difference, &absolute);
  if (difference > tolerance * absolute) difference *= 16;
  return {value, half * (difference + 8 * std::numeric_limits<Real>::epsilon() * absolute)};
}

template <class Real, class Integrand>
Real integrate_to_both_ends(const Integrand& f, const Real& lo, const Real& hi) {
  return bounded_integral(f, lo, hi).value;
}

}  // namespace patchgrip::contact
