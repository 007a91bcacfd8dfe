#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>
#include <patchgrip/cli/simulate/run_in_steps.h>
#include <patchgrip/cli/simulate/simulate_patch.h>
#include <patchgrip/dynamics/point_bristle.h>
#include <patchgrip/dynamics/point_motion.h>
#include <patchgrip/dynamics/trajectory.h>

namespace patchgrip::cli {
namespace {

using dynamics::PointEvent;
using dynamics::PointState;

constexpr double nearly = 0.99;  // of the sliding friction: from there on a law without a range of stick slips

struct PointSetting {
  PointSetting(const SimulateScene& s, bool second)
      : scene(s), progress("simulate", s.following.times.size(), !second && Progress::wanted(Progress::no_output)) {
    for (std::size_t i = 0; i < s.following.times.size(); ++i) times.push_back(s.following.times[i]);
    tolerance = second ? std::min(1e-3, 100 * s.following.tolerance) : s.following.tolerance;
    longest_step = std::min({1e-2, s.end() / 100, s.loads.longest_step()});
    if (s.body.spring > 0) longest_step = std::min(longest_step, std::sqrt(s.body.mass / s.body.spring) / 6);
    if (s.end() / longest_step > most_steps) {
      s.place.refuse(
          fmt::format("the spring needs steps of {:.3g} s, more than {:.0e} of them", longest_step, most_steps));
    }
  }

  double load(double t) const {
    InterruptGuard::check();
    return scene.loads(t)[0];
  }
  // What friction must carry at rest on the support.
  double held(double t, double x) const {
    const MovingBody& b = scene.body;
    return scene.loads(t)[0] - b.spring * x - b.damper * b.support_speed;
  }
  double margin(double t, double x) const {
    const double q = std::fabs(held(t, x));
    const double capacity = scene.capacity(t);
    return q > 0 && capacity > 0 ? capacity / q - 1 : not_known;
  }

  void add(MotionRecord& record, MotionRow row) {
    const double capacity = scene.capacity(row.time);
    if (capacity > 0) row.share = std::fabs(row.friction[0]) / capacity;
    record.rows.push_back(std::move(row));
    progress.at(record.rows.size() - 1);
  }

  const SimulateScene& scene;
  double tolerance, longest_step;
  std::vector<double> times;
  Progress progress;
};

Vector3 along_x(double x) { return {x, 0, 0}; }

std::string_view name_of(PointEvent::Kind kind) {
  switch (kind) {
    case PointEvent::Kind::break_away:
      return "break_away";
    case PointEvent::Kind::stop:
      return "stop";
    case PointEvent::Kind::turn:
      return "turn";
    default:
      return "extreme";
  }
}

void simulate_rigid_point(PointSetting& s, MotionRecord& record) {
  const SimulateScene& scene = s.scene;
  const MovingBody& b = scene.body;
  const dynamics::PointMotion motion({b.mass, b.spring, b.damper, b.support_speed}, scene.law);
  const auto note = [&](const PointEvent& e) {
    record.events.push_back({name_of(e.kind), e.time, e.error, along_x(e.state.x), {}, s.margin(e.time, e.state.x)});
    if (e.kind == PointEvent::Kind::stop) record.rest = record.events.back();
  };
  const auto result = motion({[&s](double t) { return s.load(t); },
                              [&scene](double t) { return scene.normal_force(t); }, scene.loads.corners()},
                             {b.place[0], b.twist[0]}, 0, scene.end(), {s.tolerance, s.longest_step, note}, s.times,
                             [&](double t, const PointState& at, double friction) {
                               MotionRow row{t, along_x(at.x), along_x(at.v)};
                               row.friction = along_x(friction);
                               row.slips = at.v != b.support_speed;
                               row.kinetic = b.mass * at.v * at.v / 2;
                               row.stored = b.spring * at.x * at.x / 2;
                               row.work = at.load_work + at.support_work;
                               row.dissipated = at.friction_loss + at.damper_loss;
                               s.add(record, row);
                             });
  record.events.clear();  // the same, with the errors of their times
  std::ranges::for_each(result.events, note);
}

// x, v, kappa, dkappa/dt of a zone with a mass, work of load and support, loss.
using Flow = dynamics::Trajectory<6>;

struct Friction {
  double force;       // R [N]
  double kappa_rate;  // [m/s]
  double present;     // of the present limit, >= 0: slips from `yielding` on
  double zone = 0;    // on a zone with a mass [N]
};

// Of the laws with a state, and of those that smooth the jump; u is the velocity relative to the support.
class PointFriction {
 public:
  explicit PointFriction(const SimulateScene& scene)
      : law_(scene.law), method_(scene.following.method), following_(scene.following) {
    const BristleSettings& b = following_.bristle;
    const bool viscous = law_.mu_viscous > 0 && !acts_on_zone();
    bristle_ = {b.stiffness, b.damping, viscous ? 1. : 0., b.elastic_share, b.nu0};
  }

  bool has_bristle() const { return method_ != FrictionMethod::tanh && method_ != FrictionMethod::karnopp; }
  double stiffness() const { return has_bristle() ? bristle_.c0 : 0; }
  // Of those whose bristle yields up to what F_N admits, and straightens at once where that comes to nothing.
  bool yields() const {
    return method_ == FrictionMethod::elastoplastic || method_ == FrictionMethod::lugre ||
           method_ == FrictionMethod::dahl;
  }
  double zone_mass() const { return following_.zone_mass; }
  // From which share of the present limit on it slips.
  double yielding() const {
    if (method_ == FrictionMethod::elastoplastic) return bristle_.elastic_share;
    return is_half_freedom() ? 1 : nearly;
  }

  // Under the normal force F.
  Friction operator()(double F, double kappa, double kappa_rate, double u, double held) const {
    using namespace dynamics;
    const double S = law_.mu_static * F;
    if (method_ == FrictionMethod::tanh) {
      const double R = tanh_force(law_, F, following_.steepness, u);
      return {R + viscous_force(law_, F, u), 0, std::tanh(following_.steepness * std::fabs(u))};
    }
    if (method_ == FrictionMethod::karnopp) {
      const double R = karnopp_force(law_, F, following_.dead_band, held, u);
      const bool holds = std::fabs(u) <= following_.dead_band && S > 0;
      return {R, 0, holds ? std::fabs(R) / S * nearly : 2};
    }
    if (method_ == FrictionMethod::boundary_layer) {
      const BoundaryLayer zone{following_.zone_mass, following_.steepness};
      const double own = u + kappa_rate;
      return {bristle_pull(bristle_, kappa, kappa_rate), kappa_rate, std::tanh(zone.steepness * std::fabs(own)),
              boundary_layer_force(zone, law_, F, own)};
    }
    if (is_half_freedom()) {
      const double rate = method_ == FrictionMethod::half_freedom
                              ? half_freedom_exact_rate(bristle_, law_, F, kappa, u)
                              : half_freedom_linearised_rate(bristle_, law_, F, kappa, u);
      const double pull = std::fabs(bristle_.c0 * kappa - bristle_.c1 * u);
      return {bristle_pull(bristle_, kappa, rate), rate, S > 0 ? pull / S : 2};
    }
    const double rate = method_ == FrictionMethod::elastoplastic ? extended_rate(bristle_, law_, F, kappa, u)
                                                                 : dahl_rate(bristle_, law_, F, kappa, u);
    const double limit = u == 0 ? S : std::fabs(stribeck_force(law_, F, u));
    const double stretch = kappa * u < 0 ? bristle_.c0 * std::fabs(kappa) : 0;
    return {bristle_force(bristle_, law_, F, kappa, rate, u), rate, limit > 0 ? stretch / limit : 2};
  }

 private:
  bool is_half_freedom() const {
    return method_ == FrictionMethod::half_freedom || method_ == FrictionMethod::half_freedom_linearised;
  }
  bool acts_on_zone() const { return is_half_freedom() || method_ == FrictionMethod::boundary_layer; }

  friction::Law law_;
  FrictionMethod method_;
  const Following& following_;
  dynamics::PointBristle bristle_{1};
};

void simulate_smooth_point(PointSetting& s, MotionRecord& record) {
  const SimulateScene& scene = s.scene;
  const MovingBody& b = scene.body;
  const PointFriction law(scene);
  // No step is short enough for a bristle that yields to nothing. Below this force it is let go: a force that passes 0
  // in proportion to time has no more than `tolerance` of its momentum left.
  const double least = std::sqrt(s.tolerance) * scene.contact.normal_force * largest_value(scene.pressing, scene.end());
  const auto pressing = [&](double t) { return scene.normal_force(t) - least; };
  bool let_go = false;
  const auto friction = [&](double t, const Flow::State& y) {
    return law(let_go ? 0 : scene.normal_force(t), y[2], y[3], y[1] - b.support_speed, s.held(t, y[0]));
  };
  Flow::State y{b.place[0], b.twist[0], 0, 0, 0, 0};
  const double zone_mass = law.zone_mass();
  if (b.settled && law.has_bristle()) y[2] = -s.held(0, y[0]) / law.stiffness();
  const bool starts_moving = b.twist[0] != b.support_speed;
  const auto& corners = scene.loads.corners();
  std::size_t next = 0;
  double t = 0;
  bool slips = false;
  while (next < s.times.size()) {
    const auto corner = std::ranges::upper_bound(corners, t);
    const double end = corner == corners.end() ? s.times.back() : std::min(s.times.back(), *corner);
    const double last = std::nextafter(end, t);
    let_go = law.yields() && (pressing(t) < 0 || least == 0);
    if (let_go || (law.yields() && scene.law.mu_static == 0)) {
      y[5] += law.stiffness() * y[2] * y[2] / 2;
      y[2] = 0;
    }
    Flow flow(
        [&](double at, const Flow::State& x, Flow::State& dx) {
          at = std::min(at, last);
          const Friction R = friction(at, x);
          const double f = s.load(at), u = x[1] - b.support_speed;
          const double acceleration = (f - b.spring * x[0] - b.damper * x[1] + R.force) / b.mass;
          const double on_support = zone_mass > 0 ? R.zone : R.force;
          dx = {x[1], acceleration, R.kappa_rate, 0, f * x[1] + on_support * b.support_speed, b.damper * x[1] * x[1]};
          if (zone_mass > 0) {
            dx[3] = (R.zone - R.force) / zone_mass - acceleration;
            dx[5] += (R.force - law.stiffness() * x[2]) * R.kappa_rate - R.zone * (u + R.kappa_rate);
          } else {
            dx[5] -= R.force * u + law.stiffness() * x[2] * R.kappa_rate;
          }
        },
        y, t, {s.tolerance, 1e-6});
    flow.watch(
        [&](double at, const Flow::State& x) { return friction(std::min(at, last), x).present - law.yielding(); });
    flow.watch([&](double, const Flow::State& x) { return x[1] - b.support_speed; });
    if (law.yields()) flow.watch([&](double at, const Flow::State&) { return pressing(std::min(at, last)); });
    const auto note = [&](double at, const Flow::State& x, std::size_t which) {
      if (which == 2) return true;
      MotionEvent e{"turn", at, 0, along_x(x[0])};
      if (which == 0) {
        e.kind = friction(std::min(at, last), x).present >= law.yielding() ? "break_away" : "sticks";
        e.margin = s.margin(at, x[0]);
      }
      record.events.push_back(e);
      if (which == 1 && starts_moving && !record.rest) record.rest = e;
      return false;
    };
    if (t > 0 && slips != (friction(t, y).present >= law.yielding())) note(t, y, 0);
    bool ended = false;
    while (next < s.times.size() && s.times[next] <= end) {
      ended = run_in_steps(flow, s.times[next], s.longest_step, note);
      if (ended) break;
      const Flow::State& x = flow.state();
      const Friction R = friction(std::min(flow.time(), last), x);
      MotionRow row{flow.time(), along_x(x[0]), along_x(x[1])};
      row.deflection = along_x(-x[2]);
      row.friction = along_x(R.force);
      row.slips = R.present >= law.yielding();
      row.kinetic = (b.mass * x[1] * x[1] + zone_mass * (x[1] + x[3]) * (x[1] + x[3])) / 2;
      row.stored = b.spring * x[0] * x[0] / 2 + law.stiffness() * x[2] * x[2] / 2;
      row.work = x[4];
      row.dissipated = x[5];
      s.add(record, row);
      ++next;
    }
    if (next < s.times.size() && !ended) ended = run_in_steps(flow, end, s.longest_step, note);
    y = flow.state();
    t = ended ? flow.time() : end;
    slips = friction(std::min(t, last), y).present >= law.yielding();
  }
}

}  // namespace

void simulate_point(const SimulateScene& scene, bool second, MotionRecord& record) {
  PointSetting s(scene, second);
  if (scene.following.method == FrictionMethod::rigid) return simulate_rigid_point(s, record);
  simulate_smooth_point(s, record);
}

}  // namespace patchgrip::cli
