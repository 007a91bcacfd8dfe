// One step of Newton's method for the gauge, about the centroid (pressure_frame.h).
//
//     (D H + grad D grad D^T) s = t - (t . v / D) grad D
//
// with the twist at its best length (gauge_solver.h). The matrix is raised by some roundings of its trace: it is
// singular where all the pressure lies on a line, and D the same for many poles.
//
// Units    as gauge.h; spins times the radius of gyration.
// Error    a step that is wrong costs evaluations only.
// Throws   nothing.
#pragma once

#include <optional>

#include <patchgrip/friction/limit_surface/pressure_frame.h>

namespace patchgrip::friction {

struct NewtonStep {
  Vector step;
  bool flat;  // in some direction the curvature of D is none that rounding of the gradient could tell
};

// `v` about the origin, where the gradient is `g` about the centroid and D(v) = `D`; `value` = t . v / D. None where
// the Hessian is infinite, and next to it.
std::optional<NewtonStep> newton_step(const PatchView& patch, const PressureFrame& frame, const Vector& t,
                                      const Twist& v, const Vector& g, double D, double value) noexcept;

}  // namespace patchgrip::friction
