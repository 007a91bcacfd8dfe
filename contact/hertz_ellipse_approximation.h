// Hertz ellipse without elliptic integrals: powers of the radii only.
//
//     b/a = q^(2/3),   sqrt(a b) = (3 F R_G / (4 E*))^(1/3),   p_0 = 3 F / (2 pi a b),   delta = a b / sqrt(R_1 R_2)
//     q = R_small / R_large,   R_G = [(1/R_1)(1/R_2)(1/R_1 + 1/R_2) / 2]^(-1/3)
//
// (R_G: Greenwood, Tribology Int. 30, 1997.) With sqrt(R_1 R_2) in place of R_G, a b would be worse by a factor of 15
// at q = 0.1.
//
// Domain   1e-4 <= q <= 1.
// Units    as hertz_ellipse.h.
// Error    with L = ln(1/q), relative to hertz_ellipse.h, each to one side and rising with L:
//              b/a     too small by at most  0.0031 L^3 / (1 + 0.04 L^2)        (0.1 % at q = 0.5, 3.2 % at 0.1)
//              a b     too large by at most  3.9e-4 L^4 / (1 + 0.1 L^2 + 3e-4 L^4)   (9e-5, 0.7 %); p_0 is too small
//                      by that
//              delta   too small by at most  0.014 L^2 / (1 + 0.074 L^2 + 1e-4 L^4)  (0.7 %, 5.4 %)
//          each plus 16 units of 2^-53 of rounding. These bounds are at most 1.2 times the measured error for
//          L > 0.1; members *_error carry them to the results; tests/contact/hertz_ellipse_approximation_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

#include <patchgrip/contact/relative_radii.h>

namespace patchgrip::contact {

struct HertzEllipseApproximation {
  static constexpr double smallest_ratio = 1e-4;

  static HertzEllipseApproximation under_force(double normal_force, const RelativeRadii& radii, double contact_modulus);

  double a;              // major semi-axis [m]
  double b;              // minor semi-axis [m]
  double peak_pressure;  // p_0 [Pa]
  double approach;       // delta [m]
  double a_error;        // bounds of the relative errors [1]
  double b_error;
  double peak_pressure_error;
  double approach_error;
};

}  // namespace patchgrip::contact
