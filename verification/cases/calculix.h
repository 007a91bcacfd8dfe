// Cases that CalculiX solves as well: the second opinion (fe/calculix_press.h).
//
// The sphere and the flat punch are given the approach, GetFEM the force. The creeping solid is two sets of elements on
// the same nodes, of which one creeps in proportion to its stress: a standard linear solid, whose bulk stays elastic.
#pragma once

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_press_by_calculix(const Setting& setting);
Solved solve_flat_punch_by_calculix(const Setting& setting);
Solved solve_creep_by_calculix(const Setting& setting);

}  // namespace patchgrip::verification
