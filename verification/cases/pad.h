// Soft pads turned about a pole (claims/pad.h): tetrahedra, the pressure given, Coulomb's law at every point.
#pragma once

#include <patchgrip/verification/claims/pad.h>
#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_pad(const Pad& pad, const Setting& setting);

}  // namespace patchgrip::verification
