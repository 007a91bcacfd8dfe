#include <patchgrip/friction/flat_punch_disc.h>

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

TEST(FlatPunchDisc, LimitCurveIsAParabolaWhileThePoleIsInside) {
  const FlatPunchDisc disc = FlatPunchDisc::of_radius(1);
  for (const double x : {0.0, 1e-12, 0.3, 0.99, 1.0}) {
    const Wrench g = disc.gradient(twist_about({0, x}, 1));
    EXPECT_NEAR(g.fx, pi / 4 * x, tolerance);
    EXPECT_NEAR(g.m, pi / 4 - 2 / pi * g.fx * g.fx, tolerance);
  }
}

TEST(FlatPunchDisc, OutsideItHasTheFormWithTheArcSine) {
  const FlatPunchDisc disc = FlatPunchDisc::of_radius(1);
  for (const double x : {1.1, 1.5, 3.0}) {
    const double root = std::sqrt((x - 1) * (x + 1));
    const double arc = std::atan2(1, root);
    const Wrench g = disc.gradient(twist_about({0, x}, 1));
    const double lost = x * x * x;  // what the closed forms cancel by
    EXPECT_NEAR(g.fx, (x * arc + root / x) / 2, tolerance * lost);
    EXPECT_NEAR(g.m, ((2 - x * x) * arc + root) / 4, tolerance * lost);
  }
}

// The infinite pressure at the edge bends f by -(2 sqrt(2)/3)(x - 1)^(3/2) just outside.
TEST(FlatPunchDisc, TheOuterBranchLeavesTheInnerOneLikeThePowerThreeHalves) {
  const FlatPunchDisc disc = FlatPunchDisc::of_radius(1);
  for (const double away : {1e-6, 1e-4, 1e-2}) {
    const double difference = disc.gradient(twist_about({0, 1 + away}, 1)).fx - pi / 4 * (1 + away);
    EXPECT_NEAR(difference / (-2 * std::sqrt(2.0) / 3 * std::pow(away, 1.5)), 1,
                2 * away + 1e-15 / std::pow(away, 1.5));
  }
}

TEST(FlatPunchDisc, FarAwayTheMomentIsAThirdOfRadiusOverDistance) {
  EXPECT_NEAR(FlatPunchDisc::of_radius(1).gradient(twist_about({0, 1e8}, 1)).m / 1e-8, 1.0 / 3, tolerance);
}

TEST(FlatPunchDisc, IsCentredWithThePolarMomentOfItsPressure) {
  const PressureMoments s = FlatPunchDisc::of_radius(3).moments();
  EXPECT_EQ(s.x, 0);
  EXPECT_EQ(s.y, 0);
  EXPECT_DOUBLE_EQ(s.polar, 6.0);  // 2 a^2 / 3
}

TEST(FlatPunchDisc, HasItsOwnRadiusAsAreaRadius) {
  EXPECT_EQ(FlatPunchDisc::of_radius(0.3).area_radius(), 0.3);
  EXPECT_EQ(FlatPunchDisc::of_radius(0.3).radius(), 0.3);
}

TEST(FlatPunchDisc, RadiiThatAreNotPositiveAndFiniteAreRefused) {
  const auto of = [](double radius) { return [radius] { FlatPunchDisc::of_radius(radius); }; };
  EXPECT_THAT(of(-1), ThrowsMessage<std::invalid_argument>("radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT(of(0), ThrowsMessage<std::invalid_argument>("radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(std::numeric_limits<double>::quiet_NaN())(), std::invalid_argument);
  EXPECT_THROW(of(std::numeric_limits<double>::infinity())(), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
