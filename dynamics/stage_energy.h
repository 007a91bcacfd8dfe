// Energy of one step by implicit stages, for any number of degrees of freedom: what bristle_body.h and stacked_bodies.h
// share.
//
//     work = sum w f . v,     slip = sum w s . e,     damping = sum w kappa'^T D kappa'
//     numerical = h^2 / 2 (a^T M a + kappa'^T K kappa')                                             (implicit Euler)
//     numerical = (gamma - 1/4) h^2 / 2 (da^T M da + dkappa'^T K dkappa'),  d: stage one less two   (SDIRK2)
//
// (w = h times the stage's weight; M, K, D the diagonals of mass, stiffness and damping): by implicit Euler the energy
// of the changes, by SDIRK2 that of the difference of the rates: the matrix b_i a_ij + b_j a_ji - b_i b_j of the method
// is (gamma - 1/4) [1 -1; -1 1]. R. Alexander, SIAM J. Numer. Anal. 14 (1977).
//
// Domain   one or two stages. `numerical` >= 0 for M, K >= 0.
// Units    J; h [s]; stages as their owner's.
// Error    rounding.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include <patchgrip/dynamics/planar_state.h>

namespace patchgrip::dynamics {

inline constexpr double sdirk2_gamma = 1 - 1 / std::numbers::sqrt2;

// All but `numerical`; `weight` in seconds. A stage has load, wrench, twist, slip_rate and deflection_rate().
template <class Stage, class Vector>
void add_stage_energy(StepEnergy& energy, double weight, const Stage& stage, const Vector& D) {
  energy.work += weight * stage.load.dot(stage.twist);
  energy.slip += weight * stage.wrench.dot(stage.slip_rate);
  energy.damping += weight * stage.deflection_rate().dot(D.cwiseProduct(stage.deflection_rate()));
}

template <class Stage, std::size_t n, class Vector>
double numerical_loss(double h, const std::array<Stage, n>& stages, const Vector& M, const Vector& K) {
  static_assert(n == 1 || n == 2);
  const auto energy = [&](const Vector& a, const Vector& rate) {
    return h * h * (a.dot(M.cwiseProduct(a)) + rate.dot(K.cwiseProduct(rate))) / 2;
  };
  if constexpr (n == 1) {
    return energy(stages[0].acceleration, stages[0].deflection_rate());
  } else {
    return (sdirk2_gamma - 0.25) * energy(stages[0].acceleration - stages[1].acceleration,
                                          stages[0].deflection_rate() - stages[1].deflection_rate());
  }
}

}  // namespace patchgrip::dynamics
