// Stiffness of a pressed half-space: how the force grows with the approach.
//
//     dF / d(delta) = E* sum of q dA,   K q = 1 in the contact, q = 0 outside          (K: convolution.h)
//
// A small change of the approach moves the contact, at fixed contact, like a flat punch: what it adds at the edge is of
// second order, as p is zero there. For a circle 2 E* a, whatever the shape (Johnson 3.36; seed 4.29). q has the
// punch's singularity at the edge: the stiffness converges with order one.
//
// Domain   a free surface.
// Units    [N/m].
// Error    half the difference to the same contact on cells of twice the side. Right within a factor 3 for a punch; on
//          Hertz' contact far on the safe side: its counted cells reach as much too far as cells are too stiff at the
//          edge, and the true error is below 0.1 cells over the radius. tests/contact/stiffness_test.cc.
// Throws   std::invalid_argument for a periodic surface, where the mean displacement is infinite; std::runtime_error,
//          with the residual, without convergence.
#pragma once

#include <patchgrip/contact/half_space/press.h>

namespace patchgrip::contact {

Estimate contact_stiffness(const PressedHalfSpace& pressed, const PressSettings& settings = {});

}  // namespace patchgrip::contact
