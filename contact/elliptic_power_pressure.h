// Pressures on an ellipse that are powers of that of Hertz.
//
//     p     = p_0 (1 - x^2/a^2 - y^2/b^2)^(n - 1/2),   n = 1, 2, ...                                        (seed 4.10)
//     F     = p_0 2 pi a b / (2n + 1)                                                                      (seed 4.11a)
//     u_z   = (p_0 a b / E*) C int_0^(2 pi) [1 - ((x/a) sin t - (y/b) cos t)^2]^n / sqrt(a^2 cos^2 t + b^2 sin^2 t) dt
//     delta = 4 C (p_0/E*) b K,   C = (2n-1)! / (4^n n! (n-1)!)                           (seed 4.10, 4.11b, corrected)
//     f_xx  = 8 n C (p_0/E*) (b/a^2) D,   f_yy = 8 n C (p_0/E*) B / b                       (seed 4.11d,e, corrected)
//
// for points inside; t is the angle of the seed's phi stretched by the axes, which makes slender ellipses harmless. K,
// B, D as in complete_elliptic.h. The stamp delta - u_z is a quadric for n = 1 alone: that case, and its outside, in
// closed form in elliptic_pressure.h.
//
// Domain   1 <= n <= 1000; 0 < b <= a, b/a >= 1e-9; u_z inside and on the rim.
// Units    a, b, x, y, delta, u_z [m], p, p_0, E* [Pa], F [N], curvatures [1/m].
// Error    units of 2^-53, relative: 4 of F, 8 of delta and f_xx, 8 ln(4a/b) of f_yy, 16 + n of p
//          (where 1 - x^2/a^2 - y^2/b^2 > 1e-2) and of u_z;
//          tests/contact/elliptic_power_pressure_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

namespace patchgrip::contact {

struct EllipticPowerPressure {
  static EllipticPowerPressure of(int n, double a, double b, double peak_pressure, double contact_modulus);

  double pressure(double x, double y) const;      // 0 outside
  double displacement(double x, double y) const;  // u_z; throws std::invalid_argument outside

  int n;
  double a;  // semi-axis along x [m]
  double b;  // semi-axis along y [m], <= a
  double peak_pressure;
  double contact_modulus;
  double force;        // F
  double approach;     // delta, u_z of the middle
  double curvature_x;  // f_xx of the stamp at the middle
  double curvature_y;  // f_yy
};

}  // namespace patchgrip::contact
