// A motion y' = f(t, y) with the times at which something changes sign: order 5(4) with dense output.
//
//     Trajectory<3> motion(rates, {x, v, kappa}, t, {.tolerance = 1e-12});
//     motion.watch([](double, const auto& y) { return y[1]; });            // v = 0
//     motion.run(8, [&](double t, const auto& y, std::size_t event) { ... });
//
// Steps of Dormand and Prince by their error estimate (Boost.Odeint); within a step the solution is their continuous
// extension of order 4, which is what events are found on, by bracketing (Boost.Math, TOMS 748). A watched function
// that changes sign twice within a step is not seen. A step that overflows is taken again, shorter: an error that is
// not a number tells nothing.
//
// Domain   f piecewise smooth: at kinks steps get short. Stiff laws take steps of some 3 / |largest eigenvalue|.
// Error    of a step: tolerance (1 + |y_i|) in each component. What it sums up to is told by two tolerances.
// Throws   std::invalid_argument unless the tolerance is in [1e-15, 1e-2] and the end is not before the start;
//          std::runtime_error, naming the time (that of tell(), where t is not one), where steps come to nothing or the
//          state is not finite.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <patchgrip/contact/require.h>

namespace patchgrip::dynamics {

struct TrajectorySettings {
  double tolerance = 1e-10;
  double first_step = 1e-6;  // [s]
};

[[noreturn]] void refuse_step(double t);  // std::runtime_error

template <std::size_t n>
class Trajectory {
 public:
  using State = std::array<double, n>;
  using Rates = std::function<void(double t, const State& y, State& rates)>;
  using Watched = std::function<double(double t, const State& y)>;

  Trajectory(Rates rates, const State& start, double t, const TrajectorySettings& settings = {})
      : rates_(std::move(rates)),
        y_(start),
        t_(t),
        stepper_(boost::numeric::odeint::make_dense_output(
            contact::require_in("tolerance", settings.tolerance, 1e-15, 1e-2), settings.tolerance,
            boost::numeric::odeint::runge_kutta_dopri5<State>())) {
    stepper_.initialize(start, t, contact::require_positive("first_step", settings.first_step));
  }

  void watch(Watched function) { watched_.push_back(std::move(function)); }

  // What to call the time in errors.
  void tell(Watched time) { told_ = std::move(time); }

  double time() const noexcept { return t_; }
  const State& state() const noexcept { return y_; }
  long evaluations() const noexcept { return evaluations_; }

  // To the time `end`, or to where `at_event(t, y, which)` returns true: then run() does so, too.
  template <class AtEvent>
  bool run(double end, const AtEvent& at_event) {
    contact::require_in("end", end, t_, std::numeric_limits<double>::max());
    while (t_ < end) {
      if (!(stepper_.current_time() > t_)) step();
      const double to = std::min(end, stepper_.current_time());
      while (t_ < to) {
        const auto [event, at] = first_event(to);
        move_to(at);
        if (event < watched_.size() && at_event(t_, y_, event)) return true;
      }
    }
    return false;
  }

  bool run(double end) {
    return run(end, [](double, const State&, std::size_t) { return false; });
  }

 private:
  void step() {
    const auto rates = [this](const State& y, State& dy, double t) {
      ++evaluations_;
      rates_(t, y, dy);
    };
    const State start = stepper_.current_state();
    const double from = stepper_.current_time();
    stepper_.do_step(rates);
    while (stepper_.current_time() > from && !std::ranges::all_of(stepper_.current_state(), is_finite)) {
      stepper_.initialize(start, from, (stepper_.current_time() - from) / 10);
      stepper_.do_step(rates);
    }
    if (!(stepper_.current_time() > t_)) refuse_step(told_ ? told_(t_, y_) : t_);
  }

  static bool is_finite(double x) { return std::isfinite(x); }

  State at(double t) {
    State y;
    stepper_.calc_state(t, y);
    return y;
  }

  void move_to(double t) {
    y_ = t == stepper_.current_time() ? stepper_.current_state() : at(t);
    t_ = t;
  }

  // The first sign change between now and `to`, just after it; watched_.size() and `to` without one.
  std::pair<std::size_t, double> first_event(double to) {
    std::pair<std::size_t, double> first{watched_.size(), to};
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      const auto value = [&](double t) { return watched_[i](t, t == t_ ? y_ : at(t)); };
      const double before = value(t_), after = value(first.second);
      if (before == 0 || std::signbit(before) == std::signbit(after)) continue;
      std::uintmax_t steps = 200;
      const auto [lo, hi] = boost::math::tools::toms748_solve(value, t_, first.second, before, after,
                                                              boost::math::tools::eps_tolerance<double>(53), steps);
      // Past it, so that it is not met again.
      const double past = std::signbit(value(hi)) == std::signbit(after) ? hi : lo;
      if (past > t_) first = {i, past};
    }
    return first;
  }

  Rates rates_;
  State y_;
  double t_;
  std::vector<Watched> watched_;
  Watched told_;
  long evaluations_ = 0;
  using Stepper = boost::numeric::odeint::runge_kutta_dopri5<State>;
  typename boost::numeric::odeint::result_of::make_dense_output<Stepper>::type stepper_;
};

}  // namespace patchgrip::dynamics
