// Displacement around a power profile, far from it (power_profile.h):
//
//     int_0^1 (1 - s^m) / sqrt(rho^2 - s^2) ds = sum_k c_k m u^(2k+1) / ((2k+1) (2k+1+m)),   c_k = (1/2)_k / k!
//
// with u = 1/rho. All terms are positive: no cancellation where the closed forms of m = 1, 2 lose (a/r)^2.
//
// Domain   0 <= u^2 <= 1/2, m > 0.
// Error    <= 6 units of 2^-53, relative; 50 digits in Exact.
#pragma once

#include <limits>

namespace patchgrip::contact {

template <class Real>
Real far_displacement(const Real& m, const Real& u) {
  Real sum = 0;
  Real c = u;  // c_k u^(2k+1)
  for (int k = 0;; ++k) {
    const Real odd = 2 * k + 1;
    const Real term = c * m / (odd * (odd + m));
    sum += term;
    if (!(term > std::numeric_limits<Real>::epsilon() / 16 * sum)) return sum;
    c *= u * u * odd / (odd + 1);
  }
}

}  // namespace patchgrip::contact
