// What a single gradient of D says of a gauge: a bracket, with every rounding in it.
//
//     t . v / D(v)  <=  g(t)  <=  k + |r_F| + |r_M| / min S,      r = t - k grad D(v),   k = t . v / D(v)
//
// r_M is taken about the centroid, where B contains every unit force and the pure moment min S (pressure_frame.h).
//
// Units    load and bracket [N], [N m].
#pragma once

#include <limits>

#include <patchgrip/friction/limit_surface/pressure_frame.h>

namespace patchgrip::friction {

struct Bracket {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  double gap = std::numeric_limits<double>::infinity();  // |r_F| + |r_M| / min S
  double rounding = 0;                                   // what it is uncertain by

  // As narrow as asked for, or all that is left is rounding.
  bool narrow(double relative_gap) const noexcept;
};

// `g` is bounded_gradient(v), about the origin as v is.
Bracket certify(const PressureFrame& frame, const Wrench& load, const Twist& v, const BoundedWrench& g) noexcept;

}  // namespace patchgrip::friction
