// The least grip of fingers whose contacts grow with the force that presses them.
//
//     a = (3 F R / 4 E*)^(1/3), so that the moment that a Hertz disc bears grows like F^(4/3)
//
// What such a contact admits is closed under more force, but neither a cone nor convex: min max F has no dual. With all
// contacts as large as under a grip s, the convex problem has an optimum p(s), which falls with s:
//
//     lower    s with p(s) = s: below it no way of holding exists, for no contact could be larger than at s
//     upper    forces F_i admissible with contacts no larger than under F_i themselves
//
// Where all fingers press alike at the optimum (two fingers, symmetric grasps) the two meet; elsewhere the bracket is
// open by what the weaker fingers' smaller contacts cost.
//
// Units    N.
// Error    the bracket; where it meets, about 1e-13 of the value.
// Throws   std::invalid_argument on loads that are not finite, and what the contacts throw.
#pragma once

#include <functional>
#include <vector>

#include <patchgrip/grasp/grasp.h>

namespace patchgrip::grasp {

// A contact under a normal force F > 0; its friction per unit normal force must not fall with F.
using GrowingContact = std::function<Contact(double normal_force)>;

struct GrowingGrip {
  Verdict verdict = Verdict::undecided;
  double lower = 0;
  double upper = 0;
  GripAnswer lower_answer;  // of the convex problem at the lower bound: its twist is the certificate
  GripAnswer upper_answer;  // forces that hold
};

GrowingGrip least_growing_grip(const std::vector<GrowingContact>& contacts, const Vector6& load,
                               const GripSettings& settings = {});

}  // namespace patchgrip::grasp
