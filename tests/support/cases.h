// Random inputs of tests: how many, and how spread.
//
// ./check draws a subset; PATCHGRIP_TEST_SCALE=20 ctest ... draws twenty times as many, from the same seeds. The
// presets without optimisation draw a tenth.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace patchgrip::testing {

// `count` times the scale that the environment asks for (1 if it asks for nothing).
inline int cases(int count) {
  const char* scale = std::getenv("PATCHGRIP_TEST_SCALE");
  return scale == nullptr ? count : std::max(1, static_cast<int>(count * std::atof(scale)));
}

// False where the environment asks for fewer: rare events, extremes and medians need them all.
inline bool all_cases() { return cases(1000) >= 1000; }

inline double uniform(std::mt19937_64& engine, double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(engine);
}

// lo and hi > 0; every decade alike.
inline double log_uniform(std::mt19937_64& engine, double lo, double hi) {
  return lo * std::exp(uniform(engine, 0, std::log(hi / lo)));
}

}  // namespace patchgrip::testing
