#include <patchgrip/contact/half_space/stiffness.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/contact/half_space_shapes.h>

namespace patchgrip::contact {
namespace {

PressedHalfSpace press(const Grid& grid, const GapFunction& gap, const Press& press) {
  return press_half_space(grid, Surface::free, sample(grid, gap), 1, press);
}

TEST(ContactStiffness, OfACircleIsTwiceItsRadius) {
  for (const int cells : {64, 128, 256}) {
    for (const double shift : {0., 0.21, 0.37}) {
      const Grid grid = Grid::square(cells, 2.5);
      const GapFunction gap = paraboloid(shift * grid.dx, -0.7 * shift * grid.dx);
      const auto stiffness = contact_stiffness(press(grid, gap, Press::by_approach(1)));
      EXPECT_NEAR(stiffness.value / 2, 1, 0.1 * grid.dx) << cells;
      EXPECT_GE(3 * stiffness.error, std::abs(stiffness.value - 2)) << cells << ' ' << shift;
    }
  }
}

// The force on a flat punch is its stiffness times the approach, here on the very same cells.
TEST(ContactStiffness, OfAFlatPunchIsForceOverApproach) {
  const GapFunction punch = [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 1 ? 0. : 1e3; };
  const auto pressed = press(Grid::square(64, 8. / 3.), punch, Press::by_approach(0.01));
  const auto stiffness = contact_stiffness(pressed);
  EXPECT_NEAR(stiffness.value * 0.01 / pressed.force.value, 1, 3e-6);
  const double exact = 2 * std::numbers::pi * 0.36678738;  // capacitance of a square, half its side 1
  EXPECT_LE(std::abs(stiffness.value - exact), 3 * stiffness.error);
  EXPECT_LE(stiffness.error, 3 * std::abs(stiffness.value - exact));
}

TEST(ContactStiffness, IsTheSlopeOfTheForce) {
  const Grid grid = Grid::of_cells(129, 101, 0.02, 0.025);
  const GapFunction gap = [](double x, double y) {
    return std::min(paraboloid(-0.6, 0.1, 1)(x, y), paraboloid(0.5, -0.2, 0.5)(x, y));
  };
  const double step = 0.02;
  const auto lower = press(grid, gap, Press::by_approach(0.2 - step)),
             middle = press(grid, gap, Press::by_approach(0.2)),
             upper = press(grid, gap, Press::by_approach(0.2 + step));
  const auto stiffness = contact_stiffness(middle);
  EXPECT_NEAR(stiffness.value, (upper.force.value - lower.force.value) / (2 * step), 3 * stiffness.error);
  EXPECT_LE(stiffness.error, 0.05 * stiffness.value);
}

TEST(ContactStiffness, ScalesWithTheModulus) {
  const Grid grid = Grid::square(32, 2.5);
  const auto gap = sample(grid, paraboloid());
  const auto one = press_half_space(grid, Surface::free, gap, 1, Press::by_approach(1));
  const auto other = press_half_space(grid, Surface::free, gap, 1024, Press::by_approach(1));
  EXPECT_EQ(contact_stiffness(other).value, 1024 * contact_stiffness(one).value);
}

TEST(ContactStiffness, SaysWhatItCannotDo) {
  const Grid grid = Grid::square(32, 1);
  const auto gap = sample(grid, [](double x, double) { return 0.01 * (1 - std::cos(2 * std::numbers::pi * x)); });
  const auto wave = press_half_space(grid, Surface::periodic, gap, 1, Press::by_force(0.01));
  EXPECT_THAT([&] { contact_stiffness(wave); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "a periodic surface has no stiffness: its mean displacement is infinite"));
  PressSettings settings;
  settings.max_iterations = 1;
  EXPECT_THROW(contact_stiffness(press(Grid::square(32, 2.5), paraboloid(), Press::by_approach(1)), settings),
               std::runtime_error);
}

}  // namespace
}  // namespace patchgrip::contact
