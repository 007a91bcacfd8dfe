// Rigid sphere, exactly: f = R - sqrt(R^2 - r^2), pressed in as far as its equator.
//
// With a / R = q = tanh s,  y = x / R:
//
//     g   = x artanh(y),   delta = R s q,   F/E* = R^2 [(1 + q^2) s - q] = R^2 sum_(k>=1) 4k / (4k^2 - 1) q^(2k+1)
//     p/E* = (1/pi) int_r^a [artanh(y) + y / (1 - y^2)] / sqrt(x^2 - r^2) dx
//          = (1/pi) [V / k + k int_0^V (artanh(y) / y) sech^2 v dv]
//
// where x^2 = r^2 + (R^2 - r^2) tanh^2 v, k = sqrt(1 - r^2/R^2) and V = arsinh(sqrt(a^2 - r^2) / sqrt(R^2 - a^2)).
// The first part is closed; the integrand of the second is analytic for |Im v| < pi/2 and integrated by Gauss-Legendre
// rules on pieces no longer than 5/4 in v, whose remainder is below 1e-18 of it (Bernstein ellipse of half-axes sum 4).
//
//     u_z = (2/pi) int_0^a arcsin(x/r) dg(x) = (2/pi) {s [a A + Z] - R A + k arctan[k a / (R Z)]},   r > a
//
// with A = arcsin(a/r), Z = sqrt(r^2 - a^2), k = sqrt(R^2 - r^2); for r > R the last term is k artanh with the opposite
// sign. That cancels for a small a/R and far away, where the integral is taken by the same rules: with x = r sin w for
// a <= R/2, in two pieces (half-axes sum 5), with x = R tanh v beyond r = sqrt(2) a (4).
//
// The series of the seed (4.14 superposed) is PowerSum::sphere_series in power_sum.h.
//
// Close to the equator neighboring doubles a are far apart in force: from a = R (1 - 1e-16) on, all loads have the same
// double a. SphereCircle is the radius as the library knows it, by s: radius_of_force returns it, and 1 - a/R =
// 2 / (exp(2 s) + 1) keeps all its digits.
//
// Domain   R > 0, 0 < a < R. Half-space and small-strain theory, taken at its word: beyond a/R of about 1/2 both fail.
// Units    R, r, a [m]; the rest as in axisymmetric.h.
// Error    units of 2^-53, relative: 4 of delta, 14 of F, 8 of p, 64 of u_z, 6 of the radius and of s, over the whole
//          domain; tests/contact/sphere_test.cc. Of F: around a = 3/4 R its terms are good to 12 with their weights,
//          most of that from the rounding of a/R, and 2 are of the factor R^2. Of u_z: the terms of the closed form
//          together are at most 6 times their sum (a = R/2, r = sqrt(2) a), each is good to 10, and 3 are of the
//          factor.
// Fails    beyond its equator the sphere has no height: f is +infinity for r > R.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <cmath>
#include <concepts>
#include <limits>

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <patchgrip/contact/axisymmetric.h>

namespace patchgrip::contact {

// Contact circle of radius a = R tanh s.
struct SphereCircle {
  double sphere_radius;  // R [m]
  double s;              // artanh(a/R)

  operator double() const noexcept { return sphere_radius * std::tanh(s); }      // a
  double one_minus_ratio() const noexcept { return 2 / (std::exp(2 * s) + 1); }  // 1 - a/R
  // How far a moves when s does, relatively.
  double spread(double relative) const noexcept {
    const double sech = 1 / std::cosh(s);
    return relative * s * sphere_radius * sech * sech;
  }
};

class Sphere {
 public:
  static Sphere of_radius(double radius) { return Sphere(require_positive("radius", radius)); }

  template <class Real>
  Real height(const Real& r) const {
    using std::sqrt;
    if (r > R_) return std::numeric_limits<Real>::infinity();
    return r * (r / (R_ + sqrt(R_ - r) * sqrt(R_ + r)));
  }

  template <class Real>
  Real approach(const Real& a) const {
    return a * artanh_ratio(a);
  }
  double approach(const SphereCircle& a) const { return R_ * a.s * std::tanh(a.s); }

  template <class Real>
  Real approach_slope(const Real& a) const {
    return artanh_ratio(a) + a / (R_ - a) * (R_ / (R_ + a));
  }
  double approach_slope(const SphereCircle& a) const { return a.s + std::sinh(2 * a.s) / 2; }

  template <class Real>
  Real force(const Real& a) const {
    return R_ * (R_ * unit_force(Real(a / R_), artanh_ratio(a)));
  }
  double force(const SphereCircle& a) const { return R_ * (R_ * unit_force(std::tanh(a.s), a.s)); }

  template <class Real>
  Real pressure(const Real& r, const Real& a) const {
    using std::sqrt;
    return pressure_within(r, Real(sqrt(a - r) * sqrt(a + r) / (sqrt(R_ - a) * sqrt(R_ + a))));
  }
  double pressure(double r, const SphereCircle& a) const;

  template <class Real>
  Real displacement(const Real& r, const Real& a) const {
    if (r <= a) return approach(a) - height(r);
    return displacement_around(r, Real(r - a), Real(R_ - a), a, artanh_ratio(a));
  }
  double displacement(double r, const SphereCircle& a) const;

  SphereCircle circle(double a) const;
  SphereCircle radius_of_approach(double approach) const;
  SphereCircle radius_of_force(double force) const;

  double max_radius() const noexcept { return R_; }
  ProfileErrors errors() const noexcept { return {4, 14, 8, 64, 6}; }
  double radius() const noexcept { return R_; }

 private:
  explicit Sphere(double radius) : R_(radius) {}

  // s of a = R tanh s
  template <class Real>
  Real artanh_ratio(const Real& a) const {
    using std::atanh;
    using std::log;
    return 2 * a < R_ ? Real(atanh(a / R_)) : Real(log((R_ + a) / (R_ - a)) / 2);
  }

  template <class Real>
  static Real unit_force(const Real& q, const Real& s) {
    if (4 * q > 3) return q * q * s + (s - q);
    Real sum = 0;
    Real power = q;
    for (int k = 1;; ++k) {
      power *= q * q;
      const Real term = power * (4 * k) / (4 * Real(k) * k - 1);
      sum += term;
      if (!(term > std::numeric_limits<Real>::epsilon() / 16 * sum)) return sum;
    }
  }

  template <class Real>
  static Real artanh_per_y(const Real& y, const Real& one_minus_y2) {
    using std::atanh;
    using std::log;
    if (y == 0) return 1;
    return (y < 0.5 ? Real(atanh(y)) : Real(log((1 + y) * (1 + y) / one_minus_y2) / 2)) / y;
  }

  // Of which the poles at +-i pi/2 are far enough.
  template <class Real>
  static int pieces(const Real& last) {
    using std::ceil;
    return 1 + static_cast<int>(ceil(last * (std::same_as<Real, double> ? 0.8 : 2)));
  }

  template <class Real, class Integrand>
  static Real in_pieces(const Integrand& f, const Real& last, int count) {
    using Rule = boost::math::quadrature::gauss<Real, std::same_as<Real, double> ? 15 : 30>;
    Real sum = 0;
    for (int i = 0; i < count; ++i) sum += Rule::integrate(f, Real(last * i / count), Real(last * (i + 1) / count));
    return sum;
  }

  // p/E* with sinh V given.
  template <class Real>
  Real pressure_within(const Real& r, const Real& sinh_V) const {
    using std::asinh;
    using std::cosh;
    using std::sqrt;
    using std::tanh;
    constexpr bool is_double = std::same_as<Real, double>;
    const Real y0 = r / R_;
    const Real k2 = (R_ - r) / R_ * ((R_ + r) / R_);
    const Real k = sqrt(k2);
    const Real V = asinh(sinh_V);
    const Real last = is_double && V > 24 ? Real(24) : V;  // sech^2 v v < 1e-19 from there on
    const auto integrand = [&](const Real& v) -> Real {
      const Real t = tanh(v);
      const Real sech = 1 / cosh(v);
      return artanh_per_y(Real(sqrt(y0 * y0 + k2 * t * t)), Real(k2 * sech * sech)) * sech * sech;
    };
    const Real sum = in_pieces(integrand, last, pieces<Real>(last));
    return (V / k + k * sum) / boost::math::constants::pi<Real>();
  }

  // beyond = r - a, lacking = R - a.
  template <class Real>
  Real displacement_around(const Real& r, const Real& beyond, const Real& lacking, const Real& a, const Real& s) const {
    using std::sqrt;
    const Real Z = sqrt(beyond) * sqrt(r + a);
    const Real shape = 2 * a <= R_                  ? narrow_integral(r, Z, a)
                       : 2 * (a / r) * (a / r) <= 1 ? far_integral(r, s)
                                                    : near_integral(r, Z, lacking, a, s);
    return 2 / boost::math::constants::pi<Real>() * shape;
  }

  // With x = r sin w; at most half as wide as the sphere, g' is far from its poles.
  template <class Real>
  Real narrow_integral(const Real& r, const Real& Z, const Real& a) const {
    using std::atan2;
    using std::cos;
    using std::sin;
    const auto rate = [&](const Real& w) -> Real { return w * approach_slope(Real(r * sin(w))) * (r * cos(w)); };
    return in_pieces(rate, Real(atan2(a, Z)), std::same_as<Real, double> ? 2 : 4);
  }

  // With x = R tanh v.
  template <class Real>
  Real far_integral(const Real& r, const Real& s) const {
    using std::asin;
    using std::cosh;
    using std::tanh;
    constexpr bool is_double = std::same_as<Real, double>;
    const Real last = is_double && s > 24 ? Real(24) : s;  // tanh v = 1 from there on, v sech^2 v = 0
    const auto rate = [&](const Real& v) -> Real {
      const Real sech = 1 / cosh(v);
      return (tanh(v) + v * sech * sech) * asin(R_ / r * tanh(v));
    };
    const Real inner = in_pieces(rate, last, pieces<Real>(last));
    return R_ * (s > last ? Real(inner + (s - last) * asin(R_ / r)) : inner);
  }

  // The closed form; k^2 = |R^2 - r^2|.
  template <class Real>
  Real near_integral(const Real& r, const Real& Z, const Real& lacking, const Real& a, const Real& s) const {
    using std::atan;
    using std::atan2;
    using std::log;
    using std::sqrt;
    const Real A = atan2(a, Z);
    if (r < R_) {
      const Real k = sqrt(R_ - r) * sqrt(R_ + r);
      const Real sag = r / (R_ + k) * r;  // R - k
      const Real lag = atan(sag / (R_ * (Z / a) + k * (a / Z)));
      return A * (a * s - sag) + (Z * s - k * lag);
    }
    const Real k = sqrt(r - R_) * sqrt(r + R_);
    return A * (a * s - R_) + s * (lacking / (Z + k) * (R_ + a)) - k * log((R_ / r * Z + k / r * a) / (R_ + a));
  }

  double R_;
};

}  // namespace patchgrip::contact
