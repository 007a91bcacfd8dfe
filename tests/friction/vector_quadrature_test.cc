#include <patchgrip/friction/kernels/vector_quadrature.h>

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace patchgrip::friction::kernels {
namespace {

template <std::size_t N>
void expect_within_error(const BoundedIntegrals<N>& found, const std::array<double, N>& exact, double of_use) {
  for (std::size_t i = 0; i < N; ++i) {
    EXPECT_LE(std::fabs(found.value[i] - exact[i]), found.error[i]) << i;
    EXPECT_LE(found.error[i], of_use) << i;
  }
}

TEST(VectorQuadrature, IntegratesSmoothFunctionsToRounding) {
  const auto f = [](double x, double) { return std::array{std::exp(x), std::cos(x), 1.0}; };
  expect_within_error<3>(integrate<3>(f, 0, 1), {std::expm1(1.0), std::sin(1.0), 1}, 4e-15);
}

TEST(VectorQuadrature, KnowsTheDistanceFromBothEnds) {
  const auto f = [](double from_lo, double to_hi) { return std::array{1 / std::sqrt(from_lo), 1 / std::sqrt(to_hi)}; };
  expect_within_error<2>(integrate<2>(f, 3, 7), {4, 4}, 1e-14);
}

// A peak far narrower than the interval, at an end.
TEST(VectorQuadrature, FindsANarrowPeakAtAnEnd) {
  for (const double width : {1e-3, 1e-6, 1e-9}) {
    const auto f = [width](double, double to_hi) {
      return std::array{std::exp(-to_hi / width) / width, width / (to_hi * to_hi + width * width)};
    };
    expect_within_error<2>(integrate<2>(f, 0, 1), {1, std::atan(1 / width)}, 1e-13);
  }
}

// A jump inside breaks the domain: the error says so.
TEST(VectorQuadrature, AJumpInsideCostsDigitsAndTheErrorSaysSo) {
  const auto f = [](double x, double) { return std::array{x < 0.3 ? 1.0 : 0.0}; };
  const auto found = integrate<1>(f, 0, 1);
  EXPECT_GT(std::fabs(found.value[0] - 0.3), 1e-8);
  EXPECT_LE(std::fabs(found.value[0] - 0.3), found.error[0]);
}

TEST(VectorQuadrature, AnEmptyIntervalGivesNothing) {
  const auto f = [](double, double) { return std::array{1.0}; };
  EXPECT_EQ(integrate<1>(f, 2, 2).value[0], 0);
  EXPECT_EQ(integrate<1>(f, 2, 2).error[0], 0);
}

}  // namespace
}  // namespace patchgrip::friction::kernels
