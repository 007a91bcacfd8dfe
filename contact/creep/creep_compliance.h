// Creep compliance of a linear viscoelastic solid or fluid: the strain after a unit step of stress.
//
//     J(t) = J_0 + sum J_j (1 - exp(-t / lambda_j)) + t / eta_0,    epsilon(t) = int J(t - s) d sigma(s)    (seed 4.15)
//
// the generalised Kelvin-Voigt model: J_0 is the spring, 1 / eta_0 the fluidity. This is the usual
// J_inf + t / eta_0 - sum J_j exp(-t / lambda_j) with J_inf = J_0 + sum J_j, without its cancellation. The seed calls J
// K_E and its slope k_E, and says K_E(inf) = 0: it is J_inf (1/E_inf; infinite in a fluid).
//
// Domain   J_0, 1 / eta_0 >= 0; J_j, lambda_j > 0; not all absent. Modes of one time are merged, the others sorted.
// Units    J [1/Pa], lambda [s], fluidity 1 / eta_0 [1/(Pa s)].
// Error    J(t), J'(t): <= 4 + n / 2 units of rounding (2^-53), relative, n modes: all terms are positive.
//          tests/contact/prony_test.cc.
// Fails    J(t) is zero before the step (t < 0).
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include <patchgrip/contact/creep/mode.h>

namespace patchgrip::contact {

template <class Real>
class BasicCreepCompliance {
 public:
  static BasicCreepCompliance of(Real instantaneous, Modes<Real> modes, Real fluidity = 0) {
    require_non_negative("J_0", static_cast<double>(instantaneous));
    require_non_negative("fluidity", static_cast<double>(fluidity));
    if (instantaneous == 0 && fluidity == 0 && modes.empty()) {
      refuse("J_0", 0, "must be positive where there is neither a mode nor a fluidity");
    }
    return {instantaneous, checked_modes(std::move(modes), "J", "lambda"), fluidity};
  }

  Real operator()(const Real& t) const {
    using std::expm1;
    if (!(t >= 0)) return 0;
    Real sum = instantaneous_;
    for (const auto& mode : modes_) sum -= mode.strength * expm1(-t / mode.time);
    return fluidity_ > 0 ? sum + t * fluidity_ : sum;
  }

  Real slope(const Real& t) const {  // J'(t), without the jump at t = 0 [1/(Pa s)]
    using std::exp;
    if (!(t >= 0)) return 0;
    Real sum = fluidity_;
    for (const auto& mode : modes_) sum += mode.strength / mode.time * exp(-t / mode.time);
    return sum;
  }

  // J_inf [1/Pa] of the springs alone: what a fluid adds, t / eta_0, has no limit.
  Real equilibrium() const {
    Real sum = instantaneous_;
    for (const auto& mode : modes_) sum += mode.strength;
    return sum;
  }

  const Real& instantaneous() const noexcept { return instantaneous_; }  // J_0 [1/Pa]
  const Modes<Real>& modes() const noexcept { return modes_; }           // J_j [1/Pa], lambda_j [s]
  const Real& fluidity() const noexcept { return fluidity_; }            // 1 / eta_0 [1/(Pa s)]

 private:
  BasicCreepCompliance(Real instantaneous, Modes<Real> modes, Real fluidity)
      : instantaneous_(std::move(instantaneous)), modes_(std::move(modes)), fluidity_(std::move(fluidity)) {}

  Real instantaneous_;
  Modes<Real> modes_;
  Real fluidity_;
};

using CreepCompliance = BasicCreepCompliance<double>;

}  // namespace patchgrip::contact
