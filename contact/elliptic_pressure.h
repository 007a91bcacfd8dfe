// Pressure of a Hertz contact on an ellipse, and the surface of the half-space under it.
//
//     p = p_0 sqrt(1 - x^2/a^2 - y^2/b^2),   F = (2/3) pi a b p_0                                    (seed 4.11, n = 1)
//     u_z = (p_0 a b / E*) [RF(w, B, A) - (x^2/3) RD(B, w, A) - (y^2/3) RD(A, w, B)],   A = a^2 + w,   B = b^2 + w
//
// (the potential integral of the ellipse, Johnson 3.7, in Carlson's forms: its lower limit only shifts the arguments).
// w is the larger root of x^2/(a^2 + w) + y^2/(b^2 + w) = 1 outside and 0 inside, where
//
//     u_z = (p_0 b / E*) [K - (x/a)^2 D - (y/b)^2 B]                                   (complete_elliptic.h; seed 4.11)
//
// Far away u_z -> F / (pi E* r). At w the integrand vanishes, so an error of w does not reach u_z in first order.
//
// Domain   every finite point; 1e-16 <= b/a <= 1, which way round: a >= b.
// Units    a, b, x, y, u_z [m]; p, p_0, E* [Pa]; F [N].
// Error    pressure, normal_force and displacement <= 1.1 units of 2^-53, relative to the exact result for the given
//          numbers, the pressure also next to the rim; tests/contact/elliptic_pressure_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

namespace patchgrip::contact {

struct EllipticPressure {
  static EllipticPressure of(double a, double b, double peak_pressure);

  double pressure(double x, double y) const;  // 0 outside
  double normal_force() const;
  double displacement(double x, double y, double contact_modulus) const;  // u_z, into the body

  double a;              // semi-axis along x [m]
  double b;              // semi-axis along y [m], <= a
  double peak_pressure;  // p_0 [Pa]
};

}  // namespace patchgrip::contact
