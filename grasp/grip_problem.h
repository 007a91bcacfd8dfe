// The four conic problems of grasp analysis, in scaled numbers.
//
// With admissible x_i = (F_i, t_i), resistances rho_i(W) = n_i . w_i + mu_i D_i and rho+ = max(0, rho):
//
//     max_force     min s:  F_i <= c_i s                                 max w . W :  sum c_i rho_i+ <= 1
//     total_force   min sum F_i                                          max w . W :  max rho_i <= 1
//     load_factor   max lambda:  carry w + lambda w_1,  F_i <= c_i       min sum c_i rho_i+ - w . W :  w_1 . W = 1
//     distance      min |w + sum G_i x_i|  in  |f|^2 + k^2 |m|^2         max w . W :  rho_i <= 0,  |W_v|^2 + |W_w|^2/k^2 <= 1
//
// Weak duality is one line, 0 = (w + sum G_i x_i) . W >= w . W - sum F_i rho_i(W): any W and any admissible x bound the
// optimum from either side.
//
// Units    scaled_grasp.h; the load is near 1 in size (load_factor: the step is), the largest limit 1 for max_force.
#pragma once

#include <span>

#include <patchgrip/grasp/scaled_grasp.h>

namespace patchgrip::grasp {

enum class Objective { max_force, total_force, load_factor, distance };

struct GripProblem {
  const ScaledGrasp* grasp;
  Objective objective;
  Vector6 load;
  Vector6 step = Vector6::Zero();       // w_1 of load_factor
  std::span<const double> limits = {};  // c_i of max_force and load_factor, one a contact, > 0
  double metric = 1;                    // k of distance

  bool limited() const noexcept { return objective == Objective::max_force || objective == Objective::load_factor; }
};

}  // namespace patchgrip::grasp
