// Friction of a thin ring: the whole normal load on a circle of radius a.
//
// With x = r_M / a, k = 2 sqrt(x) / (1 + x) and the complete elliptic integrals of modulus k, per mu F_N:
//
//     f = [(x + 1) E + (x - 1) K] / (pi x),   m / a = [(1 + x) E + (1 - x) K] / pi
//
// f = m / a = 2/pi with the pole on the ring, where the slope of f is infinite (like -ln|x - 1| / pi). It is the member
// n = -1/2 of the power family and evaluated from its table (kernels/round_table.h). Its second derivative knows the
// rim to the exact value of V^2 - a^2 w^2.
//
// Domain   every pole, also on the ring and at infinity.
// Units    a [m].
// Error    <= 8 units of 2^-53 of force and of moment (round_patch.h).
// Throws   std::invalid_argument unless the radius is positive and finite.
// Fails    the Hessian is infinite with the pole on the ring: hessian() throws std::domain_error there.
//          Within 2^-62 radii of it, which only an inexact a |w| can reach, it is good to 1e-4.
#pragma once

#include <patchgrip/friction/kernels/table_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class Ring : public RoundPatch<kernels::TableKernel> {
 public:
  static Ring of_radius(double radius);

 private:
  using RoundPatch::RoundPatch;
};

}  // namespace patchgrip::friction
