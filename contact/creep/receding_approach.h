// When a shrinking contact passes the states it grew through: Ting's equation for an approach that is given.
//
//     int_t1^t M(t - s) d delta(s) = 0                                                               (Ting 1966)
//
// says that the springs at the edge, which were reached at t_1, carry nothing any more. The contact grows (or rests)
// until the approach first falls (`grows_until`), then shrinks, until it is lost (t_1 at the start, or before) or until
// the surface comes back faster than the stamp leaves, when it grows again.
//
// Units    t [s], delta [m].
// Error    t_1: the root to the last digit of an equation that is good to about 10 units of rounding of its largest
//          term; tests/contact/creep_press_test.cc.
// Fails    as load_integral.h: what comes and goes between two looks is not seen.
// Throws   std::invalid_argument unless `until` comes after the start, delta >= 0 there, and M has no dashpot (a bare
//          dashpot would carry an infinite force at a jump).
#pragma once

#include <vector>

#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/creep/history.h>
#include <patchgrip/contact/creep/past.h>

namespace patchgrip::contact {

class RecedingApproach {
 public:
  RecedingApproach(RelaxationModulus modulus, History approach, double until);

  const RelaxationModulus& modulus() const noexcept { return modulus_; }
  const History& approach() const noexcept { return approach_; }
  double grows_until() const noexcept { return grows_until_; }    // t_m; `until` if it never shrinks
  double contact_lost() const noexcept { return contact_lost_; }  // +infinity if not until valid_until
  double valid_until() const noexcept { return valid_until_; }

  // The measure is delta(t_1). t_1 = t while the contact grows. t in [start, valid_until].
  Past past(double t) const;

 private:
  double edge_stress(double t1, double t) const;       // int over (t1, t] of M d delta
  double edge_stress_rate(double t1, double t) const;  // with t, delta falling at its rate
  bool is_lost(double t) const;
  void find_end();

  RelaxationModulus modulus_;
  History approach_;
  double grows_until_;
  double contact_lost_;
  double valid_until_;
};

}  // namespace patchgrip::contact
