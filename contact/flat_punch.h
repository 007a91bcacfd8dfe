// Flat-ended rigid cylinder of radius a: the one round contact whose zone does not grow.
//
//     F = 2 E* a delta,   p = F / (2 pi a sqrt(a^2 - r^2)),   u_z = (2 delta / pi) arcsin(a / r) outside
//     strain energy F^2 / (4 E* a)                             (seed 4.1.1, with delta = F / (2 E* a); Boussinesq 1885)
//
// It is the limit of r^(2n) for n -> infinity, and the building block of every profile (axisymmetric.h).
//
// Domain   a, E* > 0, F or delta > 0.
// Units    a, r, delta, u_z [m], F [N], E*, p [Pa], stiffness [N/m], energy [J].
// Error    units of 2^-53, relative: 2 of F, delta and stiffness, 4 of the energy, 8 of p and of u_z: 4 of the root and
//          4 of the factor of p, 3 of the angle and 5 of the factor of u_z; tests/contact/flat_punch_test.cc.
// Fails    p is +infinity at the edge r = a, where no material follows the theory.
// Throws   std::invalid_argument, naming the parameter, outside the domain or where a result would overflow or
//          underflow.
#pragma once

namespace patchgrip::contact {

struct FlatPunch {
  static FlatPunch under_force(double radius, double normal_force, double contact_modulus);
  static FlatPunch at_approach(double radius, double approach, double contact_modulus);

  // Even in r; NaN of NaN.
  double pressure(double r) const;      // p, 0 beyond the edge
  double displacement(double r) const;  // u_z, every r
  double stiffness() const noexcept { return 2 * contact_modulus * radius; }
  double strain_energy() const noexcept { return force * approach / 2; }

  double radius;           // a
  double contact_modulus;  // E*
  double force;            // F
  double approach;         // delta
};

}  // namespace patchgrip::contact
