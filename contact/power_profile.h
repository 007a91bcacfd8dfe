// Stamp whose height is a power of the radius: f = h (r / l)^m, any real m > 0.
//
//     C   = sqrt(pi) Gamma(m/2 + 1) / Gamma(m/2 + 1/2)
//     g   = C f(a),   F/E* = 2 m / (m + 1) g a,   a ~ F^(1 / (m + 1))                        (Sneddon 1965)
//     p   = (E* m g / (pi a)) I_m(rho),   I_m(rho) = int_rho^1 s^(m-1) / sqrt(s^2 - rho^2) ds,   rho = r / a
//     u_z = (2 g / pi) int_0^1 (1 - s^m) / sqrt(rho^2 - s^2) ds,   rho > 1
//
// m = 2n are the even profiles of Shtaerman (seed 4.14 with the missing factor 1/sqrt(pi) and the sum from k = 0; p is
// then a polynomial times sqrt(1 - rho^2)); m = 1 is the cone; for m -> infinity a flat punch of radius l.
//
// Domain   0 < m <= 1000, h, l > 0.
// Units    h, l, a [m], m [1]; the rest as in axisymmetric.h.
// Error    m + 8 units of 2^-53 of f, g, F; m + 32 of p, 2 m + 32 of u_z; radius 4 + 8 / m; all relative and over the
//          whole domain: tests/contact/power_profile_test.cc.
// Fails    p(0) is +infinity for m <= 1: logarithmic for m = 1, r^(m-1) below; integrable.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/far_displacement.h>

namespace patchgrip::contact {

class PowerProfile {
 public:
  // f(at_radius) = height.
  static PowerProfile through(double height, double at_radius, double exponent);
  // f = coefficient r^exponent; coefficient [m^(1-m)].
  static PowerProfile of_coefficient(double coefficient, double exponent);

  template <class Real>
  Real height(const Real& r) const {
    using std::pow;
    return r == 0 ? Real(0) : Real(height_ * pow(r / length_, Real(exponent_)));
  }

  template <class Real>
  Real approach(const Real& a) const {
    return constant<Real>() * height(a);
  }

  template <class Real>
  Real approach_slope(const Real& a) const {
    return exponent_ * approach(a) / a;
  }

  template <class Real>
  Real force(const Real& a) const {
    return 2 * exponent_ / (exponent_ + Real(1)) * approach(a) * a;
  }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    return approach_slope(a) / boost::math::constants::pi<Real>() * pressure_shape(r, a);
  }

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    if (r <= a) return approach(a) - height(r);
    return 2 * approach(a) / boost::math::constants::pi<Real>() * displacement_shape(r, a);
  }

  double radius_of_approach(double approach) const;
  double radius_of_force(double force) const;
  double max_radius() const noexcept { return std::numeric_limits<double>::infinity(); }

  ProfileErrors errors() const noexcept {
    const double m = exponent_;
    return {m + 8, m + 8, m + 32, 2 * m + 32, 4 + 8 / m};
  }

  double exponent() const noexcept { return exponent_; }

 private:
  PowerProfile(double height, double at_radius, double exponent);

  template <class Real>
  Real constant() const {
    if constexpr (std::same_as<Real, double>) {
      return constant_;
    } else {
      return gamma_constant<Real>(exponent_);
    }
  }

  template <class Real>
  static Real gamma_constant(double m) {
    return boost::math::constants::root_pi<Real>() * boost::math::tgamma_ratio(Real(m) / 2 + 1, (Real(m) + 1) / 2);
  }

  // I_m(rho). From 0 < m <= 2 upwards by (m - 1) I_m = sqrt(1 - rho^2) + (m - 2) rho^2 I_(m-2): positive terms only.
  template <class Real>
  Real pressure_shape(const Real& r, const Real& a) const {
    using std::ceil;
    using std::sqrt;
    const Real rho = r / a;
    const Real w = (a - r) / a * ((a + r) / a);             // 1 - rho^2
    const Real rho2 = 4 * w < 1 ? Real(1 - w) : rho * rho;  // near the rim every step counts its rounding
    const Real root = sqrt(w);
    const int steps = exponent_ > 2 ? static_cast<int>(ceil(exponent_ / 2 - 1)) : 0;
    if (steps > 0 && rho < std::numeric_limits<Real>::epsilon() / 8) return 1 / (Real(exponent_) - 1);
    Real m = Real(exponent_) - 2 * steps;
    Real shape = lowest_shape(m, rho, rho2, w);
    for (int i = 0; i < steps; ++i) {
      shape = (root + m * rho2 * shape) / (m + 1);
      m += 2;
    }
    return shape;
  }

  // 0 < m <= 2. Near the rim the series in 1 - rho^2; else the range of s is cut at sqrt(2) rho: the inner part is the
  // rim's value scaled, the outer the series of 1 / sqrt(s^2 - rho^2) in rho / s.
  template <class Real>
  static Real lowest_shape(const Real& m, const Real& rho, const Real& rho2, const Real& w) {
    using std::abs;
    using std::expm1;
    using std::log;
    using std::pow;
    using std::sqrt;
    if (m == 2) return sqrt(w);
    const auto rim = [&m](const Real& w_) -> Real {
      Real sum = 0;
      Real term = 1;
      for (int k = 0;; ++k) {
        sum += term;
        if (!(term > std::numeric_limits<Real>::epsilon() / 16 * sum)) return sqrt(w_) * sum;
        term *= w_ * (k + 1 - m / 2) / (k + Real(3) / 2);
      }
    };
    if (2 * rho2 >= 1) return rim(w);
    if (rho == 0) return m > 1 ? Real(1 / (m - 1)) : std::numeric_limits<Real>::infinity();
    const Real cut = boost::math::constants::root_two<Real>() * rho;
    const Real scale = pow(cut, m) / cut;  // a small m - 1 is rounded, and its power shows that
    // (cut^(m-1) - 1) / (1 - m); expm1 of a large number is as many units off as the number says.
    const Real power_log = (m - 1) * log(cut);
    Real outer = m == 1 ? Real(-log(cut)) : Real((abs(power_log) < 1 ? Real(expm1(power_log)) : scale - 1) / (1 - m));
    Real c = 1;
    Real power = 1;  // rho^(2k)
    Real half = 1;   // 2^(-k)
    for (int k = 1;; ++k) {
      c *= (2 * k - Real(1)) / (2 * k);
      power *= rho2;
      half /= 2;
      const Real term = c * (scale * half - power) / (2 * k + 1 - m);
      outer += term;
      if (!(scale * half > std::numeric_limits<Real>::epsilon() / 16 * outer)) break;
    }
    return scale * rim(Real(0.5)) + outer;
  }

  // int_0^1 (1 - s^m) / sqrt(rho^2 - s^2) ds. Far away the binomial series; near the rim s = rho sin t, cut at t =
  // pi/4: below, the far value at rho = sqrt(2) scaled; above, Gauss-Legendre of the smooth 1 - (rho sin t)^m.
  template <class Real>
  Real displacement_shape(const Real& r, const Real& a) const {
    using std::asin;
    using std::expm1;
    using std::log;
    using std::pow;
    using std::sin;
    const Real m(exponent_);
    const Real u = a / r;
    if (2 * u * u <= 1) return far_displacement(m, u);
    constexpr bool is_double = std::same_as<Real, double>;
    using Rule = boost::math::quadrature::gauss<Real, is_double ? 15 : 30>;
    const Real quarter = boost::math::constants::quarter_pi<Real>();
    const Real log_rho = log(r / a);
    const Real log_cut = log_rho - boost::math::constants::ln_two<Real>() / 2;
    const Real end = asin(u);
    const int panels = (is_double ? 1 : 3) * (1 + static_cast<int>(exponent_ / 8));
    Real sum = 0;
    for (int i = 0; i < panels; ++i) {
      const Real lo = quarter + (end - quarter) * i / panels;
      const Real hi = quarter + (end - quarter) * (i + 1) / panels;
      sum += Rule::integrate([&](const Real& t) -> Real { return -expm1(m * (log_rho + log(sin(t)))); }, lo, hi);
    }
    return sum - quarter * expm1(m * log_cut) +
           pow(r / a / boost::math::constants::root_two<Real>(), m) *
               far_displacement(m, Real(1 / boost::math::constants::root_two<Real>()));
  }

  double height_;    // h [m]
  double length_;    // l [m]
  double exponent_;  // m
  double constant_;  // C
};

}  // namespace patchgrip::contact
