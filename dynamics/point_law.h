// Friction of a point in one direction: laws of the velocity alone (seed 4.2.1).
//
//     Coulomb       C(v) = -mu_k F_N sgn v                                                              (4.31c)
//     Stribeck      S(v) = -[mu_k + (mu_s - mu_k) exp(-v^2 / v_S^2)] F_N sgn v                          (4.31d)
//     viscous       V(v) = -mu_V F_N v
//     tanh          tanh(a |v|) S(v)                 regularised; the seed's (4.32) lacks the absolute value
//     Karnopp       -f where |v| <= dv and |f| <= mu_s F_N, else C(v)
//
// Signs as friction/twist.h: the force on body A, that opposes its velocity v relative to body B. At v = 0 dry friction
// is what equilibrium asks for: the functions answer 0 there.
//
// Domain   any v. Regularised laws never hold: under any load a tanh law creeps with atanh(f / mu_s F_N) / a, Karnopp's
//          drifts on with up to dv for ever.
// Units    F_N [N], >= 0; v [m/s]; a [s/m]; force [N].
// Error    a few units of rounding of the largest term; tests/dynamics/point_law_test.cc.
// Throws   nothing; Law and its factories have checked the coefficients.
#pragma once

#include <patchgrip/friction/law.h>

namespace patchgrip::dynamics {

using friction::Law;

double coulomb_force(const Law& law, double normal_force, double v) noexcept;
double stribeck_force(const Law& law, double normal_force, double v) noexcept;
double viscous_force(const Law& law, double normal_force, double v) noexcept;

// d(S + V) / dv [N s/m], v != 0. Positive where friction falls faster than viscosity rises.
double friction_slope(const Law& law, double normal_force, double v) noexcept;

double tanh_force(const Law& law, double normal_force, double a, double v) noexcept;

// `load` f [N], `dead_band` dv [m/s].
double karnopp_force(const Law& law, double normal_force, double dead_band, double load, double v) noexcept;

}  // namespace patchgrip::dynamics
