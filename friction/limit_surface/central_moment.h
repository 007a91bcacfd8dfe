// The moment that a patch resists a spin about its centre of pressure with: the size of its limit surface in moments.
//
//     S(c) = m - (x f_y - y f_x),      f, m the gradient of D for a unit spin about c = (x, y)
//
// Units    [m], per mu F_N.
// Error    the gradient's, its force times the arm; the products and the sum are rounded.
// Throws   std::invalid_argument, naming the moment and the centre, unless it exceeds that error: all pressure in one
//          point, or so far from the origin that it is one as seen from there.
#pragma once

#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

struct CentralMoment {
  // `spinning` is bounded_gradient() of the unit spin about (x, y).
  CentralMoment(const BoundedWrench& spinning, double x, double y);

  double value;
  double error;
};

}  // namespace patchgrip::friction
