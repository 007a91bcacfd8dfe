// A paraboloid on a standard linear solid (claims/creep.h), step by step.
//
// What fades is a strain h at every point of integration: h <- exp(-dt/tau) h + (tau/dt) (1 - exp(-dt/tau)) (eps - eps
// before), exact for strains that are linear over a step. The stress is the glassy one of (E_2 eps + E_1 h) / (E_1 +
// E_2). Between two times of the claim there are n / 3 steps, n the elements per contact radius.
#pragma once

#include <patchgrip/verification/claims/creep.h>
#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_creep(const CreepingPress& press, const Setting& setting);

}  // namespace patchgrip::verification
