// Random motions for Stribeck's law at each point, in units of the Stribeck velocity.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include <patchgrip/friction/twist.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {

// Poles inside, next to the rim, outside, far and at infinity, about an ellipse; speeds from slow to fast.
inline Twist random_twist(std::mt19937_64& engine, double a, double b) {
  using testing::log_uniform;
  using testing::uniform;
  constexpr double pi = std::numbers::pi;
  const double phi = uniform(engine, -pi, pi), c = a * std::cos(phi), s = b * std::sin(phi);
  const double spin = (uniform(engine, 0, 1) < 0.5 ? 1 : -1) * log_uniform(engine, 1e-2, 30) / std::hypot(a, b);
  switch (std::uniform_int_distribution<int>(0, 5)(engine)) {
    case 0:
      return {spin * c, spin * s, 0};
    case 1: {
      const double x = 1 + (spin > 0 ? 1 : -1) * log_uniform(engine, 1e-16, 0.1);
      return twist_about({x * c, x * s}, spin);
    }
    case 2: {
      const double x = log_uniform(engine, 1, 1e4);
      return twist_about({x * c, x * s}, spin / x);
    }
    default: {
      const double x = uniform(engine, 0, 2);
      return twist_about({x * c, x * s}, spin);
    }
  }
}

}  // namespace patchgrip::friction
