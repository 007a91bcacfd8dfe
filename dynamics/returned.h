// What a return mapping answers: the closest wrench that friction admits, and the slip that goes with it.
//
// Bristles of stiffness K carry the wrench s = K kappa. Where the trial s* = K (kappa + dx) lies outside of the
// admissible wrenches C = L B, L = mu F_N, it is brought back to the closest one in the norm of K^-1:
//
//     s = argmin over C of |s* - s|_{K^-1},     u = K^-1 (s* - s) = argmin of  L D(u) + u . K u / 2 - s* . u
//
// (implicit Euler of the associated flow; J. C. Simo, T. J. R. Hughes, Computational Inelasticity, 1998, ch. 3). The
// dissipation s . u = L D(u) is never negative: 0 is in C. It sticks, u = 0 exactly, if and only if s* is in C, g(s*)
// <= L: no creep. Any K symmetric and positive definite, any history of L >= 0.
//
// Sign     s is what the bristles do to the contact zone; friction does -s to body A, whose motion is dx.
// Units    s [N], [N], [N m]; u [m], [m], [rad].
#pragma once

#include <patchgrip/friction/twist.h>

namespace patchgrip::dynamics {

struct Returned {
  friction::BoundedWrench wrench;  // s and its error
  friction::Twist slip;            // u
  bool slips = false;
  int evaluations = 0;  // of grad D
};

}  // namespace patchgrip::dynamics
