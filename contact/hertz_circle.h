// Hertz contact of two spherical bodies: circle of contact, approach and peak pressure under a normal force.
//
//     a = (3 F R / (4 E*))^(1/3),   delta = a^2 / R,   p_0 = 3 F / (2 pi a^2)    (seed 4.29, corrected: r^2 <= R delta)
//     1 / R = 1 / R_1 + 1 / R_2
//
// A plane has an infinite radius; a hollow (a socket) a negative one, as long as 1/R stays positive.
//
// These three numbers alone, rounded once; the whole contact is AxisymmetricContact<Paraboloid> (paraboloid.h).
//
// Domain   half-space theory: a much smaller than the radii. F > 0, 1/R > 0.
// Units    F [N], R, a, delta [m], E*, p_0 [Pa].
// Error    R, a, delta, p_0: <= 1.01 units of rounding (2^-53), relative to the exact result for the given arguments,
//          also for a ball in a nearly conforming socket: formed in long double and rounded once;
//          tests/contact/hertz_circle_test.cc.
// Fails    where a is not small: at equal load the true circle of a sphere is narrower by (2/15) (a/R)^2, relative;
//          nothing here warns of it.
// Throws   std::invalid_argument, naming the parameter, outside the domain or where a result would overflow or
//          underflow.
#pragma once

namespace patchgrip::contact {

// R [m] from the radii of two spheres; +infinity is a plane, a negative radius a hollow.
double relative_radius(double first, double second);

struct HertzCircle {
  // Throws std::invalid_argument unless all three are positive and finite.
  static HertzCircle under_force(double normal_force, double relative_radius, double contact_modulus);

  double radius;         // a [m]
  double approach;       // delta [m]
  double peak_pressure;  // p_0 [Pa]
};

}  // namespace patchgrip::contact
