#include <patchgrip/contact/half_space/solver_kernels.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace patchgrip::contact::kernels {
namespace {

// Around whole vectors and rows of them, the least at any place.
TEST(SolverKernels, LeastIsTheLeast) {
  std::mt19937_64 engine(20061207);
  std::normal_distribution<double> normal;
  for (std::size_t n = 1; n < 150; ++n) {
    std::vector<double> x(n);
    std::ranges::generate(x, [&] { return normal(engine); });
    EXPECT_EQ(least(n, x.data()), *std::ranges::min_element(x)) << n;
    for (std::size_t k = 0; k < n; ++k) {
      const double kept = x[k];
      x[k] = -100;
      ASSERT_EQ(least(n, x.data()), -100) << k << " of " << n;
      x[k] = kept;
    }
  }
  EXPECT_EQ(least(0, nullptr), std::numeric_limits<double>::infinity());
}

TEST(SolverKernels, OneOutsideIsFound) {
  constexpr double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t n = 1; n < 80; ++n) {
    std::vector<double> x(n, -2);
    EXPECT_TRUE(within(n, 2, x.data()));
    for (std::size_t k = 0; k < n; ++k) {
      for (const double wrong : {2.1, -2.1, infinite, -infinite, none}) {
        x[k] = wrong;
        ASSERT_FALSE(within(n, 2, x.data())) << wrong << " at " << k << " of " << n;
      }
      x[k] = 2;
    }
    EXPECT_TRUE(within(n, 2, x.data()));
  }
}

}  // namespace
}  // namespace patchgrip::contact::kernels
