// Friction of a disc with a power-law pressure.
//
//     p = (n + 1/2) F_N / (pi a^2) (1 - r^2 / a^2)^(n - 1/2)                            (seed 4.13: rotational family)
//
// With x = r_M / a, u = 1/x, z = x^2 or u^2, c = n + 3/2, B = Beta(1/2, n + 1), per mu F_N:
//     x <= 1:  f = (pi x / 2B) 2F1(-n, 1/2; 2; z),      m / a = (pi / (2 (n+1) B)) 2F1(-n-1, 1/2; 1; z)
//     x >= 1:  f = 2F1(-1/2, 1/2; c; z),                m / a = (u / 2c) 2F1(1/2, 1/2; c + 1; z)
//
// n = 0 is the flat punch, 1/2 the uniform disc, 1 the Hertz disc; n -> -1/2 the ring. The table that evaluates them
// (kernels/round_table.h) is made in the factory, in about a millisecond; copies share it.
//
// Domain   every pole; -1/2 < n <= 20, what the rows of the table resolve.
// Units    a [m], n [1].
// Error    <= 8 units of 2^-53 of force and of moment (round_patch.h).
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <patchgrip/friction/kernels/table_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class PowerDisc : public RoundPatch<kernels::TableKernel> {
 public:
  static PowerDisc of_radius(double radius, double exponent);

  double exponent() const noexcept { return exponent_; }  // n

 private:
  PowerDisc(double radius, double exponent, kernels::TableKernel kernel)
      : RoundPatch(radius, 1 / (exponent + 1.5), std::move(kernel)), exponent_(exponent) {}

  double exponent_;
};

}  // namespace patchgrip::friction
