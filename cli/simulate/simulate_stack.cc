#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/LU>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>
#include <patchgrip/cli/simulate/fixed_steps.h>
#include <patchgrip/cli/simulate/simulate_patch.h>
#include <patchgrip/dynamics/patch_axes.h>
#include <patchgrip/dynamics/stacked_bodies.h>
#include <patchgrip/dynamics/trajectory.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>

namespace patchgrip::cli {
namespace {

using dynamics::Matrix6;
using dynamics::StackState;
using dynamics::turned;
using dynamics::Vector6;
using friction::AnyPatch;
using friction::Twist;

// One of the two contacts: of body 1 on the ground, of body 2 on body 1.
struct Interface {
  Interface(const Contact& contact, const friction::Law& friction_law)
      : patch(any_patch(contact)), surface(patch), law(friction_law), normal_force(contact.normal_force) {}

  // Both in the axes of the patch.
  double limit(const Vector3& v) const {
    return coefficient(law, patch.moments(), Twist{v[0], v[1], v[2]}) * normal_force;
  }
  double share(const Vector3& t) const {
    const double capacity = law.mu_static * normal_force;
    return capacity > 0 ? surface.gauge({t[0], t[1], t[2]}).value / capacity : not_known;
  }
  Twist direction(const Vector3& slip, double to_space, double to_patch) const {
    const Vector3 own = turned(slip, to_patch);
    return as_twist(turned(slip, to_space) / patch.dissipation(as_twist(own)));
  }
  static Twist as_twist(const Vector3& v) { return {v[0], v[1], v[2]}; }

  AnyPatch patch;
  friction::LimitSurface<AnyPatch> surface;
  friction::Law law;
  double normal_force;
};

dynamics::BristleBodyParameters parameters(const MovingBody& body, const BristleSettings& b) {
  return {body.mass, body.inertia, {b.stiffness, b.turn_stiffness}, b.damping, b.turn_damping};
}

Vector6 both(const Vector3& lower, const Vector3& upper) {
  Vector6 all;
  all << lower, upper;
  return all;
}

Vector3 of(const Vector6& all, int which) { return all.segment<3>(3 * which); }

}  // namespace

void simulate_stack(const SimulateScene& scene, bool second, MotionRecord& record) {
  const UpperBody& upper = *scene.upper;
  const Following& f = scene.following;
  const std::array<Interface, 2> contacts{Interface{scene.contact, scene.law}, Interface{upper.contact, upper.law}};
  const auto lower_parameters = parameters(scene.body, f.bristle),
             upper_parameters = parameters(upper.body, upper.bristle);
  const dynamics::StackedBodies stack(contacts[0].patch, contacts[1].patch, lower_parameters, upper_parameters);
  const auto method = f.implicit_euler ? dynamics::Method::implicit_euler : dynamics::Method::sdirk2;
  const double longest = second ? f.step / 2 : f.step;
  std::vector<double> times;
  for (std::size_t i = 0; i < f.times.size(); ++i) times.push_back(f.times[i]);
  Progress progress("simulate", times.size(), !second && Progress::wanted(Progress::no_output));

  const auto load_at = [&](double t) {
    InterruptGuard::check();
    return both(scene.loads(t), upper.loads(t));
  };
  StackState state;
  state.place = both(scene.body.place, upper.body.place);
  state.twist = both(scene.body.twist, upper.body.twist);
  // What the bristles carry: A in axes of space, B in those of body 1.
  Vector6 wrench = Vector6::Zero();
  if (scene.body.settled) {
    const Matrix6 G = dynamics::stack_motion(state.place);
    wrench = G.transpose().partialPivLu().solve(load_at(0));
    const Vector3 k(f.bristle.stiffness, f.bristle.stiffness, f.bristle.turn_stiffness);
    const Vector3 k_upper(upper.bristle.stiffness, upper.bristle.stiffness, upper.bristle.turn_stiffness);
    state.anchor = -wrench.cwiseQuotient(both(k, k_upper));
  }
  std::array<bool, 2> slips{};
  double t = 0, last = 0;
  const auto load = [&](double at) { return load_at(std::min(at, last)); };
  // From the axes of a contact's wrench and slip to those of its patch.
  const auto to_patch = [&](int which) { return which == 0 ? -state.place[2] : state.place[2] - state.place[5]; };
  const auto limit = [&](int which, double, const Vector3& v) {
    return contacts[static_cast<std::size_t>(which)].limit(turned(v, to_patch(which)));
  };
  const auto row_of = [&](int which) {
    const double to_space = which == 0 ? 0 : state.place[2];
    MotionRow row{t, of(state.place, which), of(state.twist, which), turned(of(state.deflection(), which), to_space)};
    row.friction = -turned(of(wrench, which), to_space);
    row.share = contacts[static_cast<std::size_t>(which)].share(turned(of(wrench, which), to_patch(which)));
    row.slips = slips[static_cast<std::size_t>(which)];
    row.anchor = of(state.anchor, which);
    return row;
  };
  const auto add_rows = [&](double) {
    MotionRow row = row_of(0);
    row.kinetic = stack.kinetic_energy(state);
    row.stored = stack.stored_energy(state);
    row.work = state.work;
    row.dissipated = state.dissipated;
    record.rows.push_back(row);
    record.upper_rows.push_back(row_of(1));
    progress.at(record.rows.size() - 1);
  };
  const auto take_step = [&](double, double h, double end, double last_of_piece) {
    last = last_of_piece;
    const auto r = stack.step(state, t, h, method, load, limit);
    if (!r.state.twist.allFinite()) dynamics::refuse_step(t);
    const bool moved = slips[0] || slips[1];
    for (const int which : {0, 1}) {
      const std::size_t i = static_cast<std::size_t>(which);
      const bool moves = r.slips[i] && !of(r.slip, which).isZero(0);
      if (moves == slips[i]) continue;
      slips[i] = moves;
      MotionEvent event{moves ? "break_away" : "sticks", moves ? t : end, longest,
                        of(moves ? state.place : r.state.place, which)};
      if (moves)
        event.slip = contacts[i].direction(of(r.slip, which), which == 0 ? 0 : state.place[2], to_patch(which));
      event.upper = which == 1;
      record.events.push_back(event);
    }
    state = r.state;
    wrench = r.wrench;
    t = end;
    if (moved && !slips[0] && !slips[1]) {
      record.rest = MotionEvent{"sticks", t, longest, of(state.place, 0)};
      record.upper_rest = MotionEvent{"sticks", t, longest, of(state.place, 1)};
    }
  };
  take_fixed_steps(times, scene.loads.corners(), longest, add_rows, take_step);
}

}  // namespace patchgrip::cli
