// A homogeneous quartic of three variables, and the proof that it is convex.
//
//     q(t) = sum of c x^i y^j z^k,  i + j + k = 4,      grad q = H(t) t / 3,      q = t . H(t) t / 12
//
// The Hessian H is linear in the products t t^T, so it has a value H(s, t) for two arguments, and on the cone of t_i
//
//     H(sum of l_i t_i) = sum of l_i l_j H(t_i, t_j),   l_i >= 0:
//
// it is positive there if all H(t_i, t_j) are. Cones are halved until that holds or a corner shows the contrary. Every
// convex quartic form of three variables is sos-convex (Ahmadi and Parrilo 2013), so that a semidefinite programme
// could decide as well; this test needs none, but refuses forms that are convex by less than rounding.
//
// Domain   finite coefficients; t of a size whose fourth powers neither over- nor underflow.
// Units    any for t, q in their fourth power; frame of support_function.h where it stands for a limit surface.
// Error    q, grad and H(t, t) to 8 units of 2^-53 of the sum of their terms' sizes (quartic_gauge_test.cc).
// Throws   nothing.
#pragma once

#include <array>

#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

struct QuarticForm {
  // Of x^4, x^3 y, x^3 z, x^2 y^2, x^2 y z, x^2 z^2, x y^3, x y^2 z, x y z^2, x z^3, y^4, y^3 z, y^2 z^2, y z^3, z^4.
  using Coefficients = std::array<double, 15>;

  static Coefficients monomials(const Wrench& t) noexcept;

  double operator()(const Wrench& t) const noexcept {
    const auto [x, y, z] = t;
    const double z0 = x * (x * (x * (c[0] * x + c[1] * y) + c[3] * y * y) + c[6] * y * y * y) + c[10] * y * y * y * y;
    const double z1 = x * (x * (c[2] * x + c[4] * y) + c[7] * y * y) + c[11] * y * y * y;
    const double z2 = x * (c[5] * x + c[8] * y) + c[12] * y * y;
    const double z3 = c[9] * x + c[13] * y;
    return z0 + z * (z1 + z * (z2 + z * (z3 + z * c[14])));
  }

  Hessian hessian(const Wrench& s, const Wrench& t) const noexcept;
  Twist gradient(const Wrench& t) const noexcept;

  Coefficients c;
};

// True only if q is convex; false also where neither is shown within 1e5 cones, or a coefficient is not a number.
bool is_certainly_convex(const QuarticForm& q);

}  // namespace patchgrip::friction
