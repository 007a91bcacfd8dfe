// Pressing on E* = 1 Pa, and how far a result is from what it must satisfy.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/contact/half_space/press.h>
#include <patchgrip/tests/contact/half_space_shapes.h>

namespace patchgrip::contact {

inline PressSettings with_tolerance(double tolerance) {
  PressSettings settings;
  settings.tolerance = tolerance;
  return settings;
}

inline PressedHalfSpace press(const Grid& grid, const GapFunction& gap, const Press& press,
                              const PressSettings& settings = {}) {
  return press_half_space(grid, Surface::free, sample(grid, gap), 1, press, settings);
}

// The complementarity that the pressure must satisfy, from products of its own: p >= 0, u + f - delta >= 0, not both >
// 0.
inline double violation(const PressedHalfSpace& result, const std::vector<double>& gap) {
  const auto u = half_space_displacement(result.grid, result.surface, result.pressure, result.contact_modulus);
  double squares = 0, count = 0, overlap = 0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    EXPECT_GE(result.pressure[k], 0);
    const double g = u[k] + gap[k] - result.approach.value;
    if (result.pressure[k] > 0) squares += g * g, ++count;
    if (result.pressure[k] == 0) overlap = std::max(overlap, -g);
  }
  return std::max(std::sqrt(squares / count), overlap);
}

inline double relative(double value, double exact) { return std::abs(value / exact - 1); }

}  // namespace patchgrip::contact
