// Paraboloid with a flat end of radius b (a worn ball): f = 0 for r < b, (r^2 - b^2) / (2 R) beyond.
//
//     delta = a S / R,   F/E* = 2 S (2 a^2 + b^2) / (3 R),   S = sqrt(a^2 - b^2)
//     g' = (2 x^2 - b^2) / (R sqrt(x^2 - b^2))
//     p/E* = (1/pi) int_max(r,b)^a g'(x) / sqrt(x^2 - r^2) dx                                            (Ejike 1981)
//     u_z  = (2/pi) int_b^a arcsin(x/r) g'(x) dx
//          = (2/(pi R)) [a S arcsin(a/r) + (S Z - (r^2 - b^2) arctan(S/Z)) / 2],   Z = sqrt(r^2 - a^2),   r > a
//
// p is closed in elliptic integrals; u_z beyond r = sqrt(2) a is a series of positive terms (flat_end_circle.h).
//
// Domain   R, b > 0, a > b.
// Units    R, b, r, a [m]; the rest as in axisymmetric.h.
// Error    units of 2^-53, relative, for the arguments as given: 6 of delta and of g', 10 of F, 32 of p, 48 of u_z, 8
//          of the radius and of S; tests/contact/flat_end_paraboloid_test.cc. Of u_z: its terms together are at most
//          4.15 times their sum (b -> 0, r = sqrt(2) a); with their weights their roundings come to at most 42, and 4
//          are of the factor in front.
// Fails    p(b), logarithmically, and g'(b) are +infinity.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <limits>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/flat_end_circle.h>

namespace patchgrip::contact {

class FlatEndParaboloid {
 public:
  // end_radius = b, curvature_radius = R.
  static FlatEndParaboloid of(double end_radius, double curvature_radius);

  template <class Real>
  Real height(const Real& r) const {
    return r > b_ ? Real((r - b_) * ((r + b_) / R_) / 2) : Real(0);
  }

  template <class Real>
  Real approach(const Real& a) const {
    return approach(known(a));
  }
  template <class Real>
  Real approach(const BasicFlatEndCircle<Real>& a) const {
    return a.radius * (a.reach / R_);
  }

  template <class Real>
  Real approach_slope(const Real& a) const {
    return a < b_ ? Real(0) : approach_slope(known(a));
  }
  template <class Real>
  Real approach_slope(const BasicFlatEndCircle<Real>& a) const {
    return (2 * a.reach + b_ / a.reach * b_) / R_;
  }

  template <class Real>
  Real force(const Real& a) const {
    return force(known(a));
  }
  template <class Real>
  Real force(const BasicFlatEndCircle<Real>& a) const {
    return 2 * a.reach * (2 * a.reach * (a.reach / R_) / 3 + b_ / R_ * Real(b_));
  }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    return pressure(r, known(a));
  }
  template <class Real>
  Real pressure(const Real& r, const BasicFlatEndCircle<Real>& a) const {
    if (r == b_) return std::numeric_limits<Real>::infinity();
    const auto integral = flat_end_integrals(r, a);
    return (2 * integral.of_square - b_ * (b_ * integral.of_one)) / (boost::math::constants::pi<Real>() * R_);
  }

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    return displacement(r, known(a));
  }
  template <class Real>
  Real displacement(const Real& r, const BasicFlatEndCircle<Real>& a) const {
    using std::atan2;
    if (r <= a.radius) return approach(a) - height(r);
    const Real scale = 2 / (boost::math::constants::pi<Real>() * R_);
    if (2 * (a.radius / r) * (a.radius / r) <= 1) {
      const Real beta = b_ / a.radius;
      const Real sigma = a.reach / a.radius;
      const auto moment = [&](int n, const Real& kappa) -> Real {
        return (2 * sigma + n * beta * beta * kappa) / (n + 2);
      };
      return scale * a.radius * a.radius * far_flat_end_displacement(r, a, moment);
    }
    const Real Z = a.tangent(r);
    return scale *
           (a.radius * a.reach * atan2(a.radius, Z) + (a.reach * Z - (r - b_) * (r + b_) * atan2(a.reach, Z)) / 2);
  }

  FlatEndCircle circle(double a) const;
  FlatEndCircle radius_of_approach(double approach) const;
  FlatEndCircle radius_of_force(double force) const;

  double max_radius() const noexcept { return std::numeric_limits<double>::infinity(); }
  ProfileErrors errors() const noexcept { return {6, 10, 32, 48, 8}; }
  double end_radius() const noexcept { return b_; }
  double curvature_radius() const noexcept { return R_; }

 private:
  FlatEndParaboloid(double end_radius, double curvature_radius) : b_(end_radius), R_(curvature_radius) {}

  // g = F = 0 for a within the flat end.
  template <class Real>
  BasicFlatEndCircle<Real> known(const Real& a) const {
    return BasicFlatEndCircle<Real>::of_radius(Real(b_), a > b_ ? a : Real(b_));
  }

  double b_;
  double R_;
};

}  // namespace patchgrip::contact
