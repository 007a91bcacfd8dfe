// The models with one dashpot: Poynting-Thomson (standard linear solid), Kelvin-Voigt, Maxwell.
//
//     Poynting-Thomson   E(t) = E_2 + E_1 exp(-t E_1 / eta)              E_1 in series with eta, parallel to E_2
//                        K_E(t) = (1 + (E_1 / E_2)(1 - exp(-alpha t))) / (E_1 + E_2)
//                        k_E(t) = k_E(0) exp(-alpha t)                                         (seed 4.16, 4.15)
//                        k_E(0) = E_1^2 / (eta (E_1 + E_2)^2),   alpha = E_1 E_2 / (eta (E_1 + E_2))
//     Kelvin-Voigt       E(t) = E_2 + eta dirac(t),         J(t) = (1 - exp(-t E_2 / eta)) / E_2     (E_1 = infinity)
//     Maxwell            E(t) = E_1 exp(-t E_1 / eta),      J(t) = 1 / E_1 + t / eta                 (E_2 = 0)
//
// What the seed calls the equilibrium epsilon(t_0) = sigma / (E_1 + E_2) is the instantaneous state; the equilibrium is
// sigma / E_2.
//
// Domain   E_1, E_2, eta > 0.
// Units    E_1, E_2 [Pa], eta [Pa s].
// Error    K_E, k_E, alpha: <= 6 units of rounding (2^-53), relative, times 1 + alpha t in k_E; tau: <= 1 unit.
//          tests/contact/prony_test.cc.
// Throws   std::invalid_argument outside the domain, or where E_1 + E_2 or alpha would overflow or underflow.
#pragma once

#include <patchgrip/contact/creep/relaxation_modulus.h>

namespace patchgrip::contact {

RelaxationModulus kelvin_voigt(double E2, double eta);
RelaxationModulus maxwell(double E1, double eta);

struct PoyntingThomson {
  static PoyntingThomson of(double E1, double E2, double eta);

  RelaxationModulus modulus() const;
  double retardation_rate() const noexcept;    // alpha [1/s]
  double creep(double t) const noexcept;       // K_E [1/Pa], 0 for t < 0
  double creep_rate(double t) const noexcept;  // k_E [1/(Pa s)], 0 for t < 0

  double E1;   // [Pa]
  double E2;   // [Pa]
  double eta;  // [Pa s]
};

}  // namespace patchgrip::contact
