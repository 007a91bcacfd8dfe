// Friction of a flat-punch disc: a rigid flat cylinder pressed on an elastic half-space.
//
//     p = F_N / (2 pi a^2) / sqrt(1 - r^2 / a^2)                         (Johnson, Contact Mechanics, 3.34)
//
// With x = r_M / a, u = 1/x, per mu F_N:
//     x <= 1:  f = pi x / 4,                      m / a = (pi/4)(1 - x^2/2)
//     x >= 1:  f = 2F1(-1/2, 1/2; 3/2; u^2),      m / a = (u/3) 2F1(1/2, 1/2; 5/2; u^2)
//
// Domain   every pole, also on the rim and at infinity.
// Units    a [m].
// Error    <= 8 units of 2^-53 of force and of moment (round_patch.h).
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <patchgrip/friction/kernels/moebius_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class FlatPunchDisc : public RoundPatch<kernels::MoebiusKernel<kernels::FlatPunchCoefficients>> {
 public:
  static FlatPunchDisc of_radius(double radius);

 private:
  using RoundPatch::RoundPatch;
};

}  // namespace patchgrip::friction
