// Primal-dual interior point for the problems of grip_problem.h, every cone an ellipsoid over its limit surface.
//
// The homogeneous self-dual embedding of  min c x : A x = b tau, x in K,  with Nesterov-Todd scaling and Mehrotra's
// predictor and corrector. Each contact is eliminated on its own: with H of lorentz.h
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
// slip (element.h), until the gap is 1e-4: what is left is of second order in that. polish.h and bracket.h do not rely on
// it.
//
// Status   optimal, or infeasible (max_force, total_force: the twist is a ray with all rho_i <= 0), to the tolerance; or
//          stalled: normal equations give about 1e-9 and no more. The iterates stay valid, and run() goes on from them.
// Memory   allocated by the constructor; nothing after.
#pragma once

#include <vector>

#include <patchgrip/grasp/grip_problem.h>
#include <patchgrip/grasp/lorentz.h>
#include <patchgrip/grasp/square_sum.h>

namespace patchgrip::grasp {

class InteriorPoint {
 public:
  enum class Status { optimal, infeasible, stalled };

  explicit InteriorPoint(const ScaledGrasp& grasp);

  // Afresh; `problem` must be of the same grasp.
  void start(const GripProblem& problem) noexcept;
  Status run(double tolerance, int max_iterations) noexcept;

  // Moves the forces into balance, in the metric of the present scaling. run() goes on from where they were.
  bool balance() noexcept;

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
  template <int d>
  struct Block {
    using V = lorentz::Vector<d>;
    Eigen::Matrix<double, 6, d> A;
    lorentz::Scaling<d> scaling;
    V x, z, rd, rx, dx, dz, px, pz;
    Vector6 a;  // A H e_0
    std::size_t contact = 0;
    double cost = 0;

    Eigen::Matrix<double, 6, d - 1> B;
    double pivot;        // eta^2 c
    bool joins = false;  // a part before it has the same cap
    Vector6 difference;  // to those parts

    // B, a and the pivot of the present scaling.
    void set_squares() noexcept;
  };
  struct Cone : Block<4> {
    Matrix3 L;  // t = mu F L s, |s| <= 1
  };
  struct Cap {
    double slack, u;  // slack of F_i <= c_i s, multiplier
    double c, c0;     // F + slack = c s + c0 tau
    double h, D, q;   // slack / u, pivot, right-hand side
    double rq, rc;    // residuals
    double pivot;     // sum of eta^2 c of its parts
    double dv, dslack, pv, pslack;
    Vector6 a;  // sum of A H e_0
  };
  struct Step {
    Vector6 y;
    double border, dzs;  // of s or lambda; of the dual of s
  };

  template <class F>
  void each(F&& f) {
    for (Cone& b : cones_) f(static_cast<Block<4>&>(b));
    if (elastic_used_) f(elastic_);
  }

  void set_cone(Cone& cone, const Element& element) noexcept;
  void renew_ellipsoids() noexcept;
  double residuals() noexcept;
  bool factor() noexcept;
  template <bool corrector>
  Step solve(double eta, double rs) noexcept;
  Step reduced(const Vector6& right, double corner) const noexcept;
  double longest(const Step& step, double dtau, double dkappa, double most) noexcept;
  bool advance() noexcept;

  const ScaledGrasp* grasp_;
  std::vector<Cone> cones_;
  std::vector<Cap> caps_;
  Block<7> elastic_;
  bool elastic_used_ = false, capped_ = false, factored_load_ = false, patches_ = false;
  bool renewing_ = false, balanced_ = false;
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
