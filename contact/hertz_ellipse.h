// Hertz contact of two bodies of any curvature: an elliptic zone.
//
// With k = b/a and the integrals K, D of it (ellipse_shape.h), R = R_large, all at one approach delta (seed 4.1.3):
//
//     a^3 = 3 F R D / (pi E*),   b = k a,   p_0 = 3 F / (2 pi a b)
//     delta = p_0 b K / E*,   dF/d(delta) = 3 F / (2 delta)
//     a^2 = 2 R delta D / K,   F = 2 pi a E* delta / (3 K)
//
// The seed writes them with F_1, F_2 and R_e = sqrt(R_1 R_2), where R_1 >= R_2 (not R_2 >= R_1 as printed):
//
//     p_0 = 2 E* sqrt(delta/R_e) / (pi F_1^2 sqrt(F_2)),   F = (4/3) E* sqrt(R_e) (delta/F_2)^(3/2)
//
// which is the same; shape_of() gives F_1, F_2 and the factors of figure 4.11. For the circle see hertz_circle.h.
//
// Domain   half-space theory: a much smaller than the radii of the bodies; no friction. 1e-30 <= R_small/R_large <= 1.
// Units    F [N], R, a, b, delta [m], E*, p_0 [Pa], stiffness [N/m].
// Error    every member <= 1.6 units of 2^-53, relative to the exact result for the given F or delta, R_small, R_large
//          (or 1 - R_small/R_large), E*; tests/contact/hertz_ellipse_test.cc. Made through RelativeRadii::of_bodies:
//          its errors come on top, relative errors of R_small and R_large as at most 2/3 of themselves.
// Fails    where a is not small against the radii: nothing here warns of it.
// Throws   std::invalid_argument, naming the parameter, outside the domain or where a result would not be
//          representable.
#pragma once

#include <patchgrip/contact/ellipse_shape.h>
#include <patchgrip/contact/elliptic_pressure.h>
#include <patchgrip/contact/relative_radii.h>

namespace patchgrip::contact {

EllipseShape<long double> shape_of(const RelativeRadii& radii);

struct HertzEllipse {
  static constexpr double error_units = 1.6;

  static HertzEllipse under_force(double normal_force, const RelativeRadii& radii, double contact_modulus);
  static HertzEllipse at_approach(double approach, const RelativeRadii& radii, double contact_modulus);

  EllipticPressure elliptic_pressure() const { return EllipticPressure::of(a, b, peak_pressure); }

  double normal_force;   // F [N]
  double approach;       // delta [m]
  double a;              // major semi-axis, along the direction of R_large [m]
  double b;              // minor semi-axis [m]
  double one_minus_b_a;  // 1 - b/a [1]
  double eccentricity;   // e [1]
  double peak_pressure;  // p_0 [Pa]
  double stiffness;      // dF/d(delta) [N/m]
};

}  // namespace patchgrip::contact
