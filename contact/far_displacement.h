// Displacement around a power profile, far from it (power_profile.h):
//
//     int_0^1 (1 - s^m) / sqrt(rho^2 - s^2) ds = sum_k c_k m u^(2k+1) / ((2k+1) (2k+1+m)),   c_k = (1/2)_k / k!
//
// with u = 1/rho. All terms are positive: no cancellation where the closed forms of m = 1, 2 lose (a/r)^2.
//
// Domain   0 <= u^2 <= 1/2, m > 0.
// Error    <= 8 units of 2^-53, relative: 6 of the first term and the last sum (4 for m = 2), 2 of the rest; 50 digits in
//          Exact.
#pragma once

#include <limits>

namespace patchgrip::contact {

template <class Real>
Real far_displacement(const Real& m, const Real& u) {
  const Real first = u * m / (1 + m);
  Real rest = 0;           // less than an eighth of the first, so its many roundings do not count
  Real c = u / 2 * u * u;  // c_k u^(2k+1)
  for (int k = 1;; ++k) {
    const Real odd = 2 * k + 1;
    const Real term = c * m / (odd * (odd + m));
    rest += term;
    if (!(term > std::numeric_limits<Real>::epsilon() / 16 * first)) return first + rest;
    c *= u * u * odd / (odd + 1);
  }
}

}  // namespace patchgrip::contact
