// Friction of a Hertz ellipse: the zone of contact of two elastic bodies of any curvature, its axes along x and y.
//
//     p = 3 F_N / (2 pi a b) sqrt(1 - x^2/a^2 - y^2/b^2)
//
// In units of the major semi-axis, x along it, with the integrals u, m, h of kernels/ellipse_integrals.h at the
// confocal ellipse lambda through the pole M = (x, y),
//
//     x^2/alpha + y^2/beta = 1,   alpha = 1 + lambda,   beta = b^2 + lambda,   kappa = x^2/alpha,   sigma = y^2/beta,
//
//     S_x = x alpha^(-1/2) [kappa u_major + sigma u_mixed]
//     S_y = y beta^(-1/2)  [kappa u_mixed (beta/alpha)^(1/2) + sigma u_minor]
//     T   = S - x S_x - y S_y = alpha^(-1/2) [m_pure (b^2 kappa^2 + sigma^2) + m_mixed kappa sigma]
//
//     S_xx = alpha^(-1/2) [b^2 kappa h_pure/alpha + sigma u_mixed],   S_xy = -x y alpha^(-3/2) h_cross,
//     S_yy = alpha^(-1/2) [sigma h_pure/alpha + kappa u_mixed]
//
// Every term of force, moment and dissipation is positive: they keep their digits at every pole, also where the moment
// along a slender ellipse is small of second order. A pole inside has lambda = 0, kappa + sigma < 1 and more terms, all
// of them constants of the ellipse: S is a polynomial there. It is (4.47) for this pressure, as integrals over confocal
// ellipses (Chandrasekhar, Ellipsoidal Figures of Equilibrium, ch. 3) taken by parts; a = b is the Hertz disc.
//
// A patch is two numbers and a table of its shape that copies share. Making the table takes about a millisecond, and
// the longer the more slender the ellipse.
//
// Domain   every pole, also on the rim and at infinity; aspect ratio up to 1e6.
// Units    a, b [m].
// Error    bounded: 12 units of 2^-53 of the force, 20 of the moment, everywhere; Hessian 1e-14 of its largest entry.
//          Measured: tests/friction/hertz_ellipse_test.cc, and `bounds --cases 100000 --kind hertz_ellipse`.
// Fails    results below 1e-290 of their scale are not relatively exact.
// Throws   std::invalid_argument unless both semi-axes are positive, finite and of a ratio within [1e-6, 1e6].
#pragma once

#include <memory>
#include <utility>

#include <patchgrip/friction/patch.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

class HertzEllipse {
 public:
  static constexpr double largest_aspect = 1e6;

  // a along x, b along y; either may be the larger.
  static HertzEllipse of_semi_axes(double a, double b);

  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const;  // throws std::domain_error at rest
  PressureMoments moments() const noexcept;
  double area_radius() const noexcept;

  double a() const noexcept { return a_; }
  double b() const noexcept { return b_; }

 private:
  struct Data;
  HertzEllipse(double a, double b, std::shared_ptr<const Data> data) : a_(a), b_(b), data_(std::move(data)) {}

  [[gnu::noinline]] Wrench rescaled_gradient(const Twist& v) const noexcept;

  double a_, b_;  // [m]
  std::shared_ptr<const Data> data_;
};

}  // namespace patchgrip::friction
