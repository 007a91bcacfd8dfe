// Linear elastic material of a body, and the contact modulus of two.
//
//     1 / E* = (1 - nu_1^2) / E_1 + (1 - nu_2^2) / E_2              (seed 4.1.4; Johnson, Contact Mechanics, 4.22)
//
// Domain   E > 0 (infinite for a rigid body, but not both), -1 < nu <= 0.5.
// Units    E, E* [Pa], nu [1].
// Error    E*: <= 1.01 units of rounding (2^-53), relative, for every nu: formed in long double and rounded once;
//          tests/contact/material_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain, and where E* would overflow or underflow.
#pragma once

namespace patchgrip::contact {

struct Material {
  static Material elastic(double youngs_modulus, double poisson_ratio);
  static Material rigid();

  double youngs_modulus;  // E [Pa], > 0
  double poisson_ratio;   // nu [1], in (-1, 0.5]
};

long double plane_compliance(const Material& body);  // (1 - nu^2) / E [1/Pa], 0 for a rigid body

double contact_modulus(const Material& first, const Material& second);

}  // namespace patchgrip::contact
