// A point mass that rubs on a support which moves: exact stick, set-valued slip, and the times between them.
//
//     m x'' = f(t) - k x - c x' + R,      u = x' - v_0
//     stick   u = 0 while |q| <= mu_h F_N(t),  q = f - k x - c v_0;  R = -q
//     slip    R = S(u) + V(u)                                                                 (point_law.h)
//
// A block on a belt: k the spring that holds it back, v_0 the belt. mu_h is the coefficient at rest, mu_s unless given:
// with mu_h > mu_s friction falls at once when the point breaks away.
//
// Events   break-away: the root of |q| - mu_h F_N; stop: that of u, where the support holds the point; turn: that of
//          u where it does not; extreme: x' = 0 while it slips on a support that moves. Looked for in steps of
//          `longest_step` at most.
// Energy   d(m x'^2 / 2 + k x^2 / 2) = f dx + R v_0 dt + R u dt - c x'^2 dt: work of load and support, loss by friction
//          and in the damper, all of them states of the same integration.
// Load     f(t), F_N(t) >= 0 continuous but for `jumps`, which are increasing.
// Units    m [kg], k [N/m], c [N s/m], f, F_N [N]; t [s], x [m].
// Error    of event times: from a run at a hundred times the tolerance. Period and amplitude of the stick-slip of a
//          belt to 1e-12 at the tolerance 1e-15; tests/dynamics/point_motion_test.cc.
// Throws   std::invalid_argument unless m > 0, k, c >= 0, mu_h >= mu_s, the settings are in range, times do not
//          decrease and the load is finite with F_N >= 0; std::runtime_error as trajectory.h.
#pragma once

#include <functional>
#include <vector>

#include <patchgrip/dynamics/point_law.h>

namespace patchgrip::dynamics {

struct PointBody {
  double mass;
  double spring = 0;
  double damper = 0;
  double support_speed = 0;  // v_0 [m/s]
};

struct PointLoad {
  std::function<double(double t)> force;         // f
  std::function<double(double t)> normal_force;  // F_N
  std::vector<double> jumps = {};
};

struct PointState {
  double x = 0, v = 0;
  double load_work = 0, support_work = 0;     // [J]
  double friction_loss = 0, damper_loss = 0;  // [J], >= 0
};

struct PointEvent {
  enum class Kind { break_away, stop, turn, extreme };

  Kind kind;
  double time;
  PointState state;
  double error = 0;  // of the time [s]
};

struct PointMotionSettings {
  double tolerance = 1e-12;                              // of a step, in [1e-15, 1e-3]
  double longest_step = 1e-2;                            // [s], > 0
  std::function<void(const PointEvent&)> on_event = {};  // each as it happens, the error of its time not yet known

  void check() const;
};

struct PointMotionResult {
  PointState state;  // at the end
  bool sticks = false;
  std::vector<PointEvent> events;
};

// `watch(t, state, friction)` is called at every one of `samples`, increasing, with R [N].
using PointWatch = std::function<void(double t, const PointState& state, double friction)>;

class PointMotion {
 public:
  PointMotion(const PointBody& body, const Law& law) : PointMotion(body, law, law.mu_static) {}
  PointMotion(const PointBody& body, const Law& law, double mu_hold);

  PointMotionResult operator()(const PointLoad& load, const PointState& from, double t0, double t1,
                               const PointMotionSettings& settings = {}, const std::vector<double>& samples = {},
                               const PointWatch& watch = {}) const;

 private:
  PointBody body_;
  Law law_;
  double mu_hold_;
};

}  // namespace patchgrip::dynamics
