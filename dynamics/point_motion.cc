#include <patchgrip/dynamics/point_motion.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/trajectory.h>

namespace patchgrip::dynamics {
namespace {

using Flow = Trajectory<6>;  // PointState, member by member

Flow::State to_array(const PointState& s) {
  return {s.x, s.v, s.load_work, s.support_work, s.friction_loss, s.damper_loss};
}
PointState to_state(const Flow::State& y) { return {y[0], y[1], y[2], y[3], y[4], y[5]}; }

class Run {
 public:
  Run(const PointBody& body, const Law& law, double mu_hold, const PointLoad& load, const PointMotionSettings& settings,
      const std::vector<double>& samples, const PointWatch& watch)
      : body_(body), law_(law), mu_hold_(mu_hold), load_(load), settings_(settings), samples_(samples), watch_(watch) {}

  PointMotionResult operator()(const PointState& from, double t0, double t1) {
    state_ = from;
    t_ = t0;
    end_ = t1;
    next_ = static_cast<std::size_t>(std::ranges::lower_bound(samples_, t0) - samples_.begin());
    side_ = state_.v == body_.support_speed ? 0 : std::copysign(1, state_.v - body_.support_speed);
    while (t_ < end_) {
      if (side_ == 0 && excess(t_, to_array(state_)) > 0) leave();
      follow();
    }
    sample_to(end_);
    return {state_, side_ == 0, events_};
  }

 private:
  double force(double t) const { return contact::require_finite("load", load_.force(t)); }
  double normal_force(double t) const { return contact::require_non_negative("normal_force", load_.normal_force(t)); }

  // q, what friction must carry so that the point moves with the support.
  double held(double t, const Flow::State& y) const {
    return force(t) - body_.spring * y[0] - body_.damper * body_.support_speed;
  }
  double excess(double t, const Flow::State& y) const { return std::fabs(held(t, y)) - mu_hold_ * normal_force(t); }

  // R; while it slips on the side that it went to, also where u is 0.
  double friction(double t, const Flow::State& y) const {
    if (side_ == 0) return -held(t, y);
    const double u = side_ * std::max(side_ * (y[1] - body_.support_speed), std::numeric_limits<double>::min());
    const double F = normal_force(t);
    return stribeck_force(law_, F, u) + viscous_force(law_, F, u);
  }

  // While it slips.
  double acceleration(double t, const Flow::State& y) const {
    return (force(t) - body_.spring * y[0] - body_.damper * y[1] + friction(t, y)) / body_.mass;
  }

  Flow::State rates(double t, const Flow::State& y) const {
    const double v0 = body_.support_speed, v = side_ == 0 ? v0 : y[1], R = friction(t, y);
    return {v, side_ == 0 ? 0 : acceleration(t, y), force(t) * v, R * v0, -R * (v - v0), body_.damper * v * v};
  }

  // The end of the smooth piece that t lies in; at the jump itself the load is that after it.
  double piece_end() const {
    const auto next = std::ranges::upper_bound(load_.jumps, t_);
    return next == load_.jumps.end() ? end_ : std::min(*next, end_);
  }

  void note(PointEvent::Kind kind) { note({kind, t_, state_}); }
  void note(const PointEvent& event) {
    events_.push_back(event);
    if (settings_.on_event) settings_.on_event(event);
  }

  void leave() {
    note(PointEvent::Kind::break_away);
    side_ = std::copysign(1, held(t_, to_array(state_)));
  }

  void sample_to(double t) {
    for (; next_ < samples_.size() && samples_[next_] <= t; ++next_) {
      if (watch_) watch_(samples_[next_], state_, friction(std::min(samples_[next_], t_), to_array(state_)));
    }
  }

  // To the next event, jump or end, sticking or slipping throughout.
  void follow() {
    const double end = piece_end(), last = end < end_ ? std::nextafter(end, t_) : end;
    Flow flow([&](double t, const Flow::State& y, Flow::State& dy) { dy = rates(std::min(t, last), y); },
              to_array(state_), t_, {settings_.tolerance, std::min(1e-6, settings_.longest_step)});
    // Where u is least comes first: between looks it may pass 0 to and fro, and is then looked for up to there.
    if (side_ != 0)
      flow.watch([&](double t, const Flow::State& y) { return side_ * acceleration(std::min(t, last), y); });
    const std::size_t end_of_phase = side_ == 0 ? 0 : 1;
    flow.watch([&](double t, const Flow::State& y) {
      if (side_ != 0) return side_ * (y[1] - body_.support_speed);
      const double beyond = excess(std::min(t, last), y);
      return beyond > 0 ? beyond : std::min(beyond, -std::numeric_limits<double>::min());  // at the limit it holds
    });
    if (side_ != 0 && body_.support_speed != 0) flow.watch([](double, const Flow::State& y) { return y[1]; });
    const auto at_event = [&](double t, const Flow::State& y, std::size_t which) {
      if (which == 2) note({PointEvent::Kind::extreme, t, to_state(y)});
      return which == end_of_phase && (side_ == 0 || side_ * (y[1] - body_.support_speed) <= 0);
    };
    bool met = false;
    while (!met && t_ < end) {
      double to = std::min(end, t_ + settings_.longest_step);
      if (next_ < samples_.size()) to = std::min(to, std::max(samples_[next_], t_));
      met = flow.run(to, at_event);
      t_ = flow.time();
      state_ = to_state(flow.state());
      if (side_ == 0) state_.v = body_.support_speed;
      if (!met && t_ < end) sample_to(t_);
    }
    if (!met) {
      t_ = end;
      return;
    }
    if (side_ == 0) return leave();
    state_.v = body_.support_speed;
    const Flow::State y = to_array(state_);
    const bool holds = excess(t_, y) <= 0;
    note(holds ? PointEvent::Kind::stop : PointEvent::Kind::turn);
    side_ = holds ? 0 : std::copysign(1, held(t_, y));
  }

  const PointBody& body_;
  const Law& law_;
  double mu_hold_;
  const PointLoad& load_;
  const PointMotionSettings& settings_;
  const std::vector<double>& samples_;
  const PointWatch& watch_;
  PointState state_;
  double t_ = 0, end_ = 0;
  double side_ = 0;  // sgn u; 0 while it sticks
  std::size_t next_ = 0;
  std::vector<PointEvent> events_;
};

}  // namespace

void PointMotionSettings::check() const {
  contact::require_in("tolerance", tolerance, 1e-15, 1e-3);
  contact::require_positive("longest_step", longest_step);
}

PointMotion::PointMotion(const PointBody& body, const Law& law, double mu_hold)
    : body_(body), law_(law), mu_hold_(mu_hold) {
  contact::require_positive("mass", body.mass);
  contact::require_non_negative("spring", body.spring);
  contact::require_non_negative("damper", body.damper);
  contact::require_finite("support_speed", body.support_speed);
  contact::require_in("mu_hold", mu_hold, law.mu_static, std::numeric_limits<double>::max());
}

PointMotionResult PointMotion::operator()(const PointLoad& load, const PointState& from, double t0, double t1,
                                          const PointMotionSettings& settings, const std::vector<double>& samples,
                                          const PointWatch& watch) const {
  settings.check();
  contact::require_in("end", t1, contact::require_finite("start", t0), std::numeric_limits<double>::max());
  for (const double x : to_array(from)) contact::require_finite("state", x);
  for (const auto& [name, times] : {std::pair{"jumps", &load.jumps}, {"samples", &samples}}) {
    for (std::size_t i = 1; i < times->size(); ++i)
      contact::require_in(name, (*times)[i], (*times)[i - 1], std::numeric_limits<double>::max());
  }
  PointMotionResult r = Run(body_, law_, mu_hold_, load, settings, samples, watch)(from, t0, t1);
  PointMotionSettings rough = settings;
  rough.tolerance = std::min(1e-3, 100 * settings.tolerance);
  rough.on_event = {};
  const PointMotionResult other = Run(body_, law_, mu_hold_, load, rough, {}, {})(from, t0, t1);
  for (std::size_t i = 0; i < r.events.size(); ++i) {
    const bool same = i < other.events.size() && other.events[i].kind == r.events[i].kind;
    r.events[i].error = same ? std::fabs(other.events[i].time - r.events[i].time) + 8 * 0x1p-53 * std::fabs(t1)
                             : std::numeric_limits<double>::infinity();
  }
  return r;
}

}  // namespace patchgrip::dynamics
