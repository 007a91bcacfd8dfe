// Soft fingertip on a Winkler bed: a half ball of independent springs pressed by a flat, which may be inclined.
//
// The flat lies h = R - delta from the centre of the ball, inclined by theta_0 against the base that carries the
// springs. With g the part of its length that a spring keeps, and 1 - g its strain (seed 4.3.2; c a modulus, [Pa], not
// a bedding):
//
//     g(x, y) = (h - x sin theta_0) / (cos theta_0 sqrt(R^2 - x^2 - y^2)),   p = c (1 - g) g
//
// The zone is the circle of radius a = sqrt(delta (2R - delta)) in the flat: an ellipse in x, y. Upright, y = delta/h:
//
//     F = 2 pi c h^2 [y - ln(1 + y)],   p(0) = c delta (R - delta) / R^2,   F ~ pi c delta^2: gamma = 1/4
//
// Inclined, the integral across the zone is closed, and what is left is smooth and periodic in psi:
//
//     F = 2 c int_{-pi/2}^{pi/2} G phi(Y / sqrt(G^2 + Y^2)) a cos theta_0 cos psi dpsi
//     G = h cos theta_0 - a sin theta_0 sin psi,  Y = a cos psi,  phi(v) = arcsin v - sqrt(1 - v^2) artanh v
//
// Domain   0 < delta < R; 0 <= theta_0 and the rim above the base: theta_0 + arccos(h/R) < pi/2.
// Units    R, delta, a, x, y [m], c, p [Pa], F [N], theta_0 [rad].
// Error    upright: a, p(0), F <= 1.1 units of 2^-53, relative, for every delta. Inclined: F by the trapezoidal rule,
//          with force_error as its bound; tests/contact/winkler_test.cc.
// Fails    as mechanics of a contact: a^2 = 2 R delta where an elastic body has R delta (Johnson 4.3). For theta_0 > 0
//          the seed's geometry is evaluated; nothing independent supports it.
// Throws   std::invalid_argument, naming the parameter, outside the domain; std::runtime_error should the integral not
//          converge.
#pragma once

namespace patchgrip::contact {

struct WinklerFingertip {
  static WinklerFingertip of(double tip_radius, double spring_modulus);

  double contact_radius(double approach) const;
  double peak_pressure(double approach) const;  // upright
  double normal_force(double approach) const;   // upright

  struct InclinedForce {
    double normal_force;  // F [N]
    double force_error;   // bound [N]
  };
  InclinedForce inclined_force(double approach, double inclination) const;
  double inclined_pressure(double approach, double inclination, double x, double y) const;  // 0 outside the zone

  double tip_radius;      // R [m]
  double spring_modulus;  // c [Pa]
};

}  // namespace patchgrip::contact
