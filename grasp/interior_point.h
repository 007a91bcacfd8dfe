// Primal-dual interior point for the problems of grip_problem.h, every cone an ellipsoid over its limit surface.
//
// The homogeneous self-dual embedding of  min c x : A x = b tau, x in K,  with Nesterov-Todd scaling and Mehrotra's
// predictor and corrector. Each contact is eliminated on its own, four side by side (interior_point_kernels.h): with H of
// lorentz.h
//
// and A = (A_0, A_1) split like w = (w_0, w_1), c = 2 w_0^2 - 1, the cap F_i + slack_i = c_i s is a pivot D = eta^2 c + h,
// h = slack / multiplier, and what the contact adds to the 6 x 6 matrix of the twist is a sum of squares,
//
//     eta^2 B B^T + h / (eta^2 c D) a a^T,    B = A_1 (1 - (1 - c^-1/2) w_1 w_1^T / |w_1|^2),   a = eta^2 (c A_0 + 2 w_0 A_1 w_1)
//
// which loses no digits where contacts slip (c >> 1), as A H A^T = eta^2 (2 (A w)(A w)^T - A J A^T) would. One border for
// s or lambda is left: the work is linear in the number of contacts.
//
// Exact patches: the ellipsoid is renewed on the way to the one that has value, gradient and Hessian of D at the present
// slip (element.h), until the gap is `settled_gap`. Renewing costs iterations, and early ellipsoids may tell the wrong
// slip: of friction coefficients over decades one optimum in twenty is missed with 1e-2 that 1e-4 finds, in nearly
// twice the time. polish.h and bracket.h do not rely on it.
//
// Status   optimal, to the tolerance; infeasible (max_force, total_force), to that of rays: the twist is a ray on which
//          all rho_i <= 0 of the ellipsoids, and long before it is one to many digits those of the exact D are below 0;
//          or stalled: normal equations give about 1e-9 and no more. The iterates stay valid, and run() goes on from
//          them.
// Memory   allocated by the constructor; nothing after.
#pragma once

#include <vector>

#include <patchgrip/grasp/grip_problem.h>
#include <patchgrip/grasp/interior_point_kernels.h>
#include <patchgrip/grasp/square_sum.h>

namespace patchgrip::grasp {

class InteriorPoint {
 public:
  enum class Status { optimal, infeasible, stalled };

  explicit InteriorPoint(const ScaledGrasp& grasp, const InteriorPointKernels& kernels = interior_point_kernels());

  // Afresh; `problem` must be of the same grasp.
  void start(const GripProblem& problem, double settled_gap = 1e-4) noexcept;
  Status run(double tolerance, double ray_tolerance, int max_iterations) noexcept;

  // Moves the forces into balance, in the metric of the present scaling. run() goes on from where they were.
  bool balance() noexcept;

  bool has_patches() const noexcept { return has_patches_; }
  int iterations() const noexcept { return iterations_; }
  double gap() const noexcept { return gap_; }

  // The present point. `u` is the multiplier of the cap, near c_i s - F_i complementary; z = (rho^-, ...) of the cone.
  Vector6 twist() const noexcept;
  double value() const noexcept;  // s or lambda
  struct PartPoint {
    double force;
    Vector3 friction;
    double x_least, x_most, z_least, z_most;  // eigenvalues of x and z, scaled alike
    double slip;                              // |L^T v| / |W|
  };
  PartPoint part(std::size_t index) const noexcept;
  struct CapPoint {
    double slack, multiplier;
  };
  CapPoint cap(std::size_t contact) const noexcept;

 private:
  struct Slot {
    std::size_t block;
    int lane;
  };
  struct Step {
    Vector6 y;
    double border, dzs;  // of s or lambda; of the dual of s
  };

  bool has_s() const noexcept { return blocks_.capped && !factored_load_; }
  void set_columns(std::size_t part) noexcept;
  void renew_ellipsoids() noexcept;
  double residuals() noexcept;
  bool factor() noexcept;
  // The columns whose squares the blocks add up to, with the caps or without.
  template <class Sink>
  void emit(const Sink& sink) const;
  Step reduced(const RightSide& r) const noexcept;
  // The Newton step to the residuals times eta; or, without corrector, what a change of tau by one asks for; and what
  // the objective gains by it.
  Step solve(bool corrector, double eta, double rs, double& gain) noexcept;
  bool advance() noexcept;

  const ScaledGrasp* grasp_;
  const InteriorPointKernels* kernels_;
  std::vector<Slot> slots_;  // of the parts
  std::vector<Matrix3> L_;   // t = mu F L s, |s| <= 1
  std::vector<Cones> cones_;
  std::vector<Caps> caps_;
  std::vector<Packed<4, Pack>> balanced_x_;  // x before balance()
  ElasticBlock elastic_{};
  Blocks blocks_{};
  bool factored_load_ = false, has_patches_ = false, renewing_ = false, balanced_ = false;
  double settled_gap_ = 1e-4, twist_size_ = 0;
  int rank_ = 6;

  Vector6 b_, w1_, y_, rp_;
  double scale_ = 1, step_scale_ = 1;
  double s_ = 1, zs_ = 1, tau_ = 1, kappa_ = 1, lambda_ = 0;
  double rds_ = 0, rl_ = 0, rg_ = 0, mean_ = 1, gap_ = 1, ray_ = 1, du_ = 0, best_ = 0;
  int iterations_ = 0, idle_ = 0;

  SquareSum M_;
  Vector6 border_, border_solved_;
  double corner_ = 0, hs_ = 0;
};

}  // namespace patchgrip::grasp
