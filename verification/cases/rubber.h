// The hemisphere of rubber of claims/rubber.h: displacement and pressure (Taylor-Hood), the plate comes in steps.
//
// The radius of contact is that of the area that touches, as it lies on the plate: a^2 = 2 int |F^-T n| r ds. Of the
// fingertip a first mesh finds its edge, a second one is fine there.
#pragma once

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_rubber_hemisphere(const Setting& setting);
Solved solve_fingertip(const Setting& setting);

}  // namespace patchgrip::verification
