#include <patchgrip/friction/seed_hertz_disc.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();

const SeedHertzDisc seed = SeedHertzDisc::of_radius(1);

// Deviation of the fit from the exact disc, whose own error (8 units of rounding) does not count here.
struct Deviation {
  double force, moment, relative_moment;
};

Deviation deviation(const Twist& v) {
  static const HertzDisc exact = HertzDisc::of_radius(1);
  const Wrench g = seed.gradient(v), e = exact.gradient(v);
  return {std::fabs(g.fx - e.fx), std::fabs(g.m - e.m), std::fabs(g.m / e.m - 1)};
}

// Maxima over a fine scan. Between two of its poles the deviation, whose second derivative is below 4, can exceed
// theirs by h^2 / 2 at most: 5e-11.
struct Maxima {
  Deviation inside{}, outside{};
};

Maxima scan() {
  Maxima most;
  const auto include = [](Deviation& all, const Deviation& d) {
    all = {std::max(all.force, d.force), std::max(all.moment, d.moment),
           std::max(all.relative_moment, d.relative_moment)};
  };
  constexpr int steps = 100000;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    include(most.inside, deviation(twist_about({0, t}, 1)));               // x from 0 to 1
    if (i > 0) include(most.outside, deviation({1, 0, t * (1 - 1e-15)}));  // u from 0 to 1
  }
  return most;
}

TEST(SeedHertzDisc, LargestErrorsAreThoseOfItsHeader) {
  const Maxima most = scan();
  EXPECT_LE(most.inside.force, 4.28e-4);
  EXPECT_LE(most.outside.force, 4.72e-4);
  EXPECT_LE(most.inside.moment, 1e-15);  // exact
  EXPECT_LE(most.outside.moment, 1.18e-3);
  EXPECT_LE(most.outside.relative_moment, 1.34e-2);
}

TEST(SeedHertzDisc, LargestErrorsAreAttained) {
  const Maxima most = scan();
  EXPECT_GE(most.inside.force, 0.99 * 4.28e-4);
  EXPECT_GE(most.outside.force, 0.99 * 4.72e-4);
  EXPECT_GE(most.outside.moment, 0.99 * 1.18e-3);
  EXPECT_GE(most.outside.relative_moment, 0.99 * 1.34e-2);
}

TEST(SeedHertzDisc, CarriesBoundsThatHoldAtEveryPoleAndSize) {
  const kernels::PowerFamily<Real50> exact(1);
  for (const double radius : {1.0, 0.0037, 200.0}) {
    const SeedHertzDisc disc = SeedHertzDisc::of_radius(radius);
    for (const double x : {0.0, 1e-9, 0.3, 0.577, 0.8, 0.999, 1.0, 1 + 1e-12, 1.001, 1.05, 1.1485,
                           1.2, 1.5,  1.7, 1.8,   1.9, 2.0,   2.2, 5.0,       100.0, 1e8,  infinity}) {
      const Twist v = x == infinity ? Twist{0.6, -0.8, 0} : twist_about({radius * x * 0.28, radius * x * 0.96}, -3);
      const BoundedWrench g = disc.bounded_gradient(v);
      const Wrench50 e = round_wrench(exact, radius, v);
      EXPECT_LE(static_cast<double>(hypot(g.value.fx - e.fx, g.value.fy - e.fy)), g.force_error) << x;
      EXPECT_LE(static_cast<double>(abs(g.value.m - e.m)), g.moment_error) << x;
    }
  }
}

TEST(SeedHertzDisc, HasThePolynomialsOfTheSeed) {
  const Wrench inside = seed.gradient(twist_about({0, 0.5}, 1));
  EXPECT_NEAR(inside.fx, 1.178 * 0.5 - 0.294 * 0.125, 1e-15);
  EXPECT_NEAR(inside.m, 3 * std::numbers::pi / 16 * (1 - 0.25 + 0.375 * 0.0625), 1e-15);
  const Wrench outside = seed.gradient(twist_about({0, 2}, 1));
  EXPECT_NEAR(outside.fx, 1 - 0.096 / 4 - 0.020 / 16, 1e-15);
  EXPECT_NEAR(outside.m, 3 * std::numbers::pi / 16 * (0.335 / 2 + 0.040 / 8), 1e-15);
}

TEST(SeedHertzDisc, TheTwoSidesMeetAtTheRim) {
  const Wrench inside = seed.gradient(twist_about({0, 1}, 1));
  const Wrench outside = seed.gradient(twist_about({0, std::nextafter(1.0, 2)}, 1));
  EXPECT_NEAR(inside.fx, 0.884, 1e-15);
  EXPECT_NEAR(outside.fx, 0.884, 1e-15);
  EXPECT_NEAR(outside.m, inside.m, 1e-15);
}

TEST(SeedHertzDisc, IsCentredWithThePolarMomentOfAHertzDisc) {
  EXPECT_EQ(SeedHertzDisc::of_radius(3).moments().polar, HertzDisc::of_radius(3).moments().polar);
  EXPECT_EQ(SeedHertzDisc::of_radius(3).area_radius(), 3);
}

TEST(SeedHertzDisc, SlopesAreThoseOfItsForce) {
  for (const double x : {0.4, 2.5}) {
    const double h = 1e-6;
    const double slope = (seed.gradient({x + h, 0, 1}).fx - seed.gradient({x - h, 0, 1}).fx) / (2 * h);
    EXPECT_NEAR(seed.hessian({x, 0, 1}).xx, slope, 1e-9) << x;  // rounding of the difference: 1e-16 / h
  }
}

TEST(SeedHertzDisc, RadiiThatAreNotPositiveAndFiniteAreRefused) {
  EXPECT_THAT([] { SeedHertzDisc::of_radius(-1); },
              ThrowsMessage<std::invalid_argument>("radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THROW(SeedHertzDisc::of_radius(std::nan("")), std::invalid_argument);
  EXPECT_THROW(SeedHertzDisc::of_radius(infinity), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
