// The force that creeps: X(t) = int C(t - s) dF(s), what F / E* is to an elastic contact.
//
//     X = C_0 F + sum C_j int (1 - exp(-(t - s) / lambda_j)) dF + fluidity int F dt
//     X' = C_0 F' + sum C_j / lambda_j int exp(-(t - s) / lambda_j) dF + fluidity F
//
// While X does not fall the contact radius does not shrink, and the contact is the elastic one with F / E* = X (Lee and
// Radok 1960). It falls from `falls_at` on: at once where a jump takes force off.
//
// Domain   C_0, C_j, lambda_j, fluidity as in creep_compliance.h.
//          Sines of at most 1e5 turns.
// Units    X [m^2], F [N], C [1/Pa].
// Error    X of forces that do not fall: <= 12 + n / 2 units of rounding (2^-53), relative, n modes.
//          tests/contact/growing_contact_test.cc.
// Fails    the fall is looked for at 32 times per period of a sine and at about 40 per straight piece: a dip of X'
//          that comes and goes between two of them is not seen.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <patchgrip/contact/creep/creep_compliance.h>
#include <patchgrip/contact/creep/history.h>

namespace patchgrip::contact {

template <class Real>
Real load_integral(const BasicCreepCompliance<Real>& compliance, const BasicHistory<Real>& force, const Real& t) {
  Real sum = compliance.instantaneous() * force(t);
  for (const auto& mode : compliance.modes()) sum += mode.strength * force.lagged(t, mode.time);
  return compliance.fluidity() > 0 ? sum + compliance.fluidity() * force.integral(t) : sum;
}

template <class Real>
Real load_integral_rate(const BasicCreepCompliance<Real>& compliance, const BasicHistory<Real>& force, const Real& t) {
  Real sum = compliance.instantaneous() * force.rate(t) + compliance.fluidity() * force(t);
  for (const auto& mode : compliance.modes()) sum += mode.strength / mode.time * force.faded(t, mode.time);
  return sum;
}

constexpr double most_turns = 1e5;

// Times to look at in (start of the piece, end], ascending; the last is the end.
std::vector<double> look_times(const HistoryPiece<double>& piece, double end);

// The first time up to `until` from which X falls, the last one before a jump down; +infinity if it does not.
double load_integral_falls_at(const CreepCompliance& compliance, const History& force, double until);

}  // namespace patchgrip::contact
