// The hemisphere of rubber of claims/rubber.h: displacement and pressure (Taylor-Hood), the plate comes in steps.
//
// The radius of contact is that of the area that touches, as it lies on the plate: a^2 = 2 int |F^-T n| r ds.
#pragma once

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_rubber_hemisphere(const Setting& setting);

}  // namespace patchgrip::verification
