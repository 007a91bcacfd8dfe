// The grip with the least sum of squares, and what it says of what can be held.
//
//     min  sum F_i^2 + eps (R_u^2 + R_v^2 + (R_M / l)^2)_i      over admissible forces that carry w      (seed 4.67c)
//
// (4.67c adds N^2 and (N m)^2; the length l makes them one unit.) With P = diag(1, 1, l^-2) the dual is a problem in six
// variables without constraints,
//
//     max  w . W - sum h_i(n . w_i, T_i^T W),
//     h(phi, d) = min over v of  ((phi + mu D(v))+)^2 / 4 + (v - d) . P^-1 (v - d) / (4 eps),
//
// concave with a continuous gradient, the balance w + sum G_i x_i of
//
//     F = (phi + mu D(v))+ / 2,   t = P^-1 (v - d) / (2 eps) = -mu F grad D(v)  where it slips, v != 0.
//
// Newton's method on the piecewise smooth balance, regularised by its size, with a line search on the dual, converges
// from any start. D is the exact one of each contact at every step, so that nothing has to be guessed of what slips: the way
// to forces and certificates next to the boundary of what can be held. If nothing holds the load the dual grows without
// limit, and W turns into the certificate rho_i <= 0, w . W > 0.
//
// The optimum is unique in F and t, and W for grasps of full rank.
//
// Units    scaled_grasp.h; l over its length.
// Error    lower: any W and v bound the optimum from below; the rounding of D and of the sums is taken off. upper: of
//          admissible forces, what is left of the balance charged by |W|.
// Domain   eps > 0, l > 0. Memory: allocated by the constructor.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/grasp/bracket.h>
#include <patchgrip/grasp/scaled_grasp.h>
#include <patchgrip/grasp/square_sum.h>

namespace patchgrip::grasp {

class QuadraticGrip {
 public:
  struct Weights {
    double epsilon = 1;
    double length = 1;
  };

  explicit QuadraticGrip(const ScaledGrasp& grasp);

  // True if the forces balance to rounding. The load is near 1 in size. It stops where the twist shows that the largest
  // force would be above the limit.
  bool solve(const Vector6& load, const Weights& weights, int max_iterations, double force_limit) noexcept;

  const Vector6& twist() const noexcept { return W_; }
  // A twist close to the one found, moved as little as it takes to have rho_i <= 0 of the contacts that press, to
  // rounding after a few steps: where the load is not held, by far the better certificate. False if it is lost, or where more
  // contacts press than there is room for.
  bool sharpen(Vector6& W) const noexcept;
  std::span<const PartForce> forces() const noexcept { return forces_; }  // by part
  double lower() const noexcept { return lower_; }
  double upper() const noexcept { return upper_; }
  double residual() const noexcept { return residual_; }  // of the balance
  int iterations() const noexcept { return iterations_; }

 private:
  using Matrix4 = Eigen::Matrix4d;
  using Vector4 = Eigen::Vector4d;

  // Of one contact at (phi, d): h, its gradient (F, -t) and Hessian, and how far h may be off.
  struct Response {
    double h = 0, error = 0;
    Vector4 gradient = Vector4::Zero();
    Matrix4 hessian = Matrix4::Zero();
    double resistance = 0;  // rho
    bool slips = false;
  };

  Response normal_response(double phi) const noexcept;
  Response round_response(const Element& point, const Element* spin, double phi, const Vector3& d) const noexcept;
  Response smooth_response(const Element& element, double phi, const Vector3& d, Vector3& v) const noexcept;

  struct Dual {
    double value = 0, error = 0;
    Vector6 balance = Vector6::Zero();
    double total = 0;       // sum F
    double resistance = 0;  // sum rho+
    double squares = 0;     // of the forces
  };
  Dual evaluate(const Vector6& W) noexcept;
  bool factor(double regular) noexcept;
  double imbalance() const noexcept;

  const ScaledGrasp* grasp_;
  Vector6 load_ = Vector6::Zero();
  Weights weights_;
  Vector6 W_ = Vector6::Zero();
  std::vector<Vector3> slips_;     // v by part, where the last evaluation ended
  std::vector<Matrix4> hessians_;  // of h by contact, at its first part; zero at its second
  SquareSum K_;                    // the curvature, in the range
  std::vector<PartForce> forces_;
  double lower_ = 0, upper_ = 0, residual_ = 0;
  int iterations_ = 0;
};

}  // namespace patchgrip::grasp
