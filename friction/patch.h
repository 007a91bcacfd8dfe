// What friction needs to know of a contact patch: its dissipation D and two derivatives.
//
// A patch is a contact zone with a pressure p >= 0. Per unit friction coefficient and unit normal force its rigid-zone
// Coulomb friction dissipates, at the twist v,
//
//     D(v) = integral of |v_P| p / F_N dA,      v_P = (vx - w y, vy + w x)
//
// D is convex and positively homogeneous of degree 1. While slipping the friction wrench is -mu F_N grad D (seed 4.45,
// 4.47): with the pole M and S(M) = integral of |P - M| p / F_N dA it reads D = |w| S and, for w > 0,
//
//     grad D = (dS/dy_M, -dS/dx_M, S - M . grad S) = (I1, I2, a_K I3).
//
// A patch type offers D, grad D and the Hessian; laws of friction, limit surface, grasps and dynamics are written once,
// against this concept. All of it holds at every pole, inside, on the rim, far away and at infinity (w = 0).
//
// At rest       (v = 0) D has a kink: gradient() answers 0, the subgradient of least norm; hessian() throws
//               std::domain_error.
// Scale         a twist may be scaled by any positive number that neither overflows nor underflows it.
// Error         bounded_gradient() carries a bound with the value: |force - true| <= force_error, likewise the moment;
//               each header says how it was found. No term for the rounding of the inputs: they are taken as exact.
#pragma once

#include <concepts>

#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

// First moments of the pressure (seed 4.48c): centroid s_0, and the polar second moment about the centroid, so that
// s_1 = x^2 + y^2 + polar. For a ring of radius a the polar moment is a^2, for a Hertz disc 2 a^2 / 5.
struct PressureMoments {
  double x = 0;      // [m]
  double y = 0;      // [m]
  double polar = 0;  // [m^2]
};

// clang-format off
template <class P>
concept Patch = requires(const P& patch, const Twist& v) {
  { patch.dissipation(v) } noexcept -> std::same_as<double>;              // D(v) [m/s]
  { patch.gradient(v) } noexcept -> std::same_as<Wrench>;                 // grad D [1], [1], [m]
  { patch.bounded_gradient(v) } noexcept -> std::same_as<BoundedWrench>;  // grad D and its error
  { patch.hessian(v) } -> std::same_as<Hessian>;                          // in (vx, vy, w)
  { patch.moments() } noexcept -> std::same_as<PressureMoments>;
  { patch.area_radius() } noexcept -> std::same_as<double>;               // a_K = sqrt(area / pi) [m] (seed 4.20)
};
// clang-format on

}  // namespace patchgrip::friction
