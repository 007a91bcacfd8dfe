// Cone with a flat end of radius b (a worn tip): f = 0 for r < b, s (r - b) beyond. Any piecewise linear profile is a
// sum of such cones (point_profile.h).
//
//     delta = s a t,   F/E* = s (a^2 t + b S),   S = sqrt(a^2 - b^2),   t = arccos(b/a)
//     g' = s (arccos(b/x) + b / sqrt(x^2 - b^2))
//     p/E* = (s/pi) [int_M^a arccos(b/x) / sqrt(x^2 - r^2) dx + b int_M^a dx / sqrt((x^2-b^2)(x^2-r^2))], M = max(r, b)
//     u_z  = (2/pi) int_b^a arcsin(x/r) g'(x) dx
//          = (2 s/pi) [t (a arcsin(a/r) + Z) + b B - r arctan((r/b) tan B)],   tan B = S/Z, Z = sqrt(r^2 - a^2), r > a
//                                                                                                        (Ejike 1981)
//
// In u_z the last arctan is taken as B and a lead, or as t and a lag where the flat end is small, so that nothing
// cancels; beyond r = 5/4 a it is a series of positive terms. The second integral of p is elliptic (for both see
// flat_end_circle.h). The first, by parts and with x = b / cos(v), is that of a logarithm that never changes sign,
//
//     v_M L(M) + int_(v_M)^t L(b / cos v) dv,   L(x) = ln [(a + sqrt(a^2 - r^2)) / (x + sqrt(x^2 - r^2))],
//
// and is integrated numerically, to rounding.
//
// Domain   s, b > 0, a > b.
// Units    s [1], b, r, a [m]; the rest as in axisymmetric.h.
// Error    units of 2^-53, relative, for the arguments as given: 6 of delta and of g', 8 of F, 32 of p, 48 of u_z, 8 of
//          the radius and of S; tests/contact/flat_end_cone_test.cc. Of u_z: where the closed form cancels
//          most (b = S, r = 5/4 a) the roundings of its terms, with their weights, come to 42, and 3 are of the factor
//          in front.
// Fails    p(b), logarithmically, and g'(b) are +infinity.
// Throws   std::invalid_argument outside the domain; std::runtime_error where the radius is not found.
#pragma once

#include <cmath>
#include <limits>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/contact/flat_end_circle.h>

namespace patchgrip::contact {

class FlatEndCone {
 public:
  // end_radius = b, slope = s.
  static FlatEndCone of(double end_radius, double slope);

  template <class Real>
  Real height(const Real& r) const {
    return r > b_ ? Real(slope_ * (r - b_)) : Real(0);
  }

  template <class Real>
  Real approach(const Real& a) const {
    return approach(known(a));
  }
  template <class Real>
  Real approach(const BasicFlatEndCircle<Real>& a) const {
    using std::atan;
    return slope_ * a.radius * atan(a.reach / b_);
  }

  template <class Real>
  Real approach_slope(const Real& a) const {
    return a < b_ ? Real(0) : approach_slope(known(a));
  }
  template <class Real>
  Real approach_slope(const BasicFlatEndCircle<Real>& a) const {
    using std::atan;
    return slope_ * (atan(a.reach / b_) + b_ / a.reach);
  }

  template <class Real>
  Real force(const Real& a) const {
    return force(known(a));
  }
  template <class Real>
  Real force(const BasicFlatEndCircle<Real>& a) const {
    using std::atan;
    return slope_ * (a.radius * (a.radius * atan(a.reach / b_)) + b_ * a.reach);
  }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    return pressure(r, known(a));
  }
  template <class Real>
  Real pressure(const Real& r, const BasicFlatEndCircle<Real>& a) const {
    if (r == b_) return std::numeric_limits<Real>::infinity();
    return slope_ / boost::math::constants::pi<Real>() * (arccos_integral(r, a) + b_ * flat_end_integrals(r, a).of_one);
  }

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    return displacement(r, known(a));
  }
  template <class Real>
  Real displacement(const Real& r, const BasicFlatEndCircle<Real>& a) const {
    using std::atan;
    using std::atan2;
    if (r <= a.radius) return approach(a) - height(r);
    const Real t = atan(a.reach / b_);
    const Real scale = 2 * slope_ / boost::math::constants::pi<Real>();
    if (5 * a.radius <= 4 * r) {
      const Real beta = b_ / a.radius;
      const auto moment = [&](int n, const Real& kappa) -> Real { return (t + n * beta * kappa) / (n + 1); };
      return scale * a.radius * far_flat_end_displacement(r, a, moment);
    }
    const Real Z = a.tangent(r);
    const Real A = atan2(a.radius, Z);
    const Real B = atan2(a.reach, Z);
    if (a.reach > b_) {
      const Real tip = a.radius / (r + Z);
      const Real lag = atan(a.reach * tip * (a.radius / (b_ * Z + r * (a.reach / b_ * a.reach))));
      return scale * (t * (a.radius * (A - tip)) + b_ * B - r * lag);
    }
    const Real lead = atan((r - b_) / (b_ * (Z / a.reach) + r * (a.reach / Z)));
    return scale * (t * (a.radius * A + Z) - (r - b_) * B - r * lead);
  }

  FlatEndCircle circle(double a) const;
  FlatEndCircle radius_of_approach(double approach) const;
  FlatEndCircle radius_of_force(double force) const;

  double max_radius() const noexcept { return std::numeric_limits<double>::infinity(); }
  ProfileErrors errors() const noexcept { return {6, 8, 32, 48, 8}; }
  double end_radius() const noexcept { return b_; }
  double slope() const noexcept { return slope_; }

 private:
  FlatEndCone(double end_radius, double slope) : b_(end_radius), slope_(slope) {}

  // g = F = 0 for a within the flat end.
  template <class Real>
  BasicFlatEndCircle<Real> known(const Real& a) const {
    return BasicFlatEndCircle<Real>::of_radius(Real(b_), a > b_ ? a : Real(b_));
  }

  template <class Real>
  Real arccos_integral(const Real& r, const BasicFlatEndCircle<Real>& a) const {
    using std::atan;
    using std::cos;
    using std::log1p;
    using std::sin;
    using std::sqrt;
    const Real& radius = a.radius;
    const Real chord = a.half_chord(r);  // sqrt(a^2 - r^2)
    const Real last = atan(a.reach / b_);
    const Real apart = sqrt(r > b_ ? r - b_ : b_ - r) * sqrt(r + b_);  // sqrt |r^2 - b^2|
    const Real first = r > b_ ? Real(atan(apart / b_)) : Real(0);
    // L(x), with x, sqrt(x^2 - r^2) and a - x given.
    const auto log_ratio = [&](const Real& x, const Real& x_chord, const Real& before) -> Real {
      return log1p(before * (1 + (radius + x) / (chord + x_chord)) / (x + x_chord));
    };
    const auto integrand = [&](const Real& since, const Real& left) -> Real {
      const Real x = radius * (b_ / (b_ * cos(left) + a.reach * sin(left)));
      const Real before = 2 * x * (radius / b_) * sin(last - left / 2) * sin(left / 2);
      if (r > b_) {
        const Real past = 2 * x * (r / b_) * sin(first + since / 2) * sin(since / 2);  // x - r
        return log_ratio(x, Real(sqrt(past) * sqrt(x + r)), before);
      }
      const Real tangent = sin(since) * x;  // b tan v
      return log_ratio(x, Real(sqrt(tangent * tangent + apart * apart)), before);
    };
    const Real integral = integrate_to_both_ends(integrand, first, last);
    if (r < b_) return integral;
    return integral + first * log_ratio(r, Real(0), Real(chord / (radius + r) * chord));
  }

  double b_;
  double slope_;
};

}  // namespace patchgrip::contact
