// Friction cones cut into edges: least grip as a linear programme, on a known side of the exact one.
//
// With k edges a round, all of them on the limit surface of the cone (the inner cone):
//
//     point          k on a circle                              contains the exact cone of c mu, c = cos(pi/k)
//     soft linear    k on a circle, and +-mu e of pure spin     c = cos(pi/k)
//     soft elliptic  k meridians, k/2 - 1 parallels, two poles  c = cos(pi/k) / sqrt(1 + sin(pi/k)^2)
//
// The outer cone is the inner one over c: it contains the exact cone of mu and lies in that of mu / c. Their least grip
// is therefore bounded by that of the exact cones,
//
//     s(mu) <= s_inner <= s(c mu)            s(mu / c) <= s_outer <= s(mu)
//
// Near the limit of what can be held the right sides may be infinite: the inner cone then says "cannot", the outer one
// "holds", at any k. The error is of second order in 1/k, the work of first order, of second for soft elliptic fingers.
//
// Units    as contact.h and spatial.h.
// Error    [lower, upper] of the linear programme, mostly 1e-8 apart, up to 1e-5 where few edges bear; of the cut the
//          bounds above.
// Throws   std::invalid_argument unless k is a multiple of 4 in [4, 1024]; on exact patches; and as Grasp does.
#pragma once

#include <vector>

#include <patchgrip/grasp/contact.h>
#include <patchgrip/grasp/grip_settings.h>

namespace patchgrip::grasp {

enum class CutSide { inner, outer };

// c, 1 for frictionless contacts.
double cut_factor(const FrictionCone& cone, int edges);

// Friction of the edges per unit normal force.
std::vector<Vector3> cone_edges(const FrictionCone& cone, int edges, CutSide side);

struct LinearisedGrip {
  double lower = 0;  // of min max F_i with the cut cones [N]
  double upper = 0;  // infinite if no forces were found
  Vector6 escape_twist = Vector6::Zero();
  std::vector<ContactForce> forces;
  int iterations = 0;
};

LinearisedGrip linearised_least_grip(const std::vector<Contact>& contacts, const Vector6& load, int edges, CutSide side,
                                     const GripSettings& settings = {});

}  // namespace patchgrip::grasp
