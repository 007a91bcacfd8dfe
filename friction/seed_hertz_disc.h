// The seed's fits to the friction of a Hertz disc: the cheap model beside the exact one, with its proven error.
//
// With x = r_M / a, u = 1/x, per mu F_N (Keppler 2006, section 4.2.5):
//     x <= 1:  f = 1.178 x - 0.294 x^3,                  m / a = (3 pi/16)(1 - x^2 + 0.375 x^4)
//     x >= 1:  f = 1 - 0.096 u^2 - 0.020 u^4,            m / a = (3 pi/16)(0.335 u + 0.040 u^3)
//
// What they differ by from HertzDisc, found as the largest error over all poles and rounded up:
//
//     |f - f_exact|     <= 4.28e-4 (x <= 1),  4.72e-4 (x >= 1)
//     |m - m_exact| / a  = 0 (x <= 1),       <= 1.18e-3 (x >= 1)
//
// and |m - m_exact| <= 1.34e-2 of the exact moment far away, where the fit tends to (3 pi/16) 0.335 u instead of u/5. f
// and m were fitted apart, so f is not the slope of S: D and the wrench belong together to these errors only, and
// dissipation() is v . gradient(v).
//
// Domain   every pole.
// Units    a [m].
// Error    bounded_gradient() carries the bounds above; tests/friction/seed_hertz_disc_test.cc proves them against 50
//          digits.
// Throws   std::invalid_argument unless the radius is positive and finite.
#pragma once

#include <patchgrip/friction/kernels/seed_kernel.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

class SeedHertzDisc : public RoundPatch<kernels::SeedKernel> {
 public:
  static SeedHertzDisc of_radius(double radius);

  BoundedWrench bounded_gradient(const Twist& v) const noexcept;

 private:
  using RoundPatch::RoundPatch;
};

}  // namespace patchgrip::friction
