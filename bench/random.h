// Random inputs of benchmarks, the same in every run.
#pragma once

#include <cmath>
#include <random>

namespace patchgrip::bench {

inline double uniform(std::mt19937_64& engine, double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(engine);
}

// lo and hi > 0; every decade alike.
inline double log_uniform(std::mt19937_64& engine, double lo, double hi) {
  return std::exp(uniform(engine, std::log(lo), std::log(hi)));
}

}  // namespace patchgrip::bench
