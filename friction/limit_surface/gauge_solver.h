// Maximises t . v / D(v) for a patch that is known by D and its derivatives alone.
//
// About the centroid c of the pressure, with spins times its radius of gyration, the maximum of
//
//     phi(v) = t . v - D(v)^2 / 2,      max phi = g(t)^2 / 2
//
// is found by Newton's method, (D H + grad D grad D^T) dv = t - D grad D: a single step where B is an ellipsoid. As D
// is homogeneous each twist has a best length, D(v) = t . v / D(v); there t - D grad D is the residual r of the
// certificate (certificate.h).
//
// Start        With e the direction of the force, sigma_e the spread of the pressure along e, sigma_p across: far poles
//              lie at sigma_e^2 F / M (exactly, for small M), those of a line load of half-length h at the solution of
//              x / (1 - x^2) = h F / 2 M in units of h; their sum with h^2 = 3 sigma_p^2. Exact for M -> 0, and for
//              F -> 0 on a Hertz disc.
// Overshoot    A step is cut to where the tangents of D at its ends meet, next to the least of D however sharp that is;
//              where that is too far still, to the least of the cubic through both ends.
// Kinks        of D (point loads) are asked first whether the slip is theirs (point_slip.h); Newton's method that gets
//              stuck at one is started again away from it, while 0.4 of the evaluations last. The rest is left to
//              cutting_planes.h: slips between kinks close together, and kinks that a patch does not tell.
//
// Domain       every load, every patch that has a PressureFrame. On a ridge (gauge.h) the slip is one that serves.
// Units        as gauge.h.
// Error        the bracket: certificate.h, point_slip.h, cutting_planes.h.
// Cost         3.3 (disc) to 4.1 evaluations (rectangle, aspect 1000) in the mean, 8 in 99 %, at most 11 in 1e5 random
//              loads each; 15 for some with the pole on a line load. Between point loads about a radius apart 0.3 to
//              5.1 in the mean, at most 25 in 4e5 loads on each of eleven pressures; on a facet none. Of three feet two
//              of which are 1e-6 or 1e-8 apart 3 to 16 in the mean and up to max_evaluations: 0.8 % stall, with
//              brackets up to 2e-9 wide. Set-up with n point loads takes n evaluations of n terms each: 2 to 3 s for
//              n = 4000.
// Throws       nothing.
#pragma once

#include <patchgrip/friction/limit_surface/gauge.h>
#include <patchgrip/friction/limit_surface/pressure_frame.h>

namespace patchgrip::friction {

Gauge maximise(const PatchView& patch, const PressureFrame& frame, const Wrench& load,
               const GaugeSettings& settings) noexcept;

}  // namespace patchgrip::friction
