#include <patchgrip/contact/half_space/grid.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::contact {
namespace {

TEST(Grid, IsCentredOnTheOrigin) {
  const Grid grid = Grid::of_cells(10, 9, 0.5, 0.25);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(grid.x(i), -grid.x(9 - i));
  EXPECT_EQ(grid.y(4), 0);
  EXPECT_EQ(grid.x(9) - grid.x(0), 9 * 0.5);
  EXPECT_EQ(grid.size(), 90U);
  EXPECT_EQ(grid.index(3, 2), 23U);
}

TEST(Grid, SquareHasItsWidth) {
  const Grid grid = Grid::square(64, 2.5);
  EXPECT_EQ(grid.nx * grid.dx, 2.5);
  EXPECT_EQ(grid, Grid::of_cells(64, 64, 2.5 / 64, 2.5 / 64));
}

TEST(Grid, SamplesRunAlongXFirst) {
  const Grid grid = Grid::of_cells(8, 12, 1, 2);
  const auto values = sample(grid, [](double x, double y) { return x + 100 * y; });
  EXPECT_EQ(values[grid.index(5, 7)], grid.x(5) + 100 * grid.y(7));
}

TEST(Grid, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([] { Grid::of_cells(7, 8, 1, 1); }, refused("nx = 7 is not allowed: must lie in [8, 8192]"));
  EXPECT_THAT([] { Grid::of_cells(8, 8193, 1, 1); }, refused("ny = 8193 is not allowed: must lie in [8, 8192]"));
  EXPECT_THAT([] { Grid::of_cells(8, 8, 0, 1); }, refused("dx = 0 is not allowed: must lie in [1e-50, 1e+50]"));
  EXPECT_THAT([] { Grid::of_cells(8, 8, 1, std::nan("")); },
              refused("dy = nan is not allowed: must lie in [1e-50, 1e+50]"));
  EXPECT_THAT([] { Grid::of_cells(8, 8, 9, 1); }, refused("dx / dy = 9 is not allowed: must lie in [0.125, 8]"));
  EXPECT_THAT([] { Grid::of_cells(8192, 8192, 1, 1); },
              refused("nx ny = 67108864 is not allowed: must lie in [1, 16777216]"));
  EXPECT_THAT([] { Grid::square(4, 1); }, refused("cells = 4 is not allowed: must lie in [8, 8192]"));
  EXPECT_THAT([] { Grid::square(8, -1); }, refused("width = -1 is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
