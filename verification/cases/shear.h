// Partial slip and full stick of a circle on a half-space (claims/shear.h), each on the section of revolution.
//
// Torsion has one displacement, u_theta(r, z). Shear is the first harmonic around the axis,
//
//     (u_r, u_theta, u_z) = (U cos theta, V sin theta, W cos theta),
//
// with a traction q(r) along x alone, as Cattaneo and Mindlin take it: it is the exact one for nu = 0.
#pragma once

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_torsion(const Setting& setting);
Solved solve_shear(const Setting& setting);
Solved solve_stuck_circle(const Setting& setting);

}  // namespace patchgrip::verification
