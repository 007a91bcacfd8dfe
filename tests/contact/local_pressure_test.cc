#include <patchgrip/contact/half_space/local_pressure.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/contact/press_cases.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;

PressSettings local() {
  PressSettings settings;
  settings.local_errors = true;
  return settings;
}

// p / p_0
double hertz(double rho2) { return rho2 < 1 ? std::sqrt(1 - rho2) : 0; }

TEST(LocalPressure, ErrorsHoldOnHertzContactsLaidAnyhow) {
  std::mt19937_64 engine(20061127);
  double worst = 0;
  std::vector<double> errors;
  for (int k = 0; k < cases(150); ++k) {
    const int cells = 2 * static_cast<int>(uniform(engine, 16, 64));
    const double dx = 1, dy = uniform(engine, 0.5, 2), R = 1000;
    const double room = 0.4 * cells * std::min(dx, dy);
    const double a = log_uniform(engine, 1.5 * std::max(dx, dy), room), p0 = 2 * a / (std::numbers::pi * R);
    const double x0 = uniform(engine, -1, 1), y0 = uniform(engine, -1, 1);
    const auto pressed = press(Grid::of_cells(cells, cells, dx, dy), paraboloid(x0, y0, R),
                               Press::by_force(4. / 3. * a * a * a / R), local());
    for (int n = 0; n < 300; ++n) {
      const double r = uniform(engine, 0, 1.2) * a, angle = uniform(engine, -4, 4);
      const double x = x0 + r * std::cos(angle), y = y0 + r * std::sin(angle);
      const auto p = local_pressure(pressed, x, y);
      if (!p) continue;
      const double missed = std::abs(p->value - p0 * hertz(r * r / (a * a)));
      EXPECT_LE(missed, p->error) << "a = " << a << ", r/a = " << r / a;
      if (missed > 0) worst = std::max(worst, missed / p->error);
      if (a > 20) errors.push_back(p->error / p0);
    }
  }
  std::ranges::sort(errors);
  RecordProperty("worst_of_estimate", std::to_string(worst));
  if (!patchgrip::testing::all_cases()) return;
  ASSERT_FALSE(errors.empty());
  const double median = errors[errors.size() / 2];
  RecordProperty("median_of_wide_contacts", std::to_string(median));
  EXPECT_LE(median, 0.01);
}

// Against the same surface on four times as many cells a side: small where nothing touches near, large at the edges.
TEST(LocalPressure, ErrorsOnARoughSurfaceAreLocal) {
  const Grid fine = Grid::square(256, 1), grid = Grid::square(64, 1);
  const auto gap_on = [](const Grid& on) {
    auto gap = rough_surface(on, 7, 0.1);
    const double highest = *std::ranges::max_element(gap);
    for (double& g : gap) g = highest - g;
    return gap;
  };
  const auto pressed_on = [&](const Grid& on) {
    return press_half_space(on, Surface::periodic, gap_on(on), 1, Press::by_force(0.01), local());
  };
  const auto pressed = pressed_on(grid), exact = pressed_on(fine);
  std::mt19937_64 engine(5);
  int missed = 0, far = 0, sharp = 0;
  constexpr int points = 5000;
  for (int n = 0; n < points; ++n) {
    const double x = uniform(engine, -2, 2), y = uniform(engine, -2, 2);
    const Estimate p = *local_pressure(pressed, x, y), true_p = *local_pressure(exact, x, y);
    if (std::abs(p.value - true_p.value) > 3 * (p.error + true_p.error)) ++missed;
    if (p.error == 0) ++far;
    if (p.error > 0.1 * pressed.peak_pressure.value) ++sharp;
  }
  EXPECT_EQ(missed, 0);
  EXPECT_GT(far, points / 4);
  EXPECT_GT(sharp, points / 100);
  EXPECT_LT(sharp, points / 2);
}

TEST(LocalPressure, APeriodicSurfaceRepeatsAndAFreeOneEnds) {
  const Grid grid = Grid::of_cells(16, 32, 0.5, 0.25);
  const auto gap = sample(grid, paraboloid(0.4, -0.3));
  const auto free = press_half_space(grid, Surface::free, gap, 1, Press::by_force(0.5), local());
  EXPECT_TRUE(local_pressure(free, 4, -4));
  EXPECT_FALSE(local_pressure(free, 4.0001, 0));
  EXPECT_FALSE(local_pressure(free, 0, -4.0001));
  const auto periodic = press_half_space(grid, Surface::periodic, gap, 1, Press::by_force(0.5), local());
  const Estimate p = *local_pressure(periodic, 0.3, -0.2), again = *local_pressure(periodic, 0.3 - 24, -0.2 + 40);
  EXPECT_NEAR(p.value, again.value, 1e-12 * p.value);
  EXPECT_NEAR(p.error, again.error, 1e-12 * p.value);
  EXPECT_GT(p.value, 0);
  // Beyond the digits of a coordinate the place in the period is any.
  for (const double far : {1e17, -1e17, 1e300, -1e300}) {
    const Estimate somewhere = *local_pressure(periodic, far, -far);
    EXPECT_GE(somewhere.value, 0);
    EXPECT_LE(somewhere.value, periodic.peak_pressure.value + periodic.peak_pressure.error);
  }
}

TEST(LocalPressure, IsCertainlyNoneWhereAContactThatOnlyTheFineGridSeesIsFar) {
  const Grid grid = Grid::square(64, 64);
  const auto pressed = press(grid, paraboloid(0.4, 0.5, 1000), Press::by_approach(0.25 * 0.25 / 1000), local());
  EXPECT_EQ(local_pressure(pressed, 20, 20)->value, 0);
  EXPECT_EQ(local_pressure(pressed, 20, 20)->error, 0);
  EXPECT_EQ(local_pressure(pressed, 0.5, 0.5)->error, std::numeric_limits<double>::infinity());
}

TEST(LocalPressure, AtACentreItIsThePressureOfTheCell) {
  const Grid grid = Grid::square(32, 4);
  const auto pressed = press(grid, paraboloid(), Press::by_force(1), local());
  for (const int i : {0, 9, 16, 31}) {
    EXPECT_EQ(local_pressure(pressed, grid.x(i), grid.y(13))->value, pressed.pressure[grid.index(i, 13)]) << i;
  }
}

TEST(LocalPressure, AsksForLocalErrorsAndFinitePlaces) {
  const Grid grid = Grid::square(16, 4);
  EXPECT_THROW(local_pressure(press(grid, paraboloid(), Press::by_force(1)), 0, 0), std::invalid_argument);
  EXPECT_THROW(local_pressure(press(grid, paraboloid(), Press::by_force(1), local()), NAN, 0), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
