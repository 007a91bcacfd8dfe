// Integral of a function that is smooth inside and may be singular, or nearly so, at either end.
//
// Double-exponential (tanh-sinh) quadrature; nodes crowd at the ends, and the integrand is told its distance from both
// without cancellation. The scalar decides the number of digits.
//
// Error    <= 8 units of rounding of int |f|, with f accurate to rounding: halving the step doubles the digits, and it is
//          halved until two results agree in three quarters of the digits.
#pragma once

#include <limits>

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace patchgrip::contact {

// f(x - lo, hi - x)
template <class Real, class Integrand>
Real integrate_to_both_ends(const Integrand& f, const Real& lo, const Real& hi) {
  static boost::math::quadrature::tanh_sinh<Real> rule(12);  // shared by threads: it locks where it grows
  const Real half = (hi - lo) / 2;
  if (!(half > 0)) return 0;
  const Real tolerance = boost::math::tools::forth_root_epsilon<Real>() * boost::math::tools::root_epsilon<Real>();
  // The rule's second argument is 1 - x in the upper half of [-1, 1], -1 - x in the lower.
  const auto told = [&](const Real&, const Real& c) -> Real {
    return c < 0 ? f(Real(-c * half), Real((2 + c) * half)) : f(Real((2 - c) * half), Real(c * half));
  };
  return half * rule.integrate(told, tolerance);
}

}  // namespace patchgrip::contact
