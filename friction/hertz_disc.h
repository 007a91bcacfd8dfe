// Friction of a Hertz disc: the circle of contact of two elastic spheres.
//
//     p = 3 F_N / (2 pi a^2) sqrt(1 - r^2 / a^2)                                        (seed 4.29, 4.2.5)
//
// With x = r_M / a, u = 1/x, per mu F_N:
//     x <= 1:  f = (3 pi/8)(x - x^3/4),           m / a = (3 pi/16)(1 - x^2 + 3 x^4/8)
//     x >= 1:  f = 2F1(-1/2, 1/2; 5/2; u^2),      m / a = (u/5) 2F1(1/2, 1/2; 7/2; u^2)
//
// The inner moment is the seed's; its other three expressions are fits (seed_hertz_disc.h). m is 9 pi/128 a at the rim
// and falls to a u/5 far away.
//
// Domain   every pole, also on the rim and at infinity.
// Units    a [m].
// Error    <= 8 units of 2^-53 of force and of moment (round_patch.h).
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <patchgrip/friction/kernels/moebius_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class HertzDisc : public RoundPatch<kernels::MoebiusKernel<kernels::HertzCoefficients>> {
 public:
  static HertzDisc of_radius(double radius);

 private:
  using RoundPatch::RoundPatch;
};

}  // namespace patchgrip::friction
