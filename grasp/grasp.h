// Can these contacts hold this object under this load, with how little grip, and what slips first?
//
//     least_grip      min max F_i              least_total_grip       min sum F_i      load_factor   max lambda
//     holds_within    max F_i / c_i <= 1 ?     least_quadratic_grip   min sum F_i^2 + eps |t_i|^2
//     force_closure   every load?              distance   of the load from what can be held, in |f|^2 + |m|^2 / l^2
//
// (grip_problem.h and quadratic_grip.h have them in full, seed 4.3.1.) Every answer is a bracket [lower, upper] of the
// optimum, with the forces that prove one end and the twist that proves the other; the verdict follows from the bracket
// alone:
//
//     holds         forces were found, none above the limit          (upper <= limit, charged <= 1e-3)
//     cannot_hold   every way of holding needs more than the limit   (lower > limit)
//     undecided     neither was proved; the bracket says how far apart the proofs are
//
// "Holds" means that forces exist which fingers can actively produce; how passive fingers share a load is indeterminate.
//
// The escape twist is the virtual motion that the load drives and every contact opposes least: w . W = value with
// sum c_i rho_i+ = 1 (least_grip), max rho_i = 1 (least_total_grip), w_1 . W = 1 (load_factor); of the distance, the
// residual wrench (r_f, r_m / l^2); of least_quadratic_grip, w . W = 2 value. Slipping contacts slide with it, but for
// the last, where they do with a part of it. Value and twist are sensitivities as well:
//
//     ds/dw = W,  ds/dmu_i = -F_i D_i (least_grip);   dlambda/dc_i = rho_i+,  dlambda/dmu_i = F_i D_i (load_factor)
//
// Units    as contact.h and spatial.h; lower, upper, value in N (least_*; N^2 of the quadratic one), of the limits
//          (holds_within), 1 (load_factor).
// Error    the bracket; about 1e-13 of the value for grasps that are well inside of what they can hold.
// Throws   std::invalid_argument on what is not finite, limits that are not positive, and a grasp without contacts.
// Memory   the constructor allocates; questions do not, but for the first least_quadratic_grip or distance. An answer
//          is valid until the next question.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <patchgrip/grasp/contact.h>
#include <patchgrip/grasp/grip_settings.h>
#include <patchgrip/grasp/grip_solver.h>
#include <patchgrip/grasp/quadratic_grip.h>

namespace patchgrip::grasp {

enum class Verdict { holds, cannot_hold, undecided };
enum class ContactState { opens, sticks, slips };

struct ContactAnswer {
  double normal_force = 0;       // F [N]
  Vector3 friction = {0, 0, 0};  // R_u, R_v [N], R_M [N m]
  ContactState state = ContactState::opens;
  bool at_limit = false;    // F at s c_i, or at c_i
  friction::Twist sliding;  // of the object in the escape twist; its pole is the contact's (twist.h)
  double dissipation = 0;   // D of the sliding, of unit mu F
  double resistance = 0;    // rho(W): < 0 where the contact opens, > 0 where it is pushed back
};

struct GripAnswer {
  Verdict verdict = Verdict::undecided;
  double value = 0;
  double lower = 0;
  double upper = 0;
  Vector6 escape_twist = Vector6::Zero();
  std::vector<ContactAnswer> contacts;
  double balance_residual = 0;  // of forces and load, relative to the load; its price is in the bracket
  double charged = 0;           // share of that price in the bracket
  Effort effort;
};

class Grasp {
 public:
  explicit Grasp(std::vector<Contact> contacts, const GripSettings& settings = {});

  const std::vector<Contact>& contacts() const noexcept { return contacts_; }

  const GripAnswer& least_grip(const Vector6& load);
  const GripAnswer& holds_within(const Vector6& load, std::span<const double> limits);
  const GripAnswer& least_total_grip(const Vector6& load);
  // Largest lambda for which `load` + lambda `step` is carried with F_i <= limits_i.
  const GripAnswer& load_factor(const Vector6& load, const Vector6& step, std::span<const double> limits);

  // By what the load misses all that can be held; it is held, or is at the edge of it, where that is 0. `length` is l.
  const GripAnswer& distance(const Vector6& load, double length);

  // 4.67c with P = diag(1, 1, l^-2), epsilon > 0.
  const GripAnswer& least_quadratic_grip(const Vector6& load, double epsilon, double length);

  // From the solution of the last question of the same kind, for loads that change little; never worse than from
  // nothing.
  const GripAnswer& next_least_grip(const Vector6& load);

  // Whether every load can be held. The answer is that of the load -sum (n_i, r_i x n_i): with forces that carry it and
  // unit normal forces added every contact is strictly inside its cone and the object is in balance; if it cannot be
  // held, the escape twist opens the grasp.
  const GripAnswer& force_closure();

 private:
  // A grasp about a centre of its own, and what solves it.
  struct Workspace {
    Workspace(const std::vector<Contact>& contacts, const GripSettings& settings, const std::optional<Vector3>& centre)
        : scaled(contacts, centre), solver(scaled, settings) {}

    ScaledGrasp scaled;
    GripSolver solver;
  };

  void ask(GripProblem problem, double limit, bool warm);
  void report(const Workspace& from, const GripProblem& problem, double size, double pace, double limit);
  void report_contacts(const ScaledGrasp& grasp, std::span<const PartForce> forces, const Vector6& W, double size,
                       double pace);
  Vector6 scaled(const char* name, const Vector6& load) const;
  void set_limits(std::span<const double> limits, double scale);

  std::vector<Contact> contacts_;
  GripSettings settings_;
  std::unique_ptr<Workspace> own_;
  std::unique_ptr<Workspace> about_origin_;  // of the distance, whose metric takes moments about the origin
  std::unique_ptr<QuadraticGrip> quadratic_;
  std::vector<double> limits_;
  GripAnswer answer_;
};

}  // namespace patchgrip::grasp
