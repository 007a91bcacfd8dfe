// Stress below the middle of a circular Hertz contact, and where the body yields first.
//
// On the axis, at depth z with s = z / a (Johnson, Contact Mechanics, 3.45; compression negative):
//
//     sigma_z = -p_0 / (1 + s^2)
//     sigma_r = sigma_theta = -p_0 [(1 + nu) (1 - s arctan(1/s)) - 1 / (2 (1 + s^2))]
//     tau     = |sigma_z - sigma_r| / 2                                          the largest shear stress at that depth
//
// tau peaks below the surface, at the root of (1 + nu) [arctan(1/s) - s/(1 + s^2)] = 3 s / (1 + s^2)^2: at 0.481 a with
// 0.310 p_0 for nu = 0.3.
//
// Domain   p_0, a > 0, -1 < nu <= 0.5, z >= 0.
// Units    p_0, stresses [Pa], a, z [m], nu [1].
// Error    units of 2^-53: sigma_z 4 relative; sigma_r 8 of p_0; tau 12 of itself and 2 of p_0 / (1 + s^2); depth 12
//          relative, max_shear 8 relative; tests/contact/hertz_axis_stress_test.cc.
// Throws   std::invalid_argument outside the domain; std::runtime_error where the depth is not found.
#pragma once

#include <cmath>
#include <limits>

namespace patchgrip::contact {

class HertzAxisStress {
 public:
  static HertzAxisStress of(double peak_pressure, double contact_radius, double poisson_ratio);

  template <class Real>
  Real axial(const Real& z) const {
    const Real s = z / a_;
    return -p0_ / (1 + s * s);
  }

  template <class Real>
  Real radial(const Real& z) const {
    const Real s = z / a_;
    return -p0_ * ((1 + Real(nu_)) * one_minus_s_arctan(s) - 1 / (2 * (1 + s * s)));
  }

  template <class Real>
  Real shear(const Real& z) const {
    using std::atan;
    const Real s = z / a_;
    if (s >= 1) return p0_ / 2 * (3 / (2 * (1 + s * s)) - (1 + Real(nu_)) * one_minus_s_arctan(s));
    if (s == 0) return p0_ / 2 * (0.5 - Real(nu_));
    // Next to the surface of an incompressible body tau itself vanishes.
    return p0_ / 2 * ((0.5 - Real(nu_)) + s * ((1 + Real(nu_)) * atan(1 / s) - 3 * s / (2 * (1 + s * s))));
  }

  double depth_of_max_shear() const;
  double max_shear() const { return shear(depth_of_max_shear()); }

  double peak_pressure() const noexcept { return p0_; }
  double contact_radius() const noexcept { return a_; }
  double poisson_ratio() const noexcept { return nu_; }

 private:
  HertzAxisStress(double peak_pressure, double contact_radius, double poisson_ratio)
      : p0_(peak_pressure), a_(contact_radius), nu_(poisson_ratio) {}

  // Deep down 1 - s arctan(1/s) ~ 1/(3 s^2): Euler's series in w = 1/(1 + s^2), positive terms.
  template <class Real>
  static Real one_minus_s_arctan(const Real& s) {
    using std::atan;
    if (s < 1) return s == 0 ? Real(1) : Real(1 - s * atan(1 / s));
    const Real w = 1 / (1 + s * s);
    Real sum = 0;
    Real term = w;  // (2k-2)!! / (2k-1)!! w^k
    for (int k = 1;; ++k) {
      const Real next = term / (2 * k + 1);
      sum += next;
      if (!(next > std::numeric_limits<Real>::epsilon() / 16 * sum)) return sum;
      term *= w * (2 * k) / (2 * k + 1);
    }
  }

  double p0_;
  double a_;
  double nu_;
};

}  // namespace patchgrip::contact
