// Random loads on a patch: a third of them nearly a pure force, a third nearly a pure moment about its centroid.
#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include <patchgrip/friction/patch.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {

inline Wrench draw_load(std::mt19937_64& engine, const PressureMoments& s) {
  using ::patchgrip::testing::log_uniform;
  using ::patchgrip::testing::uniform;
  const double kind = uniform(engine, 0, 3);
  const double small = log_uniform(engine, 1e-9, 1);
  const double angle = kind < 1   ? uniform(engine, 0, 1) * std::numbers::pi / 2
                       : kind < 2 ? small
                                  : std::numbers::pi / 2 - small;
  const double size = log_uniform(engine, 1e-3, 1e3);
  const double direction = uniform(engine, -std::numbers::pi, std::numbers::pi);
  const double F = size * std::cos(angle);
  const double M = (uniform(engine, -1, 1) < 0 ? -1 : 1) * size * std::sin(angle) * std::sqrt(s.polar);
  const double fx = F * std::cos(direction), fy = F * std::sin(direction);
  return {fx, fy, M + (s.x * fy - s.y * fx)};
}

}  // namespace patchgrip::friction
