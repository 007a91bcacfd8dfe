#include <patchgrip/contact/half_space/press.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/tests/contact/press_cases.h>

namespace patchgrip::contact {
namespace {

TEST(PressHalfSpace, WarmStartNeverHurts) {
  const Grid grid = Grid::square(128, 2.5);
  const auto gap =
      sample(grid, [](double x, double y) { return paraboloid()(x, y) + 0.02 * std::cos(9 * x) * std::cos(7 * y); });
  PressedHalfSpace last = press_half_space(grid, Surface::free, gap, 1, Press::by_force(0.5));
  for (const double force : {0.5, 0.5000001, 0.505, 0.55, 0.8, 0.4, 0.1}) {
    const auto cold = press_half_space(grid, Surface::free, gap, 1, Press::by_force(force));
    const auto warm = press_half_space(grid, Surface::free, gap, 1, Press::by_force(force), {}, &last);
    EXPECT_LE(warm.all_iterations, cold.all_iterations) << force;
    EXPECT_NEAR(warm.approach.value, cold.approach.value, 2e-6) << force;
    if (force == 0.5) {
      EXPECT_EQ(warm.iterations, 0);
    }
    last = warm;
  }
}

TEST(PressHalfSpace, ThreadsDoNotChangeTheResult) {
  const Grid grid = Grid::square(128, 2.5);
  PressSettings settings;
  settings.threads = 1;
  const auto alone = press(grid, paraboloid(), Press::by_force(1), settings);
  for (const int threads : {2, 3, 5}) {
    settings.threads = threads;
    const auto shared = press(grid, paraboloid(), Press::by_force(1), settings);
    EXPECT_EQ(shared.pressure, alone.pressure);
    EXPECT_EQ(shared.approach.value, alone.approach.value);
    EXPECT_EQ(shared.area.value, alone.area.value);
    EXPECT_EQ(shared.peak_pressure.error, alone.peak_pressure.error);
    EXPECT_EQ(shared.zones[0].x, alone.zones[0].x);
  }
}

// Many zones of very different pressure.
TEST(PressHalfSpace, ThreadsDoNotChangeARoughSurface) {
  const Grid grid = Grid::square(128, 1);
  const auto gap = rough_surface(grid, 1, 1);
  PressSettings settings;
  settings.threads = 1;
  const auto alone = press_half_space(grid, Surface::periodic, gap, 1, Press::by_force(0.05), settings);
  ASSERT_GT(alone.zones.size(), 2U);
  settings.threads = 3;
  const auto shared = press_half_space(grid, Surface::periodic, gap, 1, Press::by_force(0.05), settings);
  EXPECT_EQ(shared.pressure, alone.pressure);
  ASSERT_EQ(shared.zones.size(), alone.zones.size());
  for (std::size_t k = 0; k < alone.zones.size(); ++k) {
    EXPECT_EQ(shared.zones[k].force.value, alone.zones[k].force.value);
    EXPECT_EQ(shared.zones[k].area.value, alone.zones[k].area.value);
    EXPECT_EQ(shared.zones[k].area.error, alone.zones[k].area.error);
  }
}

TEST(PressHalfSpace, OddSizesAreExtended) {
  const Grid grid = Grid::of_cells(101, 67, 0.025, 0.038);
  const auto result = press(grid, paraboloid(0.1, -0.05), Press::by_approach(1));
  EXPECT_EQ(result.pressure.size(), grid.size());
  EXPECT_LE(relative(result.force.value, 4. / 3.), 2e-4);
  EXPECT_NEAR(result.zones[0].x, 0.1, std::min(1e-4, 3 * result.zones[0].centre_error));
  EXPECT_NEAR(result.zones[0].y, -0.05, std::min(1e-4, 3 * result.zones[0].centre_error));
}

RC_GTEST_PROP(PressHalfSpace, ScalesWithLengthAndModulus, ()) {
  const double length = std::ldexp(1, *rc::gen::inRange(-30, 30)), modulus = std::ldexp(1, *rc::gen::inRange(-10, 40));
  std::mt19937_64 engine(*rc::gen::arbitrary<unsigned>());
  const Grid grid = Grid::square(32, 2.5), scaled = Grid::square(32, 2.5 * length);
  const auto gap = sample(grid, hertz_ellipse(0.5, patchgrip::testing::uniform(engine, 0, 3)).gap);
  auto scaled_gap = gap;
  for (double& f : scaled_gap) f *= length;
  const auto one = press_half_space(grid, Surface::free, gap, 1, Press::by_approach(0.5));
  const auto other = press_half_space(scaled, Surface::free, scaled_gap, modulus, Press::by_approach(0.5 * length));
  RC_ASSERT(other.force.value == one.force.value * modulus * length * length);
  RC_ASSERT(other.peak_pressure.value == one.peak_pressure.value * modulus);
  RC_ASSERT(other.area.value == one.area.value * length * length);
}

RC_GTEST_PROP(PressHalfSpace, MirroredShapesHaveMirroredPressure, ()) {
  std::mt19937_64 engine(*rc::gen::arbitrary<unsigned>());
  const Grid grid = Grid::square(32, 3);
  const GapFunction shape = [blob = random_shape(engine)](double x, double y) { return blob(x, y) + x * x + y * y; };
  const auto one = press(grid, shape, Press::by_force(0.3), with_tolerance(1e-10));
  const auto mirrored = press(
      grid, [&](double x, double y) { return shape(-y, x); }, Press::by_force(0.3), with_tolerance(1e-10));
  RC_ASSERT(std::abs(mirrored.approach.value - one.approach.value) < 1e-8 * std::max(1., one.approach.value));
  for (int j = 0; j < 32; ++j) {
    for (int i = 0; i < 32; ++i) {
      RC_ASSERT(std::abs(mirrored.pressure[grid.index(i, j)] - one.pressure[grid.index(31 - j, i)]) <
                1e-6 * one.peak_pressure.value);
    }
  }
}

RC_GTEST_PROP(PressHalfSpace, MoreApproachIsMoreForceAndMoreContact, ()) {
  std::mt19937_64 engine(*rc::gen::arbitrary<unsigned>());
  const Grid grid = Grid::square(32, 4);
  const GapFunction shape = [blob = random_shape(engine)](double x, double y) { return blob(x, y) + x * x + y * y; };
  const auto gap = sample(grid, shape);
  const double least = *std::ranges::min_element(gap);
  double force = 0, area = 0;
  for (const double depth : {0.1, 0.2, 0.4, 0.8}) {
    const auto result =
        press_half_space(grid, Surface::free, gap, 1, Press::by_approach(least + depth), with_tolerance(1e-8));
    RC_ASSERT(result.force.value > force);
    RC_ASSERT(result.counted_area >= area);
    force = result.force.value;
    area = result.counted_area;
  }
}

// Loads, moduli and lengths of any magnitude: the numbers in between stay representable.
TEST(PressHalfSpace, MagnitudesDoNotMatter) {
  for (const double length : {1e-40, 1e-9, 1e20}) {
    for (const double modulus : {1e-90, 1e11, 1e90}) {
      const Grid grid = Grid::square(64, 2.5 * length);
      const auto gap = sample(grid, paraboloid(0, 0, length));
      const double force = 4. / 3. * modulus * length * length;
      const auto by_force = press_half_space(grid, Surface::free, gap, modulus, Press::by_force(force));
      const auto by_approach = press_half_space(grid, Surface::free, gap, modulus, Press::by_approach(length));
      EXPECT_LE(relative(by_force.approach.value, length), 5e-5);
      EXPECT_LE(relative(by_approach.force.value, force), 7e-5);
    }
  }
}

TEST(PressHalfSpace, GapInAnyDatum) {
  const Grid grid = Grid::square(32, 2.5);
  const auto one = press(grid, paraboloid(), Press::by_force(1));
  const auto other = press(
      grid, [](double x, double y) { return paraboloid()(x, y) - 8; }, Press::by_force(1));
  EXPECT_NEAR(other.approach.value, one.approach.value - 8, 1e-12);
}

TEST(PressHalfSpace, SaysWhenItDoesNotConverge) {
  PressSettings settings;
  settings.max_iterations = 2;
  EXPECT_THAT(
      [&] { press(Grid::square(64, 2.5), paraboloid(), Press::by_approach(1), settings); },
      ::testing::ThrowsMessage<std::runtime_error>(::testing::MatchesRegex(
          "pressure on 32 x 32 cells did not converge: residual 0.[0-9]+ after 2 iterations, tolerance 4e-06")));
}

TEST(PressHalfSpace, ContactOnTheBorderIsRefused) {
  const auto touches = [](const std::string& place) {
    return ::testing::ThrowsMessage<std::domain_error>("contact touches the border of the grid at " + place +
                                                       ": the grid must be larger than the contact");
  };
  EXPECT_THAT([] { press(Grid::square(32, 3.2), paraboloid(1), Press::by_approach(1)); },
              touches("x = 1.55 m, y = -0.85 m"));
  EXPECT_THROW(press(Grid::of_cells(33, 33, 0.1, 0.1), paraboloid(1), Press::by_approach(1)), std::domain_error);
  EXPECT_THROW(press(Grid::square(32, 1), paraboloid(), Press::by_force(100)), std::domain_error);
}

TEST(PressHalfSpace, ObserverSeesEveryIterationAndMayStop) {
  PressSettings settings;
  int calls = 0;
  settings.observer = [&](const SolverProgress& progress) {
    ++calls;
    EXPECT_GE(progress.iteration, 1);
    EXPECT_GT(progress.residual, 0);
  };
  EXPECT_EQ(press(Grid::square(64, 2.5), paraboloid(), Press::by_approach(1), settings).all_iterations, calls);
  struct Stop {};
  settings.observer = [](const SolverProgress& progress) {
    if (progress.grid.nx == 64 && progress.iteration == 2) throw Stop();
  };
  EXPECT_THROW(press(Grid::square(64, 2.5), paraboloid(), Press::by_approach(1), settings), Stop);
}

TEST(PressHalfSpace, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  const Grid grid = Grid::square(16, 1);
  std::vector<double> gap(grid.size(), 0.5);
  const auto press = [&](Surface surface, const Press& load, const PressSettings& settings = {}, double modulus = 1) {
    press_half_space(grid, surface, gap, modulus, load, settings);
  };
  EXPECT_THAT([] { Press::by_force(0); }, refused("force = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { Press::by_approach(NAN); }, refused("approach = nan is not allowed: must be finite"));
  EXPECT_THAT([&] { press(Surface::free, Press::by_approach(0.5)); },
              refused("approach = 0.5 is not allowed: must exceed the least gap, or nothing touches"));
  EXPECT_THAT([&] { press(Surface::free, Press::by_force(1), {}, -1); },
              refused("contact_modulus = -1 is not allowed: must lie in [1e-100, 1e+100]"));
  EXPECT_THAT([&] { press(Surface::free, Press::by_force(1), with_tolerance(0)); },
              refused("tolerance = 0 is not allowed: must lie in [1e-12, 0.01]"));
  EXPECT_THAT([&] { press(Surface::free, Press::by_approach(0.5 + 1e200)); },
              refused("approach - least gap = 1e+200 is not allowed: must lie in [1e-100, 1e+100]"));
  EXPECT_THAT([&] { press(Surface::free, Press::by_force(1e-99), {}, 256e50); },
              refused("force / (contact_modulus dx dy) = 1e-149 is not allowed: must lie in [1e-100, 1e+100]"));
  PressSettings settings;
  settings.max_iterations = 0;
  EXPECT_THAT([&] { press(Surface::free, Press::by_force(1), settings); },
              refused("max_iterations = 0 is not allowed: must lie in [1, 1e+06]"));
  settings = {};
  settings.threads = 65;
  EXPECT_THAT([&] { press(Surface::free, Press::by_force(1), settings); },
              refused("threads = 65 is not allowed: must lie in [1, 64]"));
  EXPECT_THAT([&] { press(Surface::periodic, Press::by_approach(1)); },
              refused("approach = 1 is not allowed: must not be prescribed on a periodic surface: its mean "
                      "displacement is infinite"));
  gap[3] = std::numeric_limits<double>::infinity();
  EXPECT_THAT([&] { press(Surface::free, Press::by_force(1)); },
              refused("gap = inf is not allowed: must lie in [-1e+100, 1e+100]"));
  gap.pop_back();
  EXPECT_THAT([&] { press(Surface::free, Press::by_force(1)); },
              refused("gap.size() = 255 is not allowed: must be nx ny of the grid"));
  const Grid odd = Grid::of_cells(16, 17, 1, 1);
  EXPECT_THAT([&] { press_half_space(odd, Surface::periodic, std::vector<double>(odd.size()), 1, Press::by_force(1)); },
              refused("ny = 17 is not allowed: must be even on a periodic surface"));
  const auto other = press_half_space(Grid::square(32, 2.5), Surface::free, sample(Grid::square(32, 2.5), paraboloid()),
                                      1, Press::by_force(1));
  gap.assign(256, 0.);
  EXPECT_THAT([&] { press_half_space(grid, Surface::free, gap, 1, Press::by_force(1), {}, &other); },
              refused("the start belongs to another grid or surface"));
}

}  // namespace
}  // namespace patchgrip::contact
