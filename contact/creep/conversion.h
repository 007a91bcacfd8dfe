// From relaxation modulus to creep compliance and back.
//
//     int_0^t E(t - s) dJ(s) = 1  for every t > 0,      J_0 = 1 / E_0,   J_inf = 1 / E_inf
//     E_inf = 0:  1 / eta_0 = 1 / (eta + sum E_i tau_i),       eta > 0:  J_0 = 0
//     J_0 = 0:  eta = 1 / (1 / eta_0 + sum J_j / lambda_j)
//
// The times interlace, tau_1 < lambda_1 < tau_2 < ..., which brackets every root (reciprocal_modes.h).
//
// Units    as in relaxation_modulus.h and creep_compliance.h.
// Error    of the functions on double: <= 1.01 units of rounding (2^-53) in every strength, time and constant,
//          relative: formed in 113 bits and rounded once. 1 to 20 modes, times over 12 decades and times 1e-9 apart:
//          tests/contact/prony_test.cc.
// Throws   std::runtime_error if a root does not settle; std::invalid_argument if a result overflows or underflows.
#pragma once

#include <patchgrip/contact/creep/creep_compliance.h>
#include <patchgrip/contact/creep/reciprocal_modes.h>
#include <patchgrip/contact/creep/relaxation_modulus.h>

namespace patchgrip::contact {

template <class Real>
BasicCreepCompliance<Real> reciprocal(const BasicRelaxationModulus<Real>& modulus) {
  std::vector<SecularPole<Real>> poles;
  Real viscosity = modulus.dashpot();
  if (modulus.dashpot() > 0) poles.push_back({Real(0), modulus.dashpot()});
  for (const auto& mode : modulus.modes()) {
    poles.push_back({mode.time, mode.strength * mode.time});
    viscosity += poles.back().weight;
  }
  Modes<Real> modes;
  for (const auto& root : reciprocal_modes<Real>(modulus.equilibrium(), poles)) {
    modes.push_back({root.strength, root.place});
  }
  return BasicCreepCompliance<Real>::of(modulus.dashpot() > 0 ? Real(0) : 1 / modulus.instantaneous(), std::move(modes),
                                        modulus.equilibrium() > 0 ? Real(0) : 1 / viscosity);
}

template <class Real>
BasicRelaxationModulus<Real> reciprocal(const BasicCreepCompliance<Real>& compliance) {
  std::vector<SecularPole<Real>> poles;
  Real rate = compliance.fluidity();  // J'(0)
  for (const auto& mode : compliance.modes()) {
    poles.push_back({1 / mode.time, mode.strength / mode.time});
    rate += poles.back().weight;
  }
  if (compliance.fluidity() > 0) poles.push_back({Real(0), compliance.fluidity()});
  std::reverse(poles.begin(), poles.end());
  Modes<Real> modes;
  for (const auto& root : reciprocal_modes<Real>(compliance.instantaneous(), poles)) {
    modes.push_back({root.strength, 1 / root.place});
  }
  return BasicRelaxationModulus<Real>::of(compliance.fluidity() > 0 ? Real(0) : 1 / compliance.equilibrium(),
                                          std::move(modes), compliance.instantaneous() > 0 ? Real(0) : 1 / rate);
}

CreepCompliance creep_compliance(const RelaxationModulus& modulus);
RelaxationModulus relaxation_modulus(const CreepCompliance& compliance);

}  // namespace patchgrip::contact
