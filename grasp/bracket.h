// What a twist and what forces prove of a problem, evaluated afresh from D, with every rounding charged.
//
// A twist W bounds the optimum through weak duality (grip_problem.h), e.g. min max F >= w . W / sum c_i rho_i+(W): the
// power w . W is taken less its rounding, each rho_i with its own added. Nothing else is asked of W.
//
// Forces are first made admissible, F >= g(t) / mu with the certified gauge, then summed: what is left of the balance,
// r, is charged by |r| max |W| / sum c_i rho_i+ over the twists seen. That is what carrying -r as well would cost to first
// order: `charged` says how much of the bound it is, and where it is more than a thousandth nobody should rely on it.
//
// Units    those of the problem. Sums are extended: what is charged is the rounding of the scaled data (scaled_grasp.h).
#pragma once

#include <limits>
#include <vector>

#include <patchgrip/grasp/grip_problem.h>

namespace patchgrip::grasp {

struct PartForce {
  double force = 0;
  Vector3 friction = {0, 0, 0};
  bool on_surface = false;  // friction = -mu F grad D of some slip: admissible but for the rounding of D
};

class Bracket {
 public:
  explicit Bracket(const ScaledGrasp& grasp);

  void reset(const GripProblem& problem) noexcept;
  void add_twist(const Vector6& W) noexcept;
  // `value` is lambda of load_factor. False where the forces do not balance at all.
  bool add_forces(std::span<const PartForce> forces, double value) noexcept;

  // Bounds that were evaluated in more digits, those of the forces without the charge for what is left, `residual`.
  void add_extended(double lower, const Vector6& W, std::span<const PartForce> forces, double upper,
                    double residual) noexcept;

  double lower() const noexcept { return lower_; }
  double upper() const noexcept;                            // infinite if no forces were found
  double charged() const noexcept;                          // share of the residual in the bound of the forces
  double residual() const noexcept { return residual_; }    // |r| of the best forces
  double width() const noexcept;                            // relative
  const Vector6& twist() const noexcept { return twist_; }  // that bounds best
  std::span<const PartForce> forces() const noexcept { return forces_; }  // that bound best

 private:
  bool maximises() const noexcept { return problem_.objective == Objective::load_factor; }

  GripProblem problem_{};
  double lower_ = 0, upper_ = 0;  // upper_ without the charge
  double residual_ = 0;
  double steepest_ = 0;  // max |W| / sum c_i rho_i+
  Vector6 twist_ = Vector6::Zero();
  std::vector<PartForce> forces_, trial_;
  std::vector<double> most_;  // rho+ or force by contact
  double total_ = 0;          // of the best forces
};

}  // namespace patchgrip::grasp
