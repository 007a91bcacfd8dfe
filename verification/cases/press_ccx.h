// The rigid sphere of claims/press.h at a given approach, by CalculiX: the second opinion.
//
// Quadrilaterals of eight nodes with reduced integration (CAX8R), contact surface to surface with a linear penalty of
// 10^4 E*/a; the rigid body is a strip of elements all of whose nodes are held. A hole of 0.003 a keeps faces of
// contact off the axis, where ccx gets their pressure wrong. It prints the force of a sector of 2 degrees.
#pragma once

#include <patchgrip/verification/study.h>

namespace patchgrip::verification {

Solved solve_press_by_calculix(const Setting& setting);

}  // namespace patchgrip::verification
