// Relaxation modulus of a linear viscoelastic solid or fluid: the stress after a unit step of strain.
//
//     E(t) = E_inf + sum E_i exp(-t / tau_i) + eta dirac(t),      sigma(t) = int E(t - s) d epsilon(s)
//     E'(w) + i E''(w) = E_inf + sum E_i i w tau_i / (1 + i w tau_i) + i w eta
//
// the generalised Maxwell (Wiechert, Prony) model: springs with dashpots in series, all of them parallel to a spring
// E_inf and a dashpot eta. E_inf = 0 is a fluid; eta > 0 resists every jump of the strain (Kelvin-Voigt).
//
// Domain   E_inf, eta >= 0; E_i, tau_i > 0; not all of them absent. Modes of one time are merged, the others sorted.
// Units    E [Pa], tau [s], eta [Pa s], w [rad/s].
// Error    E(t), E_0: <= 3 + n / 2 units of rounding (2^-53), relative, n modes, and the rounding of t / tau_i: the
//          mean of t / tau_i over the shares of the modes in E(t), in units. E' and E'': <= 6 + n / 2 units each.
//          tests/contact/prony_test.cc.
// Fails    E(t) is zero before the step (t < 0); E(0) is E(0+) without the dashpot, which is the impulse at t = 0.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include <patchgrip/contact/creep/mode.h>

namespace patchgrip::contact {

template <class Real>
struct DynamicModulus {
  Real storage;  // E' [Pa]
  Real loss;     // E'' [Pa]
};

template <class Real>
class BasicRelaxationModulus {
 public:
  static BasicRelaxationModulus of(Real equilibrium, Modes<Real> modes, Real dashpot = 0) {
    require_non_negative("E_inf", static_cast<double>(equilibrium));
    require_non_negative("eta", static_cast<double>(dashpot));
    if (equilibrium == 0 && dashpot == 0 && modes.empty()) {
      refuse("E_inf", 0, "must be positive where there is neither a mode nor a dashpot");
    }
    return {equilibrium, checked_modes(std::move(modes), "E", "tau"), dashpot};
  }

  Real operator()(const Real& t) const {
    using std::exp;
    if (!(t >= 0)) return 0;
    Real sum = equilibrium_;
    for (const auto& mode : modes_) sum += mode.strength * exp(-t / mode.time);
    return sum;
  }

  Real instantaneous() const {  // E_0 = E(0+), without the dashpot
    Real sum = equilibrium_;
    for (const auto& mode : modes_) sum += mode.strength;
    return sum;
  }

  DynamicModulus<Real> dynamic(const Real& angular_frequency) const {
    DynamicModulus<Real> sum{equilibrium_, angular_frequency * dashpot_};
    for (const auto& mode : modes_) {
      const Real x = angular_frequency * mode.time;
      // x^2 would overflow where x / (1 + x^2) does not.
      const Real in_phase = x > 1 ? 1 / (1 + (1 / x) * (1 / x)) : x * x / (1 + x * x);
      const Real out_of_phase = x > 1 ? (1 / x) * in_phase : x / (1 + x * x);
      sum.storage += mode.strength * in_phase;
      sum.loss += mode.strength * out_of_phase;
    }
    return sum;
  }

  const Real& equilibrium() const noexcept { return equilibrium_; }  // E_inf [Pa]
  const Modes<Real>& modes() const noexcept { return modes_; }       // E_i [Pa], tau_i [s]
  const Real& dashpot() const noexcept { return dashpot_; }          // eta [Pa s]

 private:
  BasicRelaxationModulus(Real equilibrium, Modes<Real> modes, Real dashpot)
      : equilibrium_(std::move(equilibrium)), modes_(std::move(modes)), dashpot_(std::move(dashpot)) {}

  Real equilibrium_;
  Modes<Real> modes_;
  Real dashpot_;
};

using RelaxationModulus = BasicRelaxationModulus<double>;

}  // namespace patchgrip::contact
