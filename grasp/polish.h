// Newton's method on the optimality conditions with the exact D, from a guess of which contacts slip, stick and open.
//
//     balance    w + sum F_i (N_i - mu T_i grad D_i(v_i)) + sum (F_i N_i + T_i t_i) = 0     (slipping, sticking)
//     slipping   v_i = T_i^T W, t_i = -mu F_i grad D_i(v_i)
//     sticking   T_i^T W = 0, g(t_i) <= mu F_i
//     F_i        free: rho_i(W) = 0 (total_force: 1);  at its cap: F_i = c_i s, rho_i >= 0;  open: F_i = 0, rho_i <= 0
//     and        sum c_i rho_i+ = 1 (max_force), w_1 . W = 1 (load_factor), M W = balance (distance)
//
// The matrix is symmetric, of size 6 (7) + one for each free force + the friction components that stick. Where forces
// or twist are not unique it is singular but solvable: complete pivoting leaves what it does not determine as it was.
// It is used again while it gains four digits a step.
// After convergence wrong signs change the guess, and it starts again.
//
// Nothing here is believed: bracket.h evaluates what comes out afresh.
//
// Domain   up to `capacity` unknowns: false beyond it. Memory: allocated by the constructor.
#pragma once

#include <Eigen/LU>
#include <vector>

#include <patchgrip/grasp/grip_problem.h>
#include <patchgrip/grasp/interior_point.h>

namespace patchgrip::grasp {

enum class Slide { slips, sticks };

struct PartState {
  bool active = false;           // F > 0
  Slide slide = Slide::sticks;   // of a part with friction
  double force = 0;              // F
  Vector3 friction = {0, 0, 0};  // t
  Vector3 v = {0, 0, 0};         // slip that D was linearised at
};

class Polish {
 public:
  static constexpr int capacity = 72;

  explicit Polish(const ScaledGrasp& grasp);

  // The guess that the interior point suggests.
  void identify(const GripProblem& problem, const InteriorPoint& point) noexcept;

  // Newton's method with the guess as it is; false if it did not come near a solution. W, value and states are what it
  // came to in any case, here and below.
  bool converge(const GripProblem& problem) noexcept;

  // Then changes the guess until all signs are right, at most so often; true if they are and it converged.
  bool run(const GripProblem& problem, int max_rounds) noexcept;

  const Vector6& twist() const noexcept { return W_; }
  double value() const noexcept { return s_; }  // s, lambda
  const std::vector<PartState>& parts() const noexcept { return parts_; }
  bool is_capped(std::size_t contact) const noexcept { return capped_[contact] != 0; }

  // Newton's matrix at the present states, for what refines them further (extended_polish.h); false where it is
  // infinite.
  bool factor(const GripProblem& problem) noexcept;
  // Its unknowns: W, s if `limited`, then of each active part F, unless pinned by the cap, and the friction that
  // sticks.
  Eigen::Index unknowns() const noexcept { return count_; }
  Eigen::Index unknown(std::size_t part) const noexcept { return work_[part].unknown; }
  bool is_pinned(std::size_t part) const noexcept { return work_[part].pinned; }
  using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, capacity, 1>;
  // The step that takes away a residual; not finite where there is none.
  const Column& step(const Column& residual) noexcept;

  int steps() const noexcept { return steps_; }
  int repairs() const noexcept { return repairs_; }

  // What it came to: W, s, then F and t of each part; and such a solution of a neighbouring problem, with the states of
  // the last one, as the guess.
  Eigen::Index solution_size() const noexcept { return 7 + 4 * static_cast<Eigen::Index>(parts_.size()); }
  void solution(Eigen::Ref<Eigen::VectorXd> x) const noexcept;
  void restart(const Eigen::VectorXd& x) noexcept;

 private:
  using System = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, capacity, capacity>;

  struct Work {
    Eigen::Index unknown = -1;  // column of F and, after it, of the friction that sticks
    bool pinned = false;        // F follows from the cap
    Vector6 g;                  // d wrench / d F
    Vector3 gradient;           // of D, where it slips
    double speed = 0, rho = 0;  // D, resistance
  };
  struct Change;

  double cap(const GripProblem& problem, std::size_t contact) const noexcept;
  bool arrange(const GripProblem& problem) noexcept;
  bool assemble(const GripProblem& problem, bool with_matrix) noexcept;
  void factor() noexcept;
  bool solve() noexcept;
  void update(const GripProblem& problem) noexcept;
  void pin_forces(const GripProblem& problem) noexcept;
  double newton(const GripProblem& problem, int max_steps) noexcept;
  bool repair(const GripProblem& problem, bool only_worst) noexcept;

  const ScaledGrasp* grasp_;
  std::vector<PartState> parts_;
  std::vector<Work> work_;
  std::vector<char> capped_;
  std::vector<double> sum_;  // of forces per contact
  Vector6 W_ = Vector6::Zero();
  double s_ = 0;
  int steps_ = 0, repairs_ = 0;

  System K_, scaled_;
  Column residual_, step_, scale_, right_;
  Eigen::PartialPivLU<System> regular_;
  Eigen::FullPivLU<System> singular_;
  Eigen::Index count_ = 0;  // of unknowns
  bool is_regular_ = true;
  bool reusable_ = false;   // K is that of the same unknowns, near enough
  bool displaced_ = false;  // some part is linearised elsewhere than at its own slip
  double change_ = 0;
};

}  // namespace patchgrip::grasp
