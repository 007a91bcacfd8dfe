#include <patchgrip/cli/simulate/simulate_patch.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <vector>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>
#include <patchgrip/cli/simulate/fixed_steps.h>
#include <patchgrip/cli/simulate/run_in_steps.h>
#include <patchgrip/dynamics/bristle_body.h>
#include <patchgrip/dynamics/bristle_motion.h>
#include <patchgrip/dynamics/half_freedom_patch.h>
#include <patchgrip/dynamics/patch_axes.h>
#include <patchgrip/dynamics/rigid_motion.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>

namespace patchgrip::cli {
namespace {

using dynamics::PlanarState;
using dynamics::turned;
using friction::AnyPatch;
using friction::LimitSurface;
using friction::Twist;
using friction::Wrench;

Twist twist(const Vector3& v) { return {v[0], v[1], v[2]}; }

// What every method needs of a scene.
class Setting {
 public:
  Setting(const SimulateScene& simulated, bool second_run)
      : scene(simulated),
        second(second_run),
        patch(any_patch(simulated.contact)),
        surface(patch),
        progress_("simulate", simulated.following.times.size(), !second_run && Progress::wanted(Progress::no_output)) {
    for (std::size_t i = 0; i < scene.following.times.size(); ++i) times.push_back(scene.following.times[i]);
  }

  Vector3 load(double t) const {
    InterruptGuard::check();
    return scene.loads(t);
  }

  // The twist of the patch as it is at t as the contact's patch would feel it.
  Twist felt(const Vector3& v, double t) const { return dynamics::grown(v, scene.size(t)); }

  // g / mu_s F_N of a wrench in axes of space on the body that has turned by `angle`.
  double share(double t, const Vector3& on, double angle) const {
    const double capacity = scene.capacity(t);
    if (!(capacity > 0)) return not_known;
    return surface.gauge(dynamics::shrunk(turned(on, -angle), scene.size(t))).value / capacity;
  }
  double margin(double t, double angle) const {
    const double s = share(t, scene.loads(t), angle);
    return s > 0 ? 1 / s - 1 : not_known;
  }

  Vector3 mass() const { return {scene.body.mass, scene.body.mass, scene.body.inertia}; }
  double kinetic(const Vector3& v) const { return v.dot(mass().cwiseProduct(v)) / 2; }

  PlanarState initial() const {
    PlanarState s;
    s.place = scene.body.place;
    s.twist = scene.body.twist;
    s.anchor = s.place;
    return s;
  }

  // `at` is the time that its friction is of.
  void add(MotionRecord& record, MotionRow row, double at) {
    row.share = share(at, row.friction, row.place[2]);
    record.rows.push_back(std::move(row));
    progress_.at(record.rows.size() - 1);
  }

  const SimulateScene& scene;
  bool second;
  AnyPatch patch;
  LimitSurface<AnyPatch> surface;
  std::vector<double> times;

 private:
  Progress progress_;
};

// --- rigid

dynamics::PlanarLoad planar_load(const Setting& s) {
  return {[&s](double t) { return s.load(t); }, [&s](double t) { return s.scene.normal_force(t); },
          s.scene.loads.corners(), [&s](double t) { return s.scene.size(t); }};
}

dynamics::RigidMotionSettings rigid_settings(const Setting& s) {
  dynamics::RigidMotionSettings r{.tolerance = s.scene.following.tolerance};
  r.longest_step = std::min({r.longest_step, s.scene.end() / 100, s.scene.loads.longest_step()});
  if (s.second) {
    r.tolerance = std::min(1e-3, 100 * r.tolerance);
    r.start *= 2;
  }
  return r;
}

MotionEvent event_of(const Setting& s, const dynamics::SlipEvent& e) {
  const Vector3 slip = turned({e.slip.vx, e.slip.vy, e.slip.w}, e.state.place[2]);
  const bool stops = e.kind == dynamics::SlipEvent::Kind::stop;
  return {stops ? "stop" : "break_away",     e.time, e.error, e.state.place, twist(slip),
          s.margin(e.time, e.state.place[2])};
}

void simulate_rigid(Setting& s, MotionRecord& record) {
  const SimulateScene& scene = s.scene;
  const dynamics::RigidMotion motion(s.patch, scene.body.mass, scene.body.inertia, scene.law);
  const auto note = [&](const dynamics::SlipEvent& e) {
    record.events.push_back(event_of(s, e));
    if (e.kind == dynamics::SlipEvent::Kind::stop) record.rest = record.events.back();
  };
  dynamics::RigidMotionSettings settings = rigid_settings(s);
  settings.on_event = note;
  const auto result =
      motion(planar_load(s), s.initial(), 0, scene.end(), settings, s.times, [&](double t, const PlanarState& at) {
        MotionRow row{t, at.place, at.twist};
        row.slips = !at.twist.isZero(0);
        if (row.slips) {
          const Twist own = s.felt(turned(at.twist, -at.place[2]), t);
          const Wrench r = friction_wrench(scene.law, scene.normal_force(t), s.patch, own).value;
          row.friction = turned(dynamics::carried(r, scene.size(t)), at.place[2]);
        } else {
          row.friction = -s.load(t);
        }
        row.kinetic = s.kinetic(at.twist);
        row.work = at.work;
        row.dissipated = at.dissipated;
        s.add(record, row, t);
      });
  record.events.clear();  // the same, with the errors of their times
  std::ranges::for_each(result.events, note);
}

// --- return mapping

// Where the body comes to rest from a late step on, on a rigid patch: ringing bristles do not tell.
std::optional<MotionEvent> rigid_stop(const Setting& s, const PlanarState& from, double t) {
  const dynamics::RigidMotion motion(s.patch, s.scene.body.mass, s.scene.body.inertia, s.scene.law);
  dynamics::RigidMotionSettings settings{.tolerance = 1e-10};
  const double left = 2 * s.kinetic(from.twist) / (s.scene.capacity(t) * s.patch.dissipation(s.felt(from.twist, t)));
  const auto r = motion(planar_load(s), from, t, t + 100 * left, settings);
  if (r.events.empty() || r.events[0].kind != dynamics::SlipEvent::Kind::stop) return std::nullopt;
  return event_of(s, r.events[0]);
}

template <class P>
void follow_bristles(Setting& s, const P& patch, MotionRecord& record) {
  const SimulateScene& scene = s.scene;
  const Following& f = scene.following;
  const BristleSettings& b = f.bristle;
  const dynamics::BristleBody body(
      patch, {scene.body.mass, scene.body.inertia, {b.stiffness, b.turn_stiffness}, b.damping, b.turn_damping});
  const auto method = f.implicit_euler ? dynamics::Method::implicit_euler : dynamics::Method::sdirk2;
  const double longest = s.second ? f.step / 2 : f.step;
  PlanarState state = s.initial();
  const Vector3 K(b.stiffness, b.stiffness, b.turn_stiffness);
  if (scene.body.settled) state.anchor -= s.load(0).cwiseQuotient(K);
  const friction::PressureMoments moments = patch.moments();
  double last = 0;  // just before a corner
  const auto limit = [&](double at, const Vector3& v) {
    const double now = std::min(at, last);
    const double mu = coefficient(scene.law, moments, s.felt(turned(v, -state.place[2]), now));
    return dynamics::Admissible(mu * scene.normal_force(now), scene.size(now));
  };
  const auto speed = [&](const PlanarState& x, double at) {
    return std::hypot(x.twist[0], x.twist[1], s.patch.area_radius() * scene.size(at) * x.twist[2]);
  };
  // What bent bristles can give back: slower slips than that are of their ringing.
  const auto ringing = [&](double capacity) { return capacity * capacity / (2 * b.stiffness); };
  const double last_stage = f.implicit_euler ? 1 : 1 - dynamics::sdirk2_gamma;  // of a step
  double t = 0, friction_time = 0;
  Vector3 friction = -s.load(0);
  if (!scene.body.settled) friction.setZero();
  bool slips = false;
  std::optional<std::pair<double, PlanarState>> late;  // the last state that slides on for half a step, by itself
  const auto add_row = [&] {
    MotionRow row{t, state.place, state.twist, state.deflection(), friction};
    row.slips = slips;
    row.kinetic = body.kinetic_energy(state);
    row.stored = body.stored_energy(state);
    row.work = state.work;
    row.dissipated = state.dissipated;
    s.add(record, row, friction_time);
  };
  const auto finish_slip = [&] {
    record.events.push_back({"sticks", t, longest, state.place, std::nullopt, s.margin(t, state.place[2])});
    if (!record.rest) record.rest = record.events.back();
    if (late) {
      if (auto stop = rigid_stop(s, late->second, late->first)) record.rest = std::move(stop);
    }
    late.reset();
  };
  const auto load = [&](double at) { return s.load(std::min(at, last)); };
  const auto take_step = [&](double, double h, double end, double last_of_piece) {
    last = last_of_piece;
    const auto r = body.step(state, t, h, method, load, limit);
    for (const double x : r.state.twist) {
      if (!std::isfinite(x)) dynamics::refuse_step(t);
    }
    const bool moves = r.slips && !r.slip.isZero(0);  // what nothing presses need not
    if (moves && !slips) {
      const double D = patch.dissipation(s.felt(r.slip, std::min(t + h, last)));
      record.events.push_back({"break_away", t, longest, state.place, twist(r.slip / D), s.margin(t, state.place[2])});
    }
    const double before = speed(state, t), after = speed(r.state, std::min(t + h, last));
    if (f.rest_speed && (before > *f.rest_speed) != (after > *f.rest_speed)) {
      const double at = t + h * (before - *f.rest_speed) / (before - after);
      record.events.push_back({"rest_speed", at, 0, r.state.place});
    }
    state = r.state;
    friction = r.wrench;
    friction_time = std::min(t + last_stage * h, last);
    const bool ended = slips && !moves;
    slips = moves;
    t = end;
    if (ended) finish_slip();
    const double D = slips ? s.patch.dissipation(s.felt(state.twist, t)) : 0, T = s.kinetic(state.twist);
    const double capacity = scene.capacity(t);
    if (D > 0 && capacity > 0 && T > std::max(h / 4 * capacity * D, ringing(capacity))) late = {t, state};
  };
  take_fixed_steps(
      s.times, scene.loads.corners(), longest, [&](double) { add_row(); }, take_step);
}

void simulate_return_mapping(Setting& s, MotionRecord& record) {
  std::visit(
      [&](const auto& patch) {
        const friction::PlanarFrame& frame = s.scene.contact.frame;
        const bool centred = frame.x == 0 && frame.y == 0;
        if constexpr (dynamics::RoundAboutOrigin<std::decay_t<decltype(patch)>>) {
          if (centred) return follow_bristles(s, patch, record);
        }
        follow_bristles(s, s.patch, record);
      },
      s.scene.contact.patch);
}

// --- elastoplastic, half a degree of freedom

template <class Bristle>
void follow_bristle_law(Setting& s, const Bristle& bristle, MotionRecord& record) {
  using Motion = dynamics::BristleMotion<Bristle>;
  const SimulateScene& scene = s.scene;
  const Following& f = scene.following;
  const Motion motion(bristle, scene.body.mass, scene.body.inertia);
  typename Motion::State y{};
  for (std::size_t i = 0; i < 3; ++i) {
    y[i] = scene.body.place[static_cast<Eigen::Index>(i)];
    y[i + 3] = scene.body.twist[static_cast<Eigen::Index>(i)];
  }
  if (scene.body.settled) {
    const Vector3 kappa = turned(s.load(0), -y[2]).cwiseQuotient(bristle.parameters().stiffness);
    for (std::size_t i = 0; i < 3; ++i) y[i + 6] = kappa[static_cast<Eigen::Index>(i)];
  }
  const auto place = [](const auto& x) { return Vector3(x[0], x[1], x[2]); };
  const auto speed = [&](const auto& x) { return std::hypot(x[3], x[4], s.patch.area_radius() * x[5]); };
  const double tolerance = std::min(1e-3, s.second ? 100 * f.tolerance : f.tolerance);
  const double longest = scene.loads.longest_step();
  const auto& corners = scene.loads.corners();
  std::size_t next = 0;
  double t = 0;
  while (next < s.times.size()) {
    const auto corner = std::ranges::upper_bound(corners, t);
    const double end = corner == corners.end() ? s.times.back() : std::min(s.times.back(), *corner);
    const double last = std::nextafter(end, t);
    typename Motion::Flow flow([&](double at, const auto& x, auto& dx) { dx = motion(s.load(std::min(at, last)), x); },
                               y, t, {tolerance, 1e-6});
    flow.watch([&](double, const auto& x) { return motion.excess(x); });
    if (f.rest_speed) flow.watch([&](double, const auto& x) { return speed(x) - *f.rest_speed; });
    const auto note = [&](double at, const auto& x, std::size_t which) {
      MotionEvent e{"rest_speed", at, 0, place(x)};
      if (which == 0) {
        e.kind = motion.excess(x) >= 0 ? "break_away" : "sticks";
        e.margin = s.margin(at, x[2]);
        if (e.kind == "break_away" && speed(x) > 0) e.slip = Twist{x[3], x[4], x[5]};
      }
      record.events.push_back(e);
      return false;
    };
    while (next < s.times.size() && s.times[next] <= end) {
      run_in_steps(flow, s.times[next], longest, note);
      const auto& x = flow.state();
      MotionRow row{flow.time(), place(x), {x[3], x[4], x[5]}};
      row.deflection = turned({x[6], x[7], x[8]}, x[2] - x[8]);
      row.friction = motion.wrench(x);
      row.slips = motion.excess(x) >= 0;
      row.kinetic = motion.kinetic_energy(x);
      row.stored = motion.stored_energy(x);
      row.work = x[9];
      row.dissipated = x[10];
      s.add(record, row, row.time);
      ++next;
    }
    if (next < s.times.size()) run_in_steps(flow, end, longest, note);
    y = flow.state();
    t = end;
  }
}

template <class Surface>
void follow_elastoplastic(Setting& s, const Surface& surface, MotionRecord& record) {
  const Following& f = s.scene.following;
  const BristleSettings& b = f.bristle;
  const friction::PressureMoments m = s.patch.moments();
  dynamics::PatchBristleParameters p{{b.stiffness, b.stiffness, b.turn_stiffness},
                                     {b.damping, b.damping, b.turn_damping},
                                     b.length.value_or(s.patch.dissipation(friction::twist_about({m.x, m.y}, 1)))};
  if (f.method == FrictionMethod::elastoplastic_printed) p.form = dynamics::BristleForm::printed;
  p.elastic_share = b.elastic_share;
  p.nu0.setConstant(b.nu0);
  follow_bristle_law(s, dynamics::PatchBristle<Surface>(surface, p, s.scene.law, s.scene.contact.normal_force), record);
}

void simulate_half_freedom(Setting& s, MotionRecord& record) {
  const BristleSettings& b = s.scene.following.bristle;
  const dynamics::HalfFreedomParameters p{{b.stiffness, b.stiffness, b.turn_stiffness},
                                          {b.damping, b.damping, b.turn_damping}};
  std::visit(
      [&](const auto& patch) {
        using P = std::decay_t<decltype(patch)>;
        const friction::PlanarFrame& frame = s.scene.contact.frame;
        const auto follow = [&](const auto& at_origin) {
          follow_bristle_law(s, dynamics::HalfFreedomPatch(at_origin, p, s.scene.law, s.scene.contact.normal_force),
                             record);
        };
        if constexpr (std::same_as<P, friction::HertzDisc> || std::same_as<P, friction::UniformDisc>) {
          if (frame.x == 0 && frame.y == 0) return follow(patch);
        }
        follow(s.patch);
      },
      s.scene.contact.patch);
}

void simulate_elastoplastic(Setting& s, MotionRecord& record) {
  std::visit(
      [&](const auto& patch) {
        using P = std::decay_t<decltype(patch)>;
        const friction::PlanarFrame& frame = s.scene.contact.frame;
        if constexpr (std::same_as<P, friction::HertzDisc> || std::same_as<P, friction::UniformDisc>) {
          if (frame.x == 0 && frame.y == 0) return follow_elastoplastic(s, friction::RoundLimitSurface(patch), record);
        }
        follow_elastoplastic(s, s.surface, record);
      },
      s.scene.contact.patch);
}

}  // namespace

void simulate_patch(const SimulateScene& scene, bool second, MotionRecord& record) {
  Setting s(scene, second);
  switch (scene.following.method) {
    case FrictionMethod::return_mapping:
      simulate_return_mapping(s, record);
      break;
    case FrictionMethod::elastoplastic:
    case FrictionMethod::elastoplastic_printed:
      simulate_elastoplastic(s, record);
      break;
    case FrictionMethod::half_freedom:
      simulate_half_freedom(s, record);
      break;
    default:
      simulate_rigid(s, record);
  }
  for (const MotionEvent& e : record.events) {
    if (e.kind == "rest_speed") record.rest = e;
  }
}

}  // namespace patchgrip::cli
