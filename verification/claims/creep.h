// A paraboloid on a standard linear solid: held, pressed harder and harder, pressed and released.
//
// E(t) = E_2 + E_1 exp(-t/tau) at a constant Poisson ratio, so that every modulus fades alike; tau = 1 s, t up to 3 s.
// Or the shear modulus fades alone, as CalculiX has it: in the transforms
//
//     1 / E* = (1 / G + 3 / (3 K + G)) / 4,   4 pi u_r = F (r Z / q^3 / G - 3 r / (q (q + Z)) / (3 K + G))
//
// (u_z alike; half_space.h) are sums of two compliances of standard linear solids.
//
// Library: Lee and Radok while the contact grows, Ting while it shrinks (contact/creep/press_under_force.h). The seed's
// relation (4.72, contact/creep/seed_creep.h) is claimed to be wrong.
#pragma once

#include <vector>

#include <patchgrip/contact/creep/history.h>
#include <patchgrip/contact/material.h>
#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

struct CreepingPress {
  contact::Material glassy;          // at t = 0
  double fading_share;               // E_1 / (E_1 + E_2)
  bool bulk_fades;                   // as all moduli; else the bulk modulus stays
  double fading_time;                // tau [s]
  double sphere_radius;              // R [m]
  contact::History force;            // [N]
  double end;                        // [s]
  std::vector<double> times;         // of the quantities [s]
  std::vector<Quantity> quantities;  // approach over time; the seed's, where it has one
};

// A force and an elastic body, which moves as much far from the contact.
struct FarField {
  double force;  // [N]
  contact::Material material;
};
FarField far_field(const CreepingPress& press, double t);

CreepingPress held();
CreepingPress shear_held();
CreepingPress shear_held_by_calculix();
CreepingPress ramped();
CreepingPress released();

}  // namespace patchgrip::verification
