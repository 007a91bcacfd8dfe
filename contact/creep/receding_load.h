// The load integral of a shrinking contact: Ting's equation for a force that is given.
//
//     int_0^t1 M(t - s) dX(s) = F(t),      X(s) = int_0^s C dF  while the contact grew                    (Ting 1966)
//     int exp(-(t1 - s) / tau_i) dX(s) = tau_i (sum C_j y_j / (lambda_j - tau_i) + fluidity F),
//     y_j = int exp(-(t1 - s) / lambda_j) dF(s)
//
// in closed form, since dX fades with the times lambda_j alone. The contact grows until X would fall (`grows_until`;
// that may be after the peak of the force), then shrinks until it is lost (F = 0), until the relaxing stress of what is
// left of it exceeds the force and it grows again, or until a jump up. Under a held force what is left to relax makes
// it grow for ever, soon by less than the rounding of the stress: that is rest, not growth.
//
// Cost     of making it: some forty looks a piece, each of all pieces and modes; sampled forces go to springs.h.
// Units    t [s], F [N], X [m^2].
// Error    t_1: the root to the last digit of an equation that is good to about 10 units of rounding of its largest
//          term; tests/contact/creep_press_test.cc.
// Fails    as load_integral.h: what comes and goes between two looks is not seen.
// Throws   std::invalid_argument unless F >= 0 up to `until`, which must come after the start.
#pragma once

#include <limits>
#include <vector>

#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/creep/history.h>
#include <patchgrip/contact/creep/load_integral.h>
#include <patchgrip/contact/creep/past.h>

namespace patchgrip::contact {

class RecedingLoad {
 public:
  RecedingLoad(ContactCreep creep, History force, double until);

  const ContactCreep& creep() const noexcept { return creep_; }
  const History& force() const noexcept { return force_; }
  double grows_until() const noexcept { return grows_until_; }  // t_m; `until` if it never shrinks
  double valid_until() const noexcept { return valid_until_; }

  double grown(double t) const { return load_integral(creep_.compliance, force_, t); }  // X of a growing contact

  // t_1 = t while the contact grows. t in [start, valid_until].
  Past past(double t) const;

  // When the shrinking contact passes the states at which the growing one had its jumps and kinks, up to t.
  std::vector<double> passes(double t) const;

 private:
  double stress(const Past& past, double t) const;       // int_0^past M(t - s) dX(s) [N]
  double stress_rate(const Past& past, double t) const;  // its derivative with t
  double first_end() const;

  ContactCreep creep_;
  History force_;
  double grows_until_;
  double valid_until_;
};

}  // namespace patchgrip::contact
