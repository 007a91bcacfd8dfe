// A rigid flat punch of radius 1 m: without friction, and with it (Spence's stick zone, seed 4.1.4).
#pragma once

#include <vector>

#include <patchgrip/contact/flat_punch.h>
#include <patchgrip/contact/material.h>
#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

struct Punch {
  contact::Material material;
  contact::FlatPunch library;
  std::vector<double> radii;  // where p is compared [m]
  std::vector<Quantity> quantities;
};

Punch flat_punch();
std::vector<Quantity> flat_punch_at_approach();  // its force and pressure, where the approach is given

struct RoughPunch {
  contact::Material material;
  double force;  // [N]
  double mu;
  std::vector<Quantity> quantities;
};

RoughPunch rough_punch();

}  // namespace patchgrip::verification
