// Rigid bodies of revolution pressed into a half-space without friction: claims/press.h solved with fe/half_space.h.
#pragma once

#include <patchgrip/verification/claims/press.h>
#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_press(const PressedBody& body, const Setting& setting);

}  // namespace patchgrip::verification
