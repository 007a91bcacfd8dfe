// Linear viscoelastic bodies in contact: what takes the place of the contact modulus E*.
//
//     C(t) = sum over the bodies of (1 - nu^2) J(t)        contact compliance, 1 / E* of an elastic pair
//     M(t) = reciprocal of C                               contact modulus, E* of an elastic pair; E(t) / (1 - nu^2)
//                                                          against a rigid body
//
// An elastic body has a modulus without modes. The seed adds k_E+ and k_E- without the factors (1 - nu^2) (end of
// 4.1.4): with E1 = E2 and nu = 1/2 that makes the relaxed approach 2.33 instead of 2 times the elastic one.
//
// Domain   modes of less than 1e-24 of the compliance, and of its slope, are left out; constant Poisson ratio, -1 < nu
//          <= 0.5.
// Units    C [1/Pa], M [Pa].
// Error    C(0), M(0), modes: <= 2 units of rounding (2^-53), relative: formed in 113 bits from the series of the
//          bodies; tests/contact/contact_creep_test.cc.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <vector>

#include <patchgrip/contact/creep/conversion.h>
#include <patchgrip/contact/material.h>

namespace patchgrip::contact {

struct ViscoelasticMaterial {
  static ViscoelasticMaterial of(RelaxationModulus modulus, double poisson_ratio);
  static ViscoelasticMaterial of(const CreepCompliance& compliance, double poisson_ratio);
  static ViscoelasticMaterial elastic(const Material& material);  // not rigid

  RelaxationModulus modulus;
  CreepCompliance compliance;
  double poisson_ratio;  // nu [1]
};

struct ContactCreep {
  static ContactCreep against_rigid(const ViscoelasticMaterial& body);
  static ContactCreep between(const ViscoelasticMaterial& first, const ViscoelasticMaterial& second);

  // Under a constant force the contact is that of an elastic pair with this E* [Pa] at each time: 1 / C(t).
  double secant_modulus(double t) const { return 1 / compliance(t); }

  CreepCompliance compliance;  // C
  RelaxationModulus modulus;   // M

  // 1 / (lambda_j - tau_i) [1/s], row i: where stress is given the modes lambda live on their own, where strain is
  // given the modes tau; this turns one into the other. In 113 bits, since the times may nearly meet.
  std::vector<std::vector<double>> coupling;
};

}  // namespace patchgrip::contact
