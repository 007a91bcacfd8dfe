// Two elastic bodies, and ellipses of contact.
#pragma once

#include <vector>

#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/contact/material.h>
#include <patchgrip/verification/claims/claim.h>
#include <patchgrip/verification/claims/press.h>

namespace patchgrip::verification {

// A sphere on a half-space, both elastic and unlike: the contact of a rigid one on E* (seed 4.1.4).
struct ElasticPair {
  contact::Material first, second;
  PressedBody press;  // its material is not used
};
ElasticPair elastic_pair();

// A rigid body of two curvatures on a half-space, pressed so that the minor semi-axis is about 1 m.
struct PressedEllipse {
  contact::Material material;
  double radius_small, radius_large;  // along y and x [m]
  contact::HertzEllipse library;
  std::vector<Quantity> quantities;
};
PressedEllipse pressed_ellipse(double small_over_large);

}  // namespace patchgrip::verification
