// Contact circle of a stamp with a flat end of radius b, and what flat-ended profiles share.
//
// The reach S = sqrt(a^2 - b^2) is the natural size of the contact: force and approach vanish with S like S^1, while
// a - b does like S^2. So a load inversion finds S, and this is the radius as the library knows it. With M and m the
// larger and the smaller of r and b, and sin^2 w = (a^2 - M^2) / (a^2 - m^2):
//
//     int_M^a dx     / sqrt((x^2 - b^2)(x^2 - r^2)) = (1/M) sin w R_F(cos^2 w, c, 1)
//     int_M^a x^2 dx / sqrt((x^2 - b^2)(x^2 - r^2)) = a sin w + (m^2 / 3M) sin^3 w R_D(cos^2 w, c, 1)
//     c = 1 - (m/M)^2 sin^2 w                                     (Carlson's forms; DLMF 19.25, all terms positive)
//
// Far away arcsin(x/r) of u_z = (2/pi) int_b^a arcsin(x/r) g'(x) dx is expanded in x/r. Every moment of g' then follows
// from kappa_n = a^-n int_b^a x^n / sqrt(x^2 - b^2) dx, upwards from kappa_1 = S/a with positive terms only:
//
//     n kappa_n = S/a + (n - 1) (b/a)^2 kappa_(n-2)
//
// Units    lengths [m]; the integrals [1/m] and [m].
// Error    of the integrals <= 8 units of 2^-53, relative; tests/contact/flat_end_paraboloid_test.cc.
// Fails    both integrals are infinite at r = b, logarithmically; 0 for r >= a.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

#include <patchgrip/contact/far_displacement.h>

namespace patchgrip::contact {

template <class Real>
struct BasicFlatEndCircle {
  static BasicFlatEndCircle of_radius(const Real& end, const Real& a) {
    using std::sqrt;
    return {end, Real(sqrt(a - end) * sqrt(a + end)), a, true};
  }
  static BasicFlatEndCircle of_reach(const Real& end, const Real& reach) {
    using std::sqrt;
    return {end, reach,
            end > reach ? Real(end * sqrt(1 + reach / end * (reach / end)))
                        : Real(reach * sqrt(1 + end / reach * (end / reach))),
            false};
  }

  operator Real() const noexcept { return radius; }
  double spread(double relative) const noexcept { return relative * (reach * (reach / radius)); }

  // sqrt(a^2 - r^2), 0 for r > a
  Real half_chord(const Real& r) const {
    using std::sqrt;
    if (by_radius || r < end) return r < radius ? Real(sqrt(radius - r) * sqrt(radius + r)) : Real(0);
    const Real beyond = sqrt(r - end) * sqrt(r + end);
    return beyond < reach ? Real(sqrt(reach - beyond) * sqrt(reach + beyond)) : Real(0);
  }

  // sqrt(r^2 - a^2), 0 for r < a
  Real tangent(const Real& r) const {
    using std::sqrt;
    if (by_radius) return r > radius ? Real(sqrt(r - radius) * sqrt(r + radius)) : Real(0);
    if (!(r > end)) return 0;
    const Real beyond = sqrt(r - end) * sqrt(r + end);
    return beyond > reach ? Real(sqrt(beyond - reach) * sqrt(beyond + reach)) : Real(0);
  }

  Real end;        // b [m]
  Real reach;      // S [m]
  Real radius;     // a [m]
  bool by_radius;  // a is given and S follows, or the other way round
};

using FlatEndCircle = BasicFlatEndCircle<double>;

template <class Real>
struct FlatEndIntegrals {
  Real of_one;     // int dx / sqrt((x^2 - b^2)(x^2 - r^2)) [1/m]
  Real of_square;  // int x^2 dx / ... [m]
};

template <class Real>
FlatEndIntegrals<Real> flat_end_integrals(const Real& r, const BasicFlatEndCircle<Real>& a) {
  using boost::math::ellint_rd;
  using boost::math::ellint_rf;
  using std::abs;
  const Real larger = std::max(r, a.end);
  const Real smaller = std::min(r, a.end);
  if (r == a.end) return {std::numeric_limits<Real>::infinity(), std::numeric_limits<Real>::infinity()};
  const Real wide = a.half_chord(smaller);
  const Real sin = a.half_chord(larger) / wide;
  const Real cos2 = abs(r - a.end) / wide * ((r + a.end) / wide);
  const Real c = cos2 * (a.radius / larger) * (a.radius / larger);
  const Real ratio = smaller / larger;
  return {sin * ellint_rf(cos2, c, Real(1)) / larger,
          a.radius * sin + larger * ratio * ratio * sin * sin * sin * ellint_rd(cos2, c, Real(1)) / 3};
}

// The series of far_displacement.h, its moments moment(n, kappa_n).
template <class Real, class Moment>
Real far_flat_end_displacement(const Real& r, const BasicFlatEndCircle<Real>& a, const Moment& moment) {
  const Real beta = a.end / a.radius;
  const Real sigma = a.reach / a.radius;
  return far_series(Real(a.radius / r), [&, kappa = sigma](int n) mutable -> Real {
    if (n > 1) kappa = (sigma + (n - 1) * beta * beta * kappa) / n;
    return moment(n, kappa);
  });
}

}  // namespace patchgrip::contact
