// Springs driven through a whole history of force, twice: the second time in steps half as long.
//
//     delta = (4 delta_half - delta_whole) / 3         Richardson; the steps are of second order (springs.h)
//
// Domain   histories of force that are >= 0, with jumps; `steps` of each piece.
// Units    F [N], t [s], delta, a [m].
// Error    the difference of the two runs, and the estimate of the springs; tests/contact/springs_test.cc.
// Fails    springs that are let go by all the force and met again: the order falls to one there. The estimate holds.
// Throws   as springs.h.
#pragma once

#include <cmath>

#include <patchgrip/contact/creep/history.h>
#include <patchgrip/contact/creep/springs.h>

namespace patchgrip::contact {

struct SpringPress {
  Estimate approach;  // delta [m]
  Estimate radius;    // a [m]
  Springs springs;    // as the finer run left them
};

namespace spring_press {

inline void run(Springs& springs, const History& force, double t, int steps) {
  const auto& pieces = force.pieces();
  for (std::size_t k = 0; k < pieces.size() && pieces[k].start <= t; ++k) {
    if (force.jump(k) != 0) springs.advance_to_force(0, std::max(0., pieces[k].value));
    const double end = k + 1 < pieces.size() ? std::min(t, pieces[k + 1].start) : t;
    const double step = (end - pieces[k].start) / steps;
    if (!(step > 0)) continue;
    for (int i = 1; i <= steps; ++i) {
      springs.advance_to_force(step, std::max(0., pieces[k].at(pieces[k].start + step * i)));
    }
  }
}

}  // namespace spring_press

template <Profile P>
SpringPress press_springs(const P& profile, const ContactCreep& creep, const History& force, double t, double widest,
                          int count, int steps) {
  require_in("steps", steps, 1, 1e9);
  require_in("time", t, force.start(), 1e300);
  Springs coarse = Springs::under(profile, creep, widest, count);
  Springs fine = coarse;
  spring_press::run(coarse, force, t, steps);
  spring_press::run(fine, force, t, 2 * steps);
  const double change = fine.approach() - coarse.approach();
  const double widening = fine.radius() - coarse.radius();
  // What the sum over the springs is wrong by moves the approach by its compliance.
  const double a = fine.radius();
  const double force_error = fine.force().error;
  const double moved = a > 0 ? force_error * creep.compliance(t - force.start()) / (2 * a) : 0;
  return {{fine.approach() + change / 3, std::fabs(change) + moved},
          {a + widening / 3, std::fabs(widening) + Springs::radius_share * fine.distance()},
          std::move(fine)};
}

}  // namespace patchgrip::contact
