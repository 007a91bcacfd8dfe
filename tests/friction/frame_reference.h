// Reference gradients of D in 50 digits moved, turned and added.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include <patchgrip/friction/placed.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

using Gradient50 = std::function<Wrench50(const Real50& vx, const Real50& vy, const Real50& w)>;

inline Gradient50 in_frame(Gradient50 gradient, const PlanarFrame& frame) {
  const Real50 c = cos(Real50(frame.angle)), s = sin(Real50(frame.angle));
  return [=, gradient = std::move(gradient)](const Real50& vx, const Real50& vy, const Real50& w) {
    const Real50 ux = vx - w * frame.y, uy = vy + w * frame.x;
    const Wrench50 g = gradient(c * ux + s * uy, c * uy - s * ux, w);
    const Real50 fx = c * g.fx - s * g.fy, fy = s * g.fx + c * g.fy;
    return Wrench50{fx, fy, g.m + frame.x * fy - frame.y * fx};
  };
}

struct Weighted50 {
  Gradient50 gradient;
  Real50 weight;
};

// The weights need not add up to 1.
inline Gradient50 weighted_mean(std::vector<Weighted50> parts) {
  return [parts = std::move(parts)](const Real50& vx, const Real50& vy, const Real50& w) {
    Wrench50 sum{0, 0, 0};
    Real50 weights = 0;
    for (const auto& [gradient, weight] : parts) {
      const Wrench50 g = gradient(vx, vy, w);
      sum = {sum.fx + weight * g.fx, sum.fy + weight * g.fy, sum.m + weight * g.m};
      weights += weight;
    }
    return Wrench50{sum.fx / weights, sum.fy / weights, sum.m / weights};
  };
}

// Of a point load at its own origin, the pole not on it.
inline Wrench50 point_gradient(const Real50& vx, const Real50& vy, const Real50&) {
  const Real50 speed = sqrt(vx * vx + vy * vy);
  return {vx / speed, vy / speed, 0};
}

}  // namespace patchgrip::friction
