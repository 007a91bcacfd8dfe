// Laws of friction on a patch: Coulomb, Stribeck in the mean, viscous, and their sum.
//
// With the pressure centroid s_0 = (x, y), the mean square speed v_m^2 and the twist v = (vx, vy, w), the wrench on
// body A is
//
//     t = -mu(v_m) F_N grad D(v) - mu_V F_N [vx - w y,  vy + w x,  x vy - y vx + w s_1]
//
//     mu(v_m) = mu_k + (mu_s - mu_k) exp(-v_m^2 / v_S^2)                                (4.45, 4.48a, 4.49)
//     v_m^2   = integral of |v_P|^2 p / F_N dA = |v_c|^2 + w^2 s_c
//
// where v_c is the velocity of the centroid and s_c the polar second moment about it. This is the seed's (4.48b) with
// its pole term corrected from M . s_0 to -2 M . s_0; written about the centroid, nothing cancels. For a pure
// translation Stribeck in the mean is Stribeck at every point.
//
// Domain   any twist; at rest the wrench is 0 (which wrench in the limit surface acts then is a question of
//          equilibrium).
// Units    mu_k, mu_s [1], v_S [m/s], mu_V [s/m], F_N [N]; wrench [N], [N], [N m].
// Error    carried: that of grad D, plus a few units of rounding for mu, v_m^2 and the viscous part;
//          tests/friction/law_test.cc.
// Throws   std::invalid_argument, naming the parameter, where a coefficient is negative or not finite or v_S is not
//          positive.
#pragma once

#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

struct Law {
  static Law coulomb(double mu);
  static Law stribeck(double mu_static, double mu_kinetic, double stribeck_velocity);
  static Law viscous(double mu_viscous);

  // The same law with a viscous part added.
  Law with_viscous(double mu_viscous) const;

  double mu_kinetic = 0;         // mu_k [1], >= 0
  double mu_static = 0;          // mu_s [1], >= 0; equal to mu_k for Coulomb
  double stribeck_velocity = 1;  // v_S [m/s], > 0; without effect when mu_s = mu_k
  double mu_viscous = 0;         // mu_V [s/m], >= 0
};

// v_m^2 [m^2/s^2].
double mean_square_speed(const PressureMoments& moments, const Twist& v) noexcept;

// mu(v_m) [1].
double coefficient(const Law& law, const PressureMoments& moments, const Twist& v) noexcept;

// Friction wrench from grad D at the twist v; `normal_force` F_N [N], >= 0.
BoundedWrench friction_wrench(const Law& law, double normal_force, const PressureMoments& moments,
                              const BoundedWrench& gradient, const Twist& v) noexcept;

template <Patch P>
BoundedWrench friction_wrench(const Law& law, double normal_force, const P& patch, const Twist& v) noexcept {
  return friction_wrench(law, normal_force, patch.moments(), patch.bounded_gradient(v), v);
}

}  // namespace patchgrip::friction
