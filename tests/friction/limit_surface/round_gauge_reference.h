// The gauge of the power family in 50 digits.
#pragma once

#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

class RoundGaugeReference {
 public:
  struct Result {
    Real50 value;
    Real50 x;  // pole distance per radius
  };

  explicit RoundGaugeReference(double n) : family_(n) {}

  // The root is sought as s = x / (1 + x).
  Result gauge(const Wrench& t, double radius) const {
    const Real50 F = sqrt(Real50(t.fx) * t.fx + Real50(t.fy) * t.fy);
    const Real50 M = abs(Real50(t.m)) / radius;
    const auto excess = [&](const Real50& s) -> Real50 {
      const auto [f, m] = at(s);
      return f * M - F * m;
    };
    std::uintmax_t steps = 200;
    const auto [low, high] = boost::math::tools::toms748_solve(excess, Real50(0), Real50(1),
                                                               boost::math::tools::eps_tolerance<Real50>(110), steps);
    const Real50 s = (low + high) / 2;
    const auto [f, m] = at(s);
    return {(F * s + M * (1 - s)) / (f * s + m * (1 - s)), s / (1 - s)};
  }

 private:
  struct Point {
    Real50 f, m;
  };

  Point at(const Real50& s) const {
    const Wrench50 g = round_wrench(family_, 1, s, 0, 1 - s);
    return {g.fx, g.m};
  }

  kernels::PowerFamily<Real50> family_;
};

}  // namespace patchgrip::friction
