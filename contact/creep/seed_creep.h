// The seed's own creep relation (4.28 with mu = 1; its rate form is 4.72), for comparison. It is not the solution.
//
//     delta(t) = c (f(t) + E int k_E(t - s) f(s) ds),      f = F^(m/(m+1)),   f(r) ~ r^m,   E k_E = C' / C_0
//
// is linear in F^(2/3) (m = 2) where the contact is linear in F: while the radius does not shrink the exact solution is
// delta^((m+1)/m) = c^((m+1)/m) (F + E int k_E F ds) (press_under_force.h). Written with the elastic approach of the
// instantaneous modulus, delta_0(F), this is delta = delta_0(F) + int C'(t - s) / C_0 delta_0(F(s)) ds for any profile.
//
// Too deep by, of a paraboloid with E1 = E2 (a step: (E K_E)^(1/3)):
//
//     alpha t     0.1      0.5      1        3        10       infinity
//     step        3.1 %    11.7 %   17.7 %   24.9 %   26.0 %   26.0 %
//     ramp        2.5 %    10.0 %   15.7 %   23.7 %   25.9 %   26.0 %
//
// with E1 = 4 E2 up to 71 %. The limit is (E / E_inf)^(1/(m+1)). The rate form that the seed prints loses a term; what
// follows from the relation is delta' + alpha delta = (c / F^(1/3)) ((2/3) F' + (E1 / eta) F), from delta_0(F) on, not
// from 0. What it should say, while the radius grows: (delta^(3/2))' + alpha delta^(3/2) = c^(3/2) (F' + (E1 / eta) F).
//
// Domain   C_0 > 0, F >= 0 up to t.
// Units    F [N], delta [m], t [s].
// Error    as a solution of contact: above. As the relation that is printed: the estimate;
//          tests/contact/seed_creep_test.cc.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <cmath>
#include <vector>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/creep/fading.h>
#include <patchgrip/contact/creep/history.h>

namespace patchgrip::contact {

template <Profile P>
Estimate seed_creep_approach(const P& profile, const ContactCreep& creep, const History& force, double t) {
  const double C0 = require_positive("instantaneous compliance", creep.compliance.instantaneous());
  require_finite("time", t);
  if (t < force.start()) return {0, 0};
  const auto elastic = [&](double s) {
    const double load = force(s);
    return load > 0 ? static_cast<double>(profile.approach(profile.radius_of_force(C0 * load))) : 0;
  };
  const auto& modes = creep.compliance.modes();
  const double now = elastic(t);
  if ((modes.empty() && creep.compliance.fluidity() == 0) || t == force.start()) return {now, 16 * 0x1p-53 * now};
  std::vector<double> breaks;
  for (const auto& piece : force.pieces()) {
    breaks.push_back(piece.start);
    require_non_negative("force", force(std::min(piece.start, t)));
  }
  // A mode that is over within the digits of t follows the force: it adds J_j / C_0 of the approach of now.
  const double soon = 1e-8 * (t - force.start());
  Estimate at_once{0, 0};
  Modes<double> slow;
  for (const auto& mode : modes) {
    if (mode.time >= soon) {
      slow.push_back(mode);
      continue;
    }
    constexpr double forgotten = 40;  // exp(-40) < 2^-53
    const double share = mode.strength / C0;
    at_once.value += share * now;
    at_once.error += share * (std::fabs(now - elastic(t - forgotten * mode.time)) + 8 * 0x1p-53 * now);
  }
  const double fluidity = creep.compliance.fluidity();
  Estimate crept{0, 0};
  if (!slow.empty() || fluidity > 0) {
    const auto slope = [&](double age) {
      double sum = fluidity;
      for (const auto& mode : slow) sum += mode.strength / mode.time * std::exp(-age / mode.time);
      return sum;
    };
    crept = fading::over_past([&](double s) { return slope(t - s) / C0 * elastic(s); }, force.start(), t,
                              slow.empty() ? t - force.start() : slow.front().time, breaks, 8 * 0x1p-53 * now);
  }
  return {now + at_once.value + crept.value, 16 * 0x1p-53 * now + at_once.error + crept.error};
}

}  // namespace patchgrip::contact
