// Displacement around a contact, far from it: arcsin(x/r) of u_z = (2/pi) int arcsin(x/r) dg(x) in powers of x/r,
//
//     sum over n = 1, 3, 5, ... of c_n u^n m_n / n,   u = a/r,   c_n = (1/2)_k / k!,  n = 2k + 1
//
// with the moments m_n of (x/a)^n dg. For a power profile g ~ x^m that is
//
//     int_0^1 (1 - s^m) / sqrt(rho^2 - s^2) ds = sum c_n u^n m / (n (n + m)),   rho = 1/u           (power_profile.h)
//
// All terms are positive: no cancellation where closed forms lose (a/r)^2.
//
// Domain   0 <= u^2 <= 16/25, m_n > 0 and falling; m > 0.
// Error    of the power profile's, u^2 <= 1/2: <= 8 units of 2^-53, relative: 5 of the first term and the last sum (3
//          for m = 2), the rest with its weight of an eighth; 50 digits in Exact.
#pragma once

#include <limits>

namespace patchgrip::contact {

// moment(n) for n = 1, 3, 5, ... in this order.
template <class Real, class Moment>
Real far_series(const Real& u, Moment moment) {
  const Real first = u * moment(1);
  Real rest = 0;  // a small part of the first, so its many roundings do not count
  Real c = u;     // c_n u^n
  for (int n = 3;; n += 2) {
    c *= u * u * (n - 2) / (n - 1);
    const Real term = c / n * moment(n);
    rest += term;
    if (!(term > std::numeric_limits<Real>::epsilon() / 16 * first)) return first + rest;
  }
}

template <class Real>
Real far_displacement(const Real& m, const Real& u) {
  return far_series(u, [&m](int n) -> Real { return m / (n + m); });
}

}  // namespace patchgrip::contact
