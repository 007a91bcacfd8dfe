// Flat punches on the section of a half-space (claims/punch.h).
#pragma once

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_flat_punch(const Setting& setting);
// The shear is at most mu p; loads grow in proportion, so that one step is the whole history (Spence 1968).
Solved solve_rough_punch(const Setting& setting);

}  // namespace patchgrip::verification
