#include <patchgrip/dynamics/rigid_motion.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/tools/toms748_solve.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/patch_axes.h>
#include <patchgrip/dynamics/trajectory.h>

namespace patchgrip::dynamics {
namespace {

using friction::Gauge;
using friction::Twist;
using friction::Wrench;

// n, ln rho, t - t_0, place, work, dissipated.
using Stretched = Trajectory<10>;

constexpr double at_rest = 1e-17;       // of rho to its largest
constexpr double first_motion = 1e-12;  // [s] after a jump that starts the body
constexpr double longest_start = 100;   // times `start`: of the longest step and of what is left of a piece

Vector3 vector(const Twist& v) { return {v.vx, v.vy, v.w}; }

void require_increasing(const char* name, const std::vector<double>& times) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    contact::require_finite(name, times[i]);
    if (i > 0 && times[i] < times[i - 1]) contact::refuse(name, times[i], "must not come before the one before it");
  }
}

class Motion {
 public:
  Motion(const RigidPatchView& patch, const Vector3& mass, const friction::Law& law, const PlanarLoad& load,
         const RigidMotionSettings& settings)
      : patch_(patch), mass_(mass), root_(mass.cwiseSqrt()), law_(law), load_(load), settings_(settings) {}

  RigidMotionResult run(const PlanarState& from, double t0, double t1, const std::vector<double>& samples,
                        const Watch& watch) {
    state_ = from;
    t_ = t0;
    end_ = t1;
    samples_ = &samples;
    watch_ = &watch;
    next_sample_ = static_cast<std::size_t>(std::ranges::lower_bound(samples, t0) - samples.begin());
    while (t_ < end_) {
      if (state_.twist.isZero(0)) {
        stick();
      } else {
        slip();
      }
    }
    sample_to(end_);
    state_.anchor = state_.place;
    return {state_, events_, Vector3::Zero(), evaluations_};
  }

 private:
  Vector3 force(double t) const {
    const Vector3 f = load_.force(t);
    for (const double x : f) contact::require_finite("load", x);
    return f;
  }
  double normal_force(double t) const { return contact::require_non_negative("normal_force", load_.normal_force(t)); }
  double limit(double t) const { return law_.mu_static * normal_force(t); }

  double size(double t) const {
    return load_.size && normal_force(t) > 0 ? contact::require_positive("size", load_.size(t)) : 1;
  }

  // Its twist that of the patch as it is then.
  Gauge gauge(double t) const {
    const double ratio = size(t);
    Gauge g = patch_.gauge(shrunk(turned(force(t), -state_.place[2]), ratio));
    g.twist.w /= ratio;
    return g;
  }
  double excess(double t) const { return gauge(t).value - limit(t); }

  // The end of the smooth piece that t lies in.
  double piece_end(double t) const {
    const auto next = std::ranges::upper_bound(load_.jumps, t);
    return next == load_.jumps.end() ? end_ : std::min(*next, end_);
  }

  // A little inside of a piece: at the jump itself the load is that after it.
  static double before(double t) { return std::nextafter(t, -std::numeric_limits<double>::infinity()); }
  double last_before(double end) const { return end < end_ ? before(end) : end; }

  void sample_to(double t) {
    while (next_sample_ < samples_->size() && (*samples_)[next_sample_] <= t) {
      if (*watch_) (*watch_)((*samples_)[next_sample_], state_);
      ++next_sample_;
    }
  }

  void stick() {
    sample_to(t_);
    if (excess(t_) > 0) return start_at_jump();
    const double end = piece_end(t_), last = last_before(end);
    double lo = t_;
    while (lo < last) {
      const double hi = std::min(last, lo + settings_.longest_step);
      if (excess(hi) > 0) {
        std::uintmax_t steps = 200;
        const auto [a, b] = boost::math::tools::toms748_solve([this](double t) { return excess(t); }, lo, hi,
                                                              boost::math::tools::eps_tolerance<double>(53), steps);
        sample_to(a);
        t_ = b;
        return start_steadily();
      }
      lo = hi;
    }
    sample_to(last);
    t_ = end;
  }

  void note(SlipEvent::Kind kind, double t, const PlanarState& state, const Vector3& direction) {
    const Twist own = grown(direction, size(t));
    const Vector3 v = direction / friction::power(patch_.gradient(own).value, own);
    events_.push_back({kind, t, {v[0], v[1], v[2]}, state, 0});
    if (settings_.on_event) settings_.on_event(events_.back());
  }

  // The acceleration at rest where the load is beyond the limit; none where it is not.
  Vector3 released(double t) const {
    const double ratio = size(t);
    const auto metric = BristleMetric::diagonal(mass_[0], mass_[1], mass_[2] / (ratio * ratio));
    Vector3 a = vector(patch_.closest(shrunk(turned(force(t), -state_.place[2]), ratio), limit(t), metric).slip);
    a[2] /= ratio;
    return a;
  }

  // The same of a body that moves along n.
  Vector3 released_along(const Vector3& n, double t) const {
    return std::max(0., excess_along(n, t)) / n.dot(mass_.cwiseProduct(n)) * n;
  }
  double excess_along(const Vector3& n, double t) const {
    const Twist own = grown(n, size(t));
    return n.dot(turned(force(t), -state_.place[2])) - limit(t) * friction::power(patch_.gradient(own).value, own);
  }

  // The load is beyond the limit: a finite acceleration.
  void start_at_jump() {
    const Vector3 a = released(t_);
    if (a.isZero(0)) return start_steadily();  // beyond it by rounding alone
    note(SlipEvent::Kind::break_away, t_, state_, a);
    state_.twist = turned(first_motion * a, state_.place[2]);
  }

  // The load passes the limit. Where there is none, or so little of it that no time tells its share from nothing, what
  // the load and the limit come to from now on is all that there is.
  void start_steadily() {
    const double end = piece_end(t_), L = limit(t_);
    const double step = std::min(1., longest_start * settings_.start) * std::min(settings_.longest_step, end - t_);
    if (L > 0) {
      if (const double tau = time_along(vector(gauge(t_).twist), step); t_ + tau > t_) return leave_along(tau, step);
    }
    if (t_ + step > t_) return set_off(step, [&](double t) { return released(t); });
    t_ = end;
  }

  // Up to `longest`, until the load passes the limit by the share `start`, or twice that.
  double time_along(const Vector3& n, double longest) const {
    const double last = last_before(piece_end(t_)), most = settings_.start * limit(t_);
    const auto passed = [&](double tau) { return excess_along(n, std::min(t_ + tau, last)) / most; };
    double tau = longest;
    while (t_ + tau > t_ && passed(tau) > 2) tau /= passed(tau);
    return tau;
  }

  // Along the gauge's slip as it turns, with the energy that it has.
  void leave_along(double tau, double step) {
    const double end = piece_end(t_);
    Vector3 n = vector(gauge(t_).twist);
    const auto acceleration = [&](double t) { return released_along(n, t); };
    set_off(tau, acceleration);
    while (t_ < end) {
      n = vector(gauge(t_).twist);
      state_.twist = turned(std::sqrt(kinetic(state_.twist) / kinetic(n)) * n, state_.place[2]);
      tau = time_along(n, std::min(step, end - t_));
      if (!goes_along(n) || !(t_ + tau > t_)) return;
      advance(tau, acceleration);
    }
  }

  // Whether it still goes along the gauge's slip n as from rest: the load passes the limit by less than the share
  // `start`, and the speed changes what is left of it by less than this share, or by no more than rounding.
  bool goes_along(const Vector3& n) {
    const double left = excess_along(n, t_), most = settings_.start * limit(t_), rounding = 0x1p-48 * limit(t_);
    const Vector3 f = turned(root_.cwiseProduct(push(t_, state_.twist, state_.place[2])), -state_.place[2]);
    return left > -rounding && left < most && std::fabs(n.dot(f) - left) < settings_.start * left + rounding &&
           !state_.twist.isZero(0);
  }

  // From rest.
  template <class Acceleration>
  void set_off(double tau, const Acceleration& acceleration) {
    const double from = t_;
    const PlanarState rest = state_;
    advance(tau, acceleration);
    if (state_.twist.isZero(0)) return;
    note(SlipEvent::Kind::break_away, from, rest, turned(state_.twist, -rest.place[2]));
  }

  double kinetic(const Vector3& v) const { return v.dot(mass_.cwiseProduct(v)) / 2; }

  // By tau, with an acceleration in the axes of the patch.
  template <class Acceleration>
  void advance(double tau, const Acceleration& acceleration) {
    const double last = last_before(piece_end(t_)), angle = state_.place[2];
    const auto after = [&](double s) {
      const double middle = std::min(t_ + s / 2, last), to = std::min(t_ + s, last);
      const Vector3 a0 = acceleration(t_), a1 = acceleration(middle), a2 = acceleration(to), v0 = state_.twist;
      const Vector3 v1 = v0 + turned(s / 24 * (5 * a0 + 8 * a1 - a2), angle);
      const Vector3 v2 = v0 + turned(s / 6 * (a0 + 4 * a1 + a2), angle);
      const double work = s / 6 * (force(t_).dot(v0) + 4 * force(middle).dot(v1) + force(to).dot(v2));
      PlanarState at = state_;
      at.place += s * v0 + turned(s * s / 6 * (a0 + 2 * a1), angle);
      at.anchor = at.place;
      at.twist = v2;
      at.work += work;
      at.dissipated += work - kinetic(v2) + kinetic(v0);
      return at;
    };
    for (; next_sample_ < samples_->size() && (*samples_)[next_sample_] < t_ + tau; ++next_sample_) {
      const double sample = (*samples_)[next_sample_];
      if (*watch_) (*watch_)(sample, after(std::max(0., sample - t_)));
    }
    state_ = after(tau);
    t_ += tau;
  }

  // G
  Vector3 push(double t, const Vector3& v, double angle) {
    ++evaluations_;
    const double ratio = size(t);
    const Twist u = grown(turned(v, -angle), ratio);
    const Wrench r = friction::friction_wrench(law_, normal_force(t), patch_.moments, patch_.gradient(u), u).value;
    return (force(t) + turned(carried(r, ratio), angle)).cwiseQuotient(root_);
  }

  void slip() {
    sample_to(t_);
    const double origin = t_, end = piece_end(t_), last = last_before(end);
    const Vector3 p = root_.cwiseProduct(state_.twist);
    const double size = p.norm();
    const Vector3 n = p / size;
    const auto twist = [&](const Stretched::State& y) {
      return Vector3(size * std::exp(y[3]) * Vector3(y[0], y[1], y[2]).normalized().cwiseQuotient(root_));
    };
    // Seconds of stretched time: of the order of rho / |G| at the start, or all that is left where nothing acts.
    const double scale = std::min(size / push(t_, state_.twist, state_.place[2]).norm(), end - origin);
    Stretched motion(
        [&](double, const Stretched::State& y, Stretched::State& dy) {
          const Vector3 v = twist(y), unit = Vector3(y[0], y[1], y[2]).normalized();
          const double t = std::max(origin, std::min(origin + y[4], last));  // of a step that overflows, too
          const Vector3 G = scale / size * push(t, v, y[7]);
          const double along = unit.dot(G), rho = std::exp(y[3]);
          for (std::size_t i = 0; i < 3; ++i) {
            dy[i] = G[static_cast<Eigen::Index>(i)] - along * unit[static_cast<Eigen::Index>(i)];
            dy[i + 5] = scale * rho * v[static_cast<Eigen::Index>(i)];
          }
          dy[3] = along;
          dy[4] = scale * rho;
          dy[8] = dy[4] * force(t).dot(v);
          dy[9] = dy[8] - size * size * rho * rho * along;  // less the change of kinetic energy
        },
        {n[0], n[1], n[2], 0, 0, state_.place[0], state_.place[1], state_.place[2], state_.work, state_.dissipated}, 0,
        {.tolerance = settings_.tolerance, .first_step = 1e-3});
    motion.tell([&](double, const Stretched::State& y) { return origin + y[4]; });
    double largest = 0;
    enum : std::size_t { rest, over, due };
    motion.watch([&](double, const Stretched::State& y) {
      largest = std::max(largest, y[3]);
      return y[3] - largest - std::log(at_rest);
    });
    motion.watch([&](double, const Stretched::State& y) { return origin + y[4] - end; });
    motion.watch([&](double, const Stretched::State& y) {
      // One at the end itself is met there.
      const double sample = next_sample_ < samples_->size() ? (*samples_)[next_sample_] : end;
      return sample < end ? origin + y[4] - sample : -1;
    });
    std::size_t why = due;
    motion.run(1e6, [&](double, const Stretched::State& y, std::size_t event) {
      if (event == due) {
        PlanarState at;
        at.place = {y[5], y[6], y[7]};
        at.twist = twist(y);
        at.anchor = at.place;
        at.work = y[8];
        at.dissipated = y[9];
        if (*watch_) (*watch_)((*samples_)[next_sample_], at);
        ++next_sample_;
        return false;
      }
      why = event;
      return true;
    });
    const Stretched::State& y = motion.state();
    state_.place = {y[5], y[6], y[7]};
    state_.twist = twist(y);
    state_.work = y[8];
    state_.dissipated = y[9];
    t_ = why == over ? end : origin + y[4];
    sample_to(t_);
    if (why != rest) return;
    const Vector3 direction = turned(state_.twist / state_.twist.norm(), -state_.place[2]);
    state_.twist.setZero();
    note(SlipEvent::Kind::stop, t_, state_, direction);
  }

  const RigidPatchView& patch_;
  Vector3 mass_, root_;  // M, M^(1/2)
  const friction::Law& law_;
  const PlanarLoad& load_;
  const RigidMotionSettings& settings_;
  PlanarState state_;
  double t_ = 0, end_ = 0;
  const std::vector<double>* samples_ = nullptr;
  const Watch* watch_ = nullptr;
  std::size_t next_sample_ = 0;
  std::vector<SlipEvent> events_;
  long evaluations_ = 0;
};

}  // namespace

void RigidMotionSettings::check() const {
  contact::require_in("tolerance", tolerance, 1e-14, 1e-3);
  contact::require_positive("longest_step", longest_step);
  contact::require_in("start", start, 1e-6, 0.5);
}

RigidMotionResult rigid_motion(const RigidPatchView& patch, const Vector3& mass, const friction::Law& law,
                               const PlanarLoad& load, const PlanarState& from, double t0, double t1,
                               const RigidMotionSettings& settings, const std::vector<double>& samples,
                               const Watch& watch) {
  settings.check();
  contact::require_in("end", t1, contact::require_finite("start", t0), std::numeric_limits<double>::max());
  require_increasing("jumps", load.jumps);
  require_increasing("samples", samples);
  for (const Vector3& v : {from.place, from.twist}) {
    for (const double x : v) contact::require_finite("state", x);
  }
  RigidMotionResult r = Motion(patch, mass, law, load, settings).run(from, t0, t1, samples, watch);
  RigidMotionSettings rough = settings;
  rough.tolerance = std::min(1e-3, 100 * settings.tolerance);
  rough.start = std::min(0.5, 2 * settings.start);
  rough.on_event = {};
  const RigidMotionResult other = Motion(patch, mass, law, load, rough).run(from, t0, t1, {}, {});
  const bool alike = other.events.size() == r.events.size();
  for (std::size_t i = 0; i < r.events.size(); ++i) {
    const bool same = alike && other.events[i].kind == r.events[i].kind;
    const double rounding = 8 * 0x1p-53 * std::fabs(r.events[i].time);
    r.events[i].error =
        same ? std::fabs(other.events[i].time - r.events[i].time) + rounding : std::numeric_limits<double>::infinity();
  }
  r.place_error = (other.state.place - r.state.place).cwiseAbs();
  r.evaluations += other.evaluations;
  return r;
}

}  // namespace patchgrip::dynamics
