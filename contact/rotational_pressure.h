// Pressures on a circle that are powers of that of Hertz, and the stamps that make them.
//
//     p   = p_0 (1 - rho^2)^(n - 1/2),   rho = r / a,   n = 1, 2, ...             (seed 4.13, corrected by factors n)
//     p_0 = (E*/pi) 4^n n! (n-1)! / (2n)!  a / R,   F = p_0 pi a^2 / (n + 1/2),   delta = a^2 / (n R)
//     f   = (a^2/R) sum_(k=1)^n (-1)^(k+1) (n-1)! (2k)! / (4^k (n-k)! k!^3) rho^(2k)
//         = (delta/N) sum_(j<N) [1 - (1 - rho^2 sin^2(pi j / N))^n],   N > n
//     u_z = (F / (pi E* r)) int_0^1 (1 - s^2)^n (1 - s^2 a^2/r^2)^(-1/2) ds / int_0^1 (1 - s^2)^n ds   outside
//
// R is the radius of curvature of the stamp at its tip, f''(0) = 1/R. The first sum for f loses 2^n to cancellation;
// the second, a trapezoidal rule that is exact here, has only positive terms. n = 1: Hertz (paraboloid.h).
//
// Domain   1 <= n <= 1000; a, R, E* > 0.
// Units    a, R, r, f, delta, u_z [m]; p [Pa], F [N].
// Error    units of 2^-53, relative: 4 of p_0, 6 of F, 3 of delta, 8 + 3n of p (down to 1e-290 p_0), 20 of f (13 of the
//          terms of its sum, 2 of the sum, 5 of the factor), 64 of u_z outside;
//          tests/contact/rotational_pressure_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain or where a result would overflow or
//          underflow.
#pragma once

namespace patchgrip::contact {

struct RotationalPressure {
  static RotationalPressure of_curvature(int n, double contact_radius, double curvature_radius, double contact_modulus);

  // Pressure and displacement are even in r, and NaN of NaN.
  double pressure(double r) const;      // 0 beyond a
  double height(double r) const;        // f, 0 <= r <= a; beyond, the stamp is not determined: refused
  double displacement(double r) const;  // u_z, every r

  int n;
  double radius;            // a [m]
  double curvature_radius;  // R [m]
  double contact_modulus;   // E* [Pa]
  double peak_pressure;     // p_0 [Pa]
  double force;             // F [N]
  double approach;          // delta [m]
};

}  // namespace patchgrip::contact
