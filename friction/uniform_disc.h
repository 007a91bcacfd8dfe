// Friction of a uniform disc.
//
//     p = F_N / (pi a^2)
//
// With x = r_M / a, u = 1/x and the complete elliptic integrals K, E of the modulus given, per mu F_N:
//     x <= 1:  f = 4/(3 pi x) [(1 + x^2) E(x) - (1 - x^2) K(x)],  m / a = 4/(9 pi) [(4 - 2 x^2) E(x) - (1 - x^2) K(x)]
//     x >= 1:  f = 4/(3 pi) [(1 + x^2) E(u) - (x^2 - 1) K(u)],    m / a = (u/4) 2F1(1/2, 1/2; 3; u^2)
//
// (4.54 with constant p; f at the rim is 8/(3 pi), its slope 4/(3 pi).) In double the brackets cancel near the centre
// and far away; the patch is the member n = 1/2 of the power family and evaluated from its table
// (kernels/round_table.h).
//
// Domain   every pole, also on the rim and at infinity.
// Units    a [m].
// Error    <= 8 units of 2^-53 of force and of moment (round_patch.h).
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <patchgrip/friction/kernels/table_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class UniformDisc : public RoundPatch<kernels::TableKernel> {
 public:
  static UniformDisc of_radius(double radius);

 private:
  using RoundPatch::RoundPatch;
};

}  // namespace patchgrip::friction
