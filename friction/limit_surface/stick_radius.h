// The stick radius: distance of the limit surface from the origin, in spherical coordinates.
//
//     t = mu F_N rho_H(phi, theta) (sin theta cos phi, sin theta sin phi, a_K cos theta)      (seed 4.51)
//
// holds just so, with a_K = sqrt(area / pi), phi = atan2(t_2, t_1) and theta in [0, pi] from the axis of moments. With
// the gauge of the direction, rho_H = 1 / g(sin theta cos phi, sin theta sin phi, a_K cos theta). A force through the
// centroid of the pressure has rho_H = 1; a pure moment about it min S / a_K.
//
// The seed's 2 arctan(t_2 / (t_1 + sqrt(t_1^2 + t_2^2))) is 0/0 for t_2 = 0, t_1 <= 0; and translation is theta = pi/2,
// not pi.
//
// Domain   every direction; patches with an area, as a_K scales the axis of moments.
// Units    angles [rad]; rho_H [1].
// Error    carried, from that of the gauge; not-a-number for angles that are not finite.
// Throws   std::invalid_argument unless area_radius() is positive.
#pragma once

#include <cmath>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>

namespace patchgrip::friction {

struct StickRadius {
  double value;
  double lower;
  double upper;
};

template <Patch P>
StickRadius stick_radius(const LimitSurface<P>& surface, double phi, double theta) {
  const double radius = contact::require_positive("area_radius", surface.patch().area_radius());
  const double s = std::sin(theta);
  const Gauge g = surface.gauge({s * std::cos(phi), s * std::sin(phi), radius * std::cos(theta)});
  // Each component of the direction is wrong by 2 units of rounding of itself at most.
  constexpr double rounding = 8 * 0x1p-53;
  return {1 / g.value, (1 - rounding) / g.upper, (1 + rounding) / g.lower};
}

}  // namespace patchgrip::friction
