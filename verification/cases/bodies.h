// The bodies of claims/bodies.h.
#pragma once

#include <patchgrip/verification/claims/bodies.h>
#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

// Both half-spaces on one mesh, the second mirrored in the plane of contact.
Solved solve_elastic_pair(const Setting& setting);
// A quarter of the half-space in tetrahedra.
Solved solve_ellipse(const PressedEllipse& press, const Setting& setting);

}  // namespace patchgrip::verification
