// A body on a rigid patch under a load that changes: exact stick, set-valued slip, and the times between them.
//
//     stick   v = 0 while g(-f(t)) <= mu_s F_N(t)                                        (friction/limit_surface)
//     slip    M v' = f(t) + t(v),    t(v) = -mu(v_m) F_N grad D(v)                                (friction/law.h)
//
// Near rest the direction of v turns ever faster, and no step of t is short enough. With
// p = M^(1/2) v = rho n, |n| = 1, and the stretched time ds = dt / rho
//
//     dn/ds = G - n (n . G),   d ln rho / ds = n . G,   dt/ds = rho,   dx/ds = rho v,       G = M^(-1/2) (f + t)
//
// is regular through the stop: rho falls exponentially, t converges, n tends to the pole of the stop, for a puck the
// root of f(x) = q x m(x).
//
// Patch        under the centre of mass; turns with the body, and may grow with its load: where its lengths are `size`
//              times those given, it is followed as the one given at (vx, vy, size w), which carries (f, m / size).
// Break-away   the root of g(f(t)) - mu_s F_N(t), bracketed by samples `longest_step` apart. At a jump of the load the
//              body leaves with the acceleration a = argmin a . M a / 2 + D(a) mu_s F_N - f . a, the return mapping in
//              the metric M. Where the load passes the limit steadily it leaves along the gauge's slip n,
//
//                  d(v . M v / 2)/dt = (g(f) - mu_s F_N) D(v),        v = D(v) n,
//
//              by Simpson's rule in steps of 100 `start` of longest_step and of what is left before a jump, until the
//              load passes the limit by the share `start`, or the speed changes what is left of it by this share: near
//              the limit slip turns to n faster than steps of t could follow. Where the limit is nothing, or that time
//              none that could be told from now, it leaves with the return mapping's acceleration for such a step; where
//              no such step is left before a jump, it leaves there.
// Stop         rho down to 1e-17 of its largest since break-away; then again stick, or at once another start.
// Load         f(t) [N], [N], [N m] in axes of space about the centre of mass, continuous but for `jumps`, which are
//              increasing. F_N(t) >= 0 and the size likewise.
// Units        m [kg], J [kg m^2], t [s].
// Error        of times and places: tolerance and start twice as wide (a hundredfold, twofold) tell; `error` of each
//              event. They do not tell that of a load that never passes the limit by the share `start`: places then
//              err by less than the share by which it does. Stop time and distance of pucks to 1e-13 at the tolerance
//              1e-13; tests/dynamics/rigid_motion_test.cc.
// Throws       std::invalid_argument unless m, J > 0, the settings are in range, times do not decrease, the start is
//              finite, and the load, too, with F_N >= 0 and a size > 0, wherever it is asked for; std::runtime_error
//              as trajectory.h.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/planar_state.h>
#include <patchgrip/dynamics/return_mapping.h>
#include <patchgrip/friction/law.h>

namespace patchgrip::dynamics {

struct SlipEvent {
  enum class Kind { break_away, stop };

  Kind kind;
  double time;           // [s]
  friction::Twist slip;  // direction, D = 1; its pole is that of the event
  PlanarState state;
  double error = 0;  // of the time [s]
};

struct RigidMotionSettings {
  double tolerance = 1e-12;                             // of a step, relative, in [1e-14, 1e-3]
  double longest_step = 1e-2;                           // [s], > 0, between looks at a load that is held
  double start = 5e-3;                                  // share of the limit, at a steady load, in [1e-6, 0.5]
  std::function<void(const SlipEvent&)> on_event = {};  // each as it happens, the error of its time not yet known

  void check() const;
};

struct PlanarLoad {
  std::function<Vector3(double t)> force;        // f
  std::function<double(double t)> normal_force;  // F_N
  std::vector<double> jumps = {};
  std::function<double(double t)> size = {};  // of the patch against the one given, about the origin; without it 1
};

struct RigidMotionResult {
  PlanarState state;  // at the end
  std::vector<SlipEvent> events;
  Vector3 place_error = Vector3::Zero();
  long evaluations = 0;  // of the friction wrench
};

// What the motion needs of a patch, its type gone.
struct RigidPatchView {
  std::function<friction::BoundedWrench(const friction::Twist&)> gradient;
  std::function<friction::Gauge(const friction::Wrench&)> gauge;
  std::function<Returned(const friction::Wrench&, double limit, const BristleMetric&)> closest;
  friction::PressureMoments moments;
};

// `watch(t, state)` is called at every one of `samples`, increasing, within [t0, t1].
using Watch = std::function<void(double t, const PlanarState& state)>;

RigidMotionResult rigid_motion(const RigidPatchView& patch, const Vector3& mass, const friction::Law& law,
                               const PlanarLoad& load, const PlanarState& from, double t0, double t1,
                               const RigidMotionSettings& settings, const std::vector<double>& samples,
                               const Watch& watch);

template <friction::Patch P>
class RigidMotion {
 public:
  RigidMotion(P patch, double mass, double inertia, const friction::Law& law)
      : mapping_(std::move(patch)),
        mass_(contact::require_positive("mass", mass), mass, contact::require_positive("inertia", inertia)),
        law_(law) {}

  RigidMotionResult operator()(const PlanarLoad& load, const PlanarState& from, double t0, double t1,
                               const RigidMotionSettings& settings = {}, const std::vector<double>& samples = {},
                               const Watch& watch = {}) const {
    const P& patch = mapping_.patch();
    const RigidPatchView view{[&](const friction::Twist& v) { return patch.bounded_gradient(v); },
                              [&](const friction::Wrench& t) { return mapping_.surface().gauge(t); },
                              [&](const friction::Wrench& t, double limit, const BristleMetric& metric) {
                                return mapping_(t, limit, metric);
                              },
                              patch.moments()};
    return rigid_motion(view, mass_, law_, load, from, t0, t1, settings, samples, watch);
  }

 private:
  ReturnMapping<P> mapping_;
  Vector3 mass_;
  friction::Law law_;
};

}  // namespace patchgrip::dynamics
