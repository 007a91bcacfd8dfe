// Cone, f = s r: the sharp tip that all hardness tests come back to.
//
//     delta = (pi/2) s a,   F/E* = (pi/2) s a^2,   p/E* = (s/2) arcosh(a/r)                   (Love 1939; Sneddon 1965)
//     u_z   = s [a arcsin(a/r) + sqrt(r^2 - a^2) - r],   r > a
//
// Domain   slope s > 0; small in theory, since surfaces are taken as flat.
// Units    s [1], r, a [m]; the rest as in axisymmetric.h.
// Error    units of 2^-53, relative: 3 of delta, 4 of F, 8 of p, 4 of the radius, 11 of u_z. Of u_z just within
//          r = sqrt(2) a, a difference of terms twice as large: 3 are of the root, 5 of the terms, 3 of the last steps.
//          tests/contact/cone_test.cc.
// Fails    p(0) is +infinity, a logarithm.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/far_displacement.h>

namespace patchgrip::contact {

class Cone {
 public:
  static Cone of_slope(double slope) { return Cone(require_positive("slope", slope)); }

  template <class Real>
  Real height(const Real& r) const {
    return slope_ * r;
  }

  template <class Real>
  Real approach(const Real& a) const {
    return slope_ * boost::math::constants::half_pi<Real>() * a;
  }

  template <class Real>
  Real approach_slope(const Real&) const {
    return slope_ * boost::math::constants::half_pi<Real>();
  }

  template <class Real>
  Real force(const Real& a) const {
    return approach(a) * a;
  }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    using std::asinh;
    using std::log;
    using std::sqrt;
    if (r == 0) return std::numeric_limits<Real>::infinity();
    const Real u = a / r;
    const Real root = sqrt((a - r) / r) * sqrt(u + 1);
    return slope_ * (u < 2 ? Real(asinh(root)) : Real(log(u + root))) / 2;
  }

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    using std::atan2;
    using std::sqrt;
    if (r <= a) return approach(a) - height(r);
    const Real u = a / r;
    if (2 * u * u <= 1) return slope_ * a * far_displacement(Real(1), u);
    const Real root = sqrt(r - a) * sqrt(r + a);
    return slope_ * a * (atan2(a, root) - a / (r + root));
  }

  template <class Real>
  Real radius_of_approach(const Real& approach) const {
    return approach / (slope_ * boost::math::constants::half_pi<Real>());
  }

  template <class Real>
  Real radius_of_force(const Real& force) const {
    using std::sqrt;
    return sqrt(force / (slope_ * boost::math::constants::half_pi<Real>()));
  }

  double max_radius() const noexcept { return std::numeric_limits<double>::infinity(); }
  ProfileErrors errors() const noexcept { return {3, 4, 8, 11, 4}; }
  double slope() const noexcept { return slope_; }

 private:
  explicit Cone(double slope) : slope_(slope) {}

  double slope_;
};

}  // namespace patchgrip::contact
