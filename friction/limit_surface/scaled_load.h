// A load brought near 1 by a power of two, and its gauge brought back: g(2^-e t) = 2^-e g(t), its twist the same.
//
// Powers of the components then neither over- nor underflow, nor does the moment about another point.
//
// Domain   loads that are finite and not zero (trivial_gauge() answers the others).
// Units    load [N], [N], [N m]; length [m], any that makes moments comparable with forces; gauge [N].
// Error    none: components are scaled to the last bit as far as they count beside the largest. Where the gauge itself
//          is subnormal or overflows its bracket is rounded outwards.
#pragma once

#include <cmath>
#include <limits>

#include <patchgrip/friction/limit_surface/gauge.h>

namespace patchgrip::friction {

struct ScaledLoad {
  ScaledLoad(const Wrench& t, double length) noexcept
      : exponent(load_exponent(t, length)),
        load{std::scalbn(t.fx, -exponent), std::scalbn(t.fy, -exponent), std::scalbn(t.m, -exponent)} {}

  double back(double gauge) const noexcept { return std::scalbn(gauge, exponent); }

  Gauge back(Gauge g) const noexcept {
    using Limits = std::numeric_limits<double>;
    g.value = back(g.value);
    g.lower = std::fmin(back(g.lower), Limits::max());
    g.upper = back(g.upper);
    if (g.lower < Limits::min()) g.lower = std::nextafter(g.lower, 0);
    if (g.upper < Limits::min()) g.upper = std::nextafter(g.upper, Limits::infinity());
    return g;
  }

  int exponent;
  Wrench load;  // t / 2^exponent
};

}  // namespace patchgrip::friction
