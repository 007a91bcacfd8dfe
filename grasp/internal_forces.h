// Forces that the contacts can exchange without loading the object: the null space of the grasp matrix.
//
//     sum G_i x_i = 0,  G_i of the components that contact i can transmit: F, R_u, R_v (point), R_M (soft, patch)
//
// Its dimension is sum d_i - rank G. Cones are left out here: which internal forces are admissible, and whether any lies
// strictly inside, Grasp::force_closure answers; the forces of its proof, one added to each F, are a squeeze.
//
// The seed's F = B^+ b for frictionless contacts is here as well, with its sign put right (-B F = b): the forces of least
// norm, whether they press or pull. Where one is negative the answer says nothing of the grasp.
//
// Units    forces in N, moments in N m; the basis is orthonormal with moments over the contacts' moment lengths e.
// Error    rounding: a few units of 2^-53 times the condition of G, relative to the largest component.
#pragma once

#include <vector>

#include <patchgrip/grasp/contact.h>

namespace patchgrip::grasp {

struct InternalForces {
  int rank = 0;                                  // of G
  int components = 0;                            // sum d_i
  std::vector<std::vector<ContactForce>> basis;  // components - rank of them, each with one force a contact
};

InternalForces internal_forces(const std::vector<Contact>& contacts);

struct LeastNormForces {
  std::vector<double> normal_forces;   // [N]
  Vector6 residual = Vector6::Zero();  // of the balance; what no normal force resists
  int rank = 0;                        // of B
};

LeastNormForces least_norm_forces(const std::vector<Contact>& contacts, const Vector6& load);

}  // namespace patchgrip::grasp
