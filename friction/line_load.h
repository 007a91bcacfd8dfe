// Friction of a uniform load on a straight line of length L, along x and centred at the origin of its own frame
// (placed.h moves it): the blade of a skate, an edge, the contact of a cylinder that is short of width.
//
//     p = F_N / L  per unit length
//
// With Q the sum of the speeds of both ends, l = |w| L, x = l / Q and the functions of kernels/line_motion.h, the force
// along and across the line and the moment about its centre are
//
//     fx = vx lambda,    lambda = log1p(2 l / (Q - l)) / l = 2 A / Q
//     fy = 2 vy / Q = nu
//     m  = sgn(w) (L / 4) x eta^2 gamma
//
// ((4.45) and (4.47) for this pressure, integrated by hand), and the Hessian of D
//
//     H_xx = (2 / Q) [x^2 alpha + nu^2 c^2 / e],   H_xy = -(4 vx / Q^2) nu / e,   H_yy = (2 / Q) eta^2 / e
//     H_xw = -(2 vx w L^2 / Q^3) [alpha - nu^2 / e],   H_yw = -(w L^2 / Q^2) nu eta^2 / e
//     H_ww = (L^2 / 2 Q) eta^2 [c^2 alpha + x^2 nu^2 / e],   e = 1 - x^2 nu^2
//
// D, force, moment and the diagonal of H are sums of positive terms: they keep their digits at every pole, next to the
// line, at its ends, far away and at infinity.
//
// D has one gradient in every motion, also with the pole on the line: its limit surface has no facet. But all poles on
// the line beyond its ends share the force (0, 1) or (0, -1), the points of the line sliding one way across it: two
// corners, where many slips serve one load (GaugeStatus::ridge).
//
// Domain   every pole. Without area: area_radius() = 0.
// Units    length [m].
// Error    bounded: 12 units of 2^-53 of the force, 16 of the moment, everywhere; Hessian 1e-14 of its largest entry.
//          Measured: tests/friction/line_load_test.cc, and `bounds --cases 100000 --kind line_load`.
// Fails    the Hessian is infinite with the pole on the line: hessian() throws std::domain_error there.
// Throws   std::invalid_argument unless the length is positive and finite.
#pragma once

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

class LineLoad {
 public:
  static LineLoad of_length(double length);

  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const;
  PressureMoments moments() const noexcept { return {0, 0, length_ * length_ / 12}; }
  double area_radius() const noexcept { return 0; }

  double length() const noexcept { return length_; }

 private:
  explicit LineLoad(double length) : length_(length) {}

  double length_;  // L [m]
};

}  // namespace patchgrip::friction
