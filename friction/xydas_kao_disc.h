// Friction of a soft fingertip with the pressure of Xydas and Kao.
//
//     p = C F_N / (pi a^2) (1 - (r/a)^alpha)^(1/alpha)                            (seed 4.68)
//     C = 3 alpha Gamma(3/alpha) / (2 Gamma(1/alpha) Gamma(2/alpha))
//
// (Xydas, Kao, Int. J. Robotics Research 18, 1999.) alpha = 2 is the Hertz disc, large alpha tends to the uniform one.
// Level sets of p are discs, so every function of the patch is an average over uniform discs of radius R(q):
//
//     S(x) = int_0^1 R^3 S_uniform(x / R) dq / int_0^1 R^2 dq,   R(q) = (1 - q^alpha)^(1/alpha)
//
// It is integrated once, in the factory (some 0.1 s), into the table that evaluates it (kernels/round_table.h); copies
// share it.
//
// Domain   every pole; 0.5 <= alpha <= 50.
// Units    a [m], alpha [1].
// Error    <= 8 units of 2^-53 of force and of moment (round_patch.h).
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <patchgrip/friction/kernels/table_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class XydasKaoDisc : public RoundPatch<kernels::TableKernel> {
 public:
  static XydasKaoDisc of_radius(double radius, double alpha);

  double alpha() const noexcept { return alpha_; }

 private:
  XydasKaoDisc(double radius, double alpha, double polar, kernels::TableKernel kernel)
      : RoundPatch(radius, polar, std::move(kernel)), alpha_(alpha) {}

  double alpha_;
};

}  // namespace patchgrip::friction
