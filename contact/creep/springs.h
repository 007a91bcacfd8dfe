// Foundation of independent springs, advanced in time: any history of force or approach, any number of presses.
//
//     F = 2 int_0^a q(x, t) dx,        p(r) = -(1/pi) int_r^a q_x / sqrt(x^2 - r^2) dx
//
// over springs at equal distances, each exact in time for an approach that is linear over a step (spring.h): splitting
// such a step changes nothing. Simpson's rule up to the last spring but one that touches, a parabola from there to
// where it meets zero: the edge. Under a given force the approach of the end of the step is found by Newton's method,
// and its course over the step is taken as linear: second order in the step.
//
// Domain   the radius stays within `widest`; exact while the zone is one circle (`is_one_circle`) and q falls outward
//          (`stress_falls`, which makes p >= 0). M without a bare dashpot.
// Units    t [s], delta, x, a, r [m], F [N], p [Pa].
// Cost     a step: springs times modes, whatever came before; memory: one number per spring and mode, and four.
// Error    of F at a given approach: the estimate, four times what the second differences of q say and half of what
//          lies beyond the last spring, where a thin layer would not show: of order 1/springs^2, mostly two or three
//          decades too careful. Of the steps under a given force: spring_press.h; tests/contact/springs_test.cc.
// Fails    fewer than three springs in touch: the estimate is the force itself. Where a ring touches beside the circle
//          or instead of it (not `is_one_circle`), force and error are those of the circle alone.
// Throws   std::invalid_argument for bad input, and where the radius would leave `widest`; std::runtime_error where the
//          approach of a force does not settle.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/axisymmetric.h>
#include <patchgrip/contact/creep/panels.h>
#include <patchgrip/contact/creep/spring.h>

namespace patchgrip::contact {

class Springs {
 public:
  static constexpr double radius_share = 0.02;

  // Springs at 0, widest / count, .. widest.
  template <Profile P>
  static Springs under(const P& profile, ContactCreep creep, double widest, int count) {
    require_positive("widest", widest);
    require_in("widest", widest, 0, profile.max_radius());
    require_in("count", count, 4, 1e7);
    std::vector<double> heights{0};
    for (int k = 1; k <= count; ++k) heights.push_back(static_cast<double>(profile.approach(widest * k / count)));
    return {SpringLaw(std::move(creep)), widest / count, std::move(heights)};
  }

  // The approach goes linearly to `approach` [m] within `duration` [s]; at once if that is 0.
  void advance_to_approach(double duration, double approach);
  // The force goes to `force` [N], >= 0, within `duration` [s]. Once free of force the stamp stays where it let go.
  void advance_to_force(double duration, double force);

  double approach() const noexcept { return approach_; }  // delta [m]
  Estimate force() const;                                 // F [N]
  double radius() const;                                  // a [m], right to radius_share of the distance of the springs
  double pressure(double r) const;                        // p [Pa], first order in the distance of the springs
  bool is_one_circle() const;
  bool stress_falls() const;

  double distance() const noexcept { return distance_; }
  std::span<const double> stresses() const noexcept { return stresses_; }  // q [Pa m], at 0, distance, 2 distance ..

 private:
  Springs(SpringLaw law, double distance, std::vector<double> heights);

  struct State {
    std::vector<Spring> springs;
    std::vector<double> relaxing;  // q_i of each spring in turn
  };

  // The force and its derivative with the approach after a step from `from`, which is left in state_ and stresses_.
  struct Response {
    double force;
    double stiffness;
  };
  Response step(const State& from, double approach, double duration);

  SpringLaw law_;
  double distance_;
  std::vector<double> heights_;  // g at the springs
  State state_;
  std::vector<double> stresses_;
  double approach_ = 0;
  double largest_force_ = 0;  // given so far [N]
};

}  // namespace patchgrip::contact
