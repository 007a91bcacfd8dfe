// How far the slip of a gauge is from the one that the load starts.
//
//     smooth        the slip v is where D has its least value in the plane t . v = g. One Newton step there for what is
//                   left of the residual t / g - grad D, twice, and another for what grad D is uncertain by.
//     point load    with the pole on it or next to it (point_slip.h) D bends too sharply for that, but not the rest
//                   R of it: the force asked of the point, a = F / g - F_R, tells the direction of its velocity z,
//                   and | |a| - w | over the stiffness of R along a tells its length. On a facet, |a| < w whatever
//                   rounding does, the pole is the point, and its error is 0.
//     ridge         nothing tells one slip from others: the errors are infinite. Gauge and bracket stand, and a slip
//                   whose pole lies on the line.
//
// Gradient and Hessian are known about the origin. Taken to the centroid, at a distance s, from where the radius of
// gyration is k, what they round becomes 1 + s / k times as large, and its square.
//
// Domain   loads of a gauge that neither under- nor overflows, subnormals included; else, and for no load, infinite.
// Units    twist as gauge.h, D(v) = 1 m/s; shape_error [1]: points of the pressure may lie that much of their distance
//          from the centroid elsewhere.
// Error    an estimate: first order in what is left. Against 50 digits:
//          tests/friction/limit_surface/{point_loads,slip_error}_test.cc.
// Throws   nothing.
#pragma once

#include <patchgrip/friction/limit_surface/gauge.h>
#include <patchgrip/friction/limit_surface/pressure_frame.h>

namespace patchgrip::friction {

struct SlipError {
  double speed = 0;       // of (vx, vy), length of the difference [m/s]; infinite where it is not determined
  double spin = 0;        // [rad/s]
  Pole pole;              // [m]
  double pole_error = 0;  // distance [m]; infinite also where the spin is 0 within its error
};

SlipError slip_error(const Gauge& gauge, const Wrench& load, const PatchView& patch, const PressureFrame& frame,
                     double shape_error = 0) noexcept;

}  // namespace patchgrip::friction
