// Friction of a patch in the mean (law.h) in 50 digits, from its gradient and its moments.
#pragma once

#include <patchgrip/tests/friction/bounds/draw.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction::bounds {

struct Moments50 {
  Real50 x, y, polar;
};

inline Wrench50 exact_friction(const DrawnLaw& drawn, const Moments50& s, const Wrench50& g, const Twist& v) {
  const Law& law = drawn.law;
  const Real50 cx = v.vx - v.w * s.y;
  const Real50 cy = v.vy + v.w * s.x;
  const Real50 speed2 = cx * cx + cy * cy + Real50(v.w) * v.w * s.polar;
  const Real50 excess = Real50(law.mu_static) - law.mu_kinetic;
  const Real50 mu = law.mu_kinetic + excess * exp(-speed2 / (Real50(law.stribeck_velocity) * law.stribeck_velocity));
  const Real50 F = drawn.normal_force;
  const Real50 s1 = s.x * s.x + s.y * s.y + s.polar;
  const Real50 wet = F * law.mu_viscous;
  return {-F * mu * g.fx - wet * cx, -F * mu * g.fy - wet * cy,
          -F * mu * g.m - wet * (s.x * v.vy - s.y * v.vx + v.w * s1)};
}

}  // namespace patchgrip::friction::bounds
