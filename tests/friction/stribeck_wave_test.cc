#include <patchgrip/friction/kernels/stribeck_wave.h>

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction::kernels {
namespace {

using patchgrip::testing::Exact;
using std::numbers::pi;

TEST(StribeckWave, IsItsDefinitionTo4Units) {
  const StribeckWave& g = StribeckWave::shared();
  for (double t = 1e-3; t < 60; t *= 1.013) {
    const auto exact = stribeck_wave_by_definition<Exact>(t);
    EXPECT_LE(static_cast<double>(abs(g(t) - exact)), 4 * 0x1p-53 * pi / 2) << t;
    EXPECT_EQ(g(-t), -g(t));
  }
}

TEST(StribeckWave, JumpsAtZeroAndFadesWithTheCube) {
  const StribeckWave& g = StribeckWave::shared();
  EXPECT_EQ(g(0), 0);
  EXPECT_NEAR(g(1e-300), pi / 2, 4e-16);
  EXPECT_NEAR(g(1e6) * 1e18, -std::sqrt(pi) / 4, 1e-11);
}

// What it is for: exp(-u^2) u / |u| is its mean over all directions.
TEST(StribeckWave, ItsMeanOverAllDirectionsIsTheExcessAtAPoint) {
  const StribeckWave& g = StribeckWave::shared();
  for (const double u : {0.1, 1.0, 3.0}) {
    double sum = 0;
    constexpr int n = 4000;  // midpoints of a quarter: smooth and even at both its ends but for the jump of g at pi / 2
    for (int i = 0; i < n; ++i) {
      const double phi = pi / 2 * (i + 0.5) / n;
      sum += std::cos(phi) * g(u * std::cos(phi)) / n;
    }
    EXPECT_NEAR(sum, std::exp(-u * u), 1e-6) << u;
  }
}

}  // namespace
}  // namespace patchgrip::friction::kernels
