// The power family in 50 digits, at the very twist that the double code is given: reference of the round patches.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/friction/kernels/round_functions.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction {

using Real50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

struct Wrench50 {
  Real50 fx, fy, m;
};

// `source` has inside(d) and outside(d) as in kernels/round_functions.h, in any precision.
template <class Source>
Wrench50 round_wrench(const Source& source, double radius, const Real50& vx, const Real50& vy, const Real50& w) {
  using Real = decltype(source.inside(1).force);
  const Real50 V = sqrt(vx * vx + vy * vy);
  const Real50 W = radius * abs(w);
  const int sign = w < 0 ? -1 : 1;
  if (V <= W) {
    const auto g = source.inside(static_cast<Real>((W - V) / W));
    return {Real50(g.force) * vx / W, Real50(g.force) * vy / W, sign * Real50(g.moment) * radius};
  }
  const auto g = source.outside(static_cast<Real>((V - W) / V));
  return {Real50(g.force) * vx / V, Real50(g.force) * vy / V, sign * Real50(g.moment) * radius * W / V};
}

template <class Source>
Wrench50 round_wrench(const Source& source, double radius, const Twist& v) {
  return round_wrench(source, radius, Real50(v.vx), Real50(v.vy), Real50(v.w));
}

}  // namespace patchgrip::friction
