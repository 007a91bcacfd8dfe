// Paraboloid of revolution, f = r^2 / (2 R): Hertz contact of two spherical bodies with a small circle.
//
//     delta = a^2 / R,   F/E* = 4 a^3 / (3 R),   p/E* = (2 / (pi R)) sqrt(a^2 - r^2)                  (seed 4.29)
//     u_z   = [(2 a^2 - r^2) arcsin(a/r) + a sqrt(r^2 - a^2)] / (pi R),   r > a      (Johnson, Contact Mechanics, 3.42)
//
// R is the relative radius of both bodies (hertz_circle.h).
//
// Domain   R > 0. The half-space wants a much smaller than R; at equal load the circle of a true sphere (sphere.h) is
//          narrower by (2/15) (a/R)^2.
// Units    R, r, a [m]; the rest as in axisymmetric.h.
// Error    units of 2^-53, relative: 3 of delta, 4 of F, 5 of p, 3 of the radius, 10 of u_z: 3 of the factor before the
//          bracket, next to the rim 4 of (2 a^2 - r^2) / (a R), 2 of the arcsin and 1 of the sum; far away
//          5 of the factor before the series and 4 of the series;
//          tests/contact/paraboloid_test.cc.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/far_displacement.h>

namespace patchgrip::contact {

class Paraboloid {
 public:
  static Paraboloid of_radius(double relative_radius) {
    return Paraboloid(require_positive("relative_radius", relative_radius));
  }

  template <class Real>
  Real height(const Real& r) const {
    return r * (r / R_) / 2;
  }

  template <class Real>
  Real approach(const Real& a) const {
    return a * (a / R_);
  }

  template <class Real>
  Real approach_slope(const Real& a) const {
    return 2 * a / R_;
  }

  template <class Real>
  Real force(const Real& a) const {
    return 4 * a * approach(a) / 3;
  }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    using std::sqrt;
    return 2 * sqrt(a - r) * sqrt(a + r) / (boost::math::constants::pi<Real>() * R_);
  }

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    using std::atan2;
    using std::sqrt;
    if (r <= a) return approach(a) - height(r);
    const Real u = a / r;
    if (2 * u * u <= 1) return 2 * approach(a) / boost::math::constants::pi<Real>() * far_displacement(Real(2), u);
    const Real root = sqrt(r - a) * sqrt(r + a);
    const Real excess = (a - root) * (1 + root / a) / R_;  // (2 a^2 - r^2) / (a R)
    return a / boost::math::constants::pi<Real>() * (excess * atan2(a, root) + root / R_);
  }

  template <class Real>
  Real radius_of_approach(const Real& approach) const {
    using std::sqrt;
    return sqrt(approach) * sqrt(Real(R_));
  }

  template <class Real>
  Real radius_of_force(const Real& force) const {
    using std::cbrt;
    const Real cube = 3 * force * R_ / 4;
    const Real a = cbrt(cube);
    return a - (a - cube / a / a) / 3;  // the library's cube root may be off by several units
  }

  double max_radius() const noexcept { return std::numeric_limits<double>::infinity(); }
  ProfileErrors errors() const noexcept { return {3, 4, 5, 10, 3}; }
  double relative_radius() const noexcept { return R_; }

 private:
  explicit Paraboloid(double relative_radius) : R_(relative_radius) {}

  double R_;
};

}  // namespace patchgrip::contact
