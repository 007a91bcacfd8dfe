#include <patchgrip/friction/hertz_disc.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::friction {
namespace {

using std::numbers::pi;
using ::testing::ThrowsMessage;

// A few units of rounding for numbers of order one.
constexpr double tolerance = 8 * 0x1p-53;

TEST(HertzDisc, AtTheCentreItResistsTurningAlone) {
  const Wrench g = HertzDisc::of_radius(0.5).gradient({0, 0, 2});
  EXPECT_EQ(g.fx, 0);
  EXPECT_EQ(g.fy, 0);
  EXPECT_NEAR(g.m, 0.5 * 3 * pi / 16, tolerance);
}

TEST(HertzDisc, OnTheRimForceAndMomentAreThoseOfBothBranches) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  for (const double x : {1.0, std::nextafter(1.0, 2), std::nextafter(1.0, 0)}) {
    const Wrench g = disc.gradient(twist_about({0, x}, 1));
    EXPECT_NEAR(g.fx, 9 * pi / 32, tolerance);
    EXPECT_NEAR(g.m, 9 * pi / 128, tolerance);
  }
}

// The branches differ by 0.8 sqrt(2) (x - 1)^(5/2) in f: nothing to see of it at the rim, all of it further out.
TEST(HertzDisc, TheOuterBranchLeavesTheInnerOneLikeThePowerFiveHalves) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  for (const double away : {1e-4, 1e-3, 1e-2}) {
    const double x = 1 + away;
    const double inner = 3 * pi / 8 * (x - x * x * x / 4);
    const double outer = disc.gradient(twist_about({0, x}, 1)).fx;
    EXPECT_NEAR((outer - inner) / (0.8 * std::sqrt(2.0) * std::pow(away, 2.5)), 1,
                2 * away + 1e-15 / std::pow(away, 2.5));
  }
}

TEST(HertzDisc, OutsideItHasTheFormWithTheArcSine) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  for (const double x : {1.1, 1.5, 3.0}) {
    const double root = std::sqrt((x - 1) * (x + 1));
    const double arc = std::atan2(1, root);
    const Wrench g = disc.gradient(twist_about({0, x}, 1));
    const double lost = std::pow(x, 5);  // what the closed forms cancel by
    EXPECT_NEAR(g.fx, 3.0 / 16 * (x * (4 - x * x) * arc + (x * x + 2) * root / x), tolerance * lost);
    EXPECT_NEAR(g.m, 3.0 / 64 * ((8 - 8 * x * x + 3 * x * x * x * x) * arc + (6 - 3 * x * x) * root), tolerance * lost);
  }
}

TEST(HertzDisc, FarAwayTheMomentIsAFifthOfRadiusOverDistance) {
  const Wrench g = HertzDisc::of_radius(1).gradient(twist_about({0, 1e8}, 1));
  EXPECT_NEAR(g.m / 1e-8, 0.2, tolerance);
  EXPECT_NEAR(g.fx, 1, tolerance);
}

// Eliminating the pole: f^2 = (pi^2/48)(1 - q)(2 + q)^2 with q^2 = 8 m/pi - 1/2, while the pole is inside.
TEST(HertzDisc, LimitCurveIsTheAlgebraicOneWhileThePoleIsInside) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  for (const double x : {0.0, 0.2, 0.5, 0.81}) {  // q >= 0 up to x = sqrt(2/3)
    const Wrench g = disc.gradient(twist_about({0, x}, 1));
    const double q = std::sqrt(std::max(8 * g.m / pi - 0.5, 0.0));
    EXPECT_NEAR(g.fx * g.fx, pi * pi / 48 * (1 - q) * (2 + q) * (2 + q), 1e-14) << x;
  }
}

TEST(HertzDisc, IsCentredWithThePolarMomentOfItsPressure) {
  const PressureMoments s = HertzDisc::of_radius(3).moments();
  EXPECT_EQ(s.x, 0);
  EXPECT_EQ(s.y, 0);
  EXPECT_DOUBLE_EQ(s.polar, 2.0 / 5 * 9);  // 2 a^2 / 5
}

TEST(HertzDisc, HasItsOwnRadiusAsAreaRadius) {
  EXPECT_EQ(HertzDisc::of_radius(0.3).area_radius(), 0.3);
  EXPECT_EQ(HertzDisc::of_radius(0.3).radius(), 0.3);
}

TEST(HertzDisc, RadiiThatAreNotPositiveAndFiniteAreRefused) {
  const auto of = [](double radius) { return [radius] { HertzDisc::of_radius(radius); }; };
  EXPECT_THAT(of(-1), ThrowsMessage<std::invalid_argument>("radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT(of(0), ThrowsMessage<std::invalid_argument>("radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(std::numeric_limits<double>::quiet_NaN())(), std::invalid_argument);
  EXPECT_THROW(of(std::numeric_limits<double>::infinity())(), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
