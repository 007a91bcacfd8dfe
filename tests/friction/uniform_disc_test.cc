#include <patchgrip/friction/uniform_disc.h>

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

TEST(UniformDisc, AtTheCentreTheMomentIsTwoThirdsOfTheRadius) {
  const Wrench g = UniformDisc::of_radius(1).gradient({0, 0, -3});
  EXPECT_NEAR(g.m, -2.0 / 3, tolerance);
  EXPECT_EQ(g.fx, 0);
}

TEST(UniformDisc, OnTheRimItIsRational) {
  const UniformDisc disc = UniformDisc::of_radius(1);
  const Wrench g = disc.gradient(twist_about({0, 1}, 1));
  EXPECT_NEAR(g.fx, 8 / (3 * pi), tolerance);
  EXPECT_NEAR(g.m, 8 / (9 * pi), tolerance);
  EXPECT_NEAR(disc.hessian(twist_about({0, 1}, 1)).xx, 4 / (3 * pi), tolerance);
}

TEST(UniformDisc, HasTheFormsWithEllipticIntegrals) {
  constexpr double handbook = 5e-14;  // std::comp_ellint loses some hundred units near k = 1
  const UniformDisc disc = UniformDisc::of_radius(1);
  for (const double x : {0.5, 0.9, 0.999}) {
    const double K = std::comp_ellint_1(x), E = std::comp_ellint_2(x);
    const Wrench g = disc.gradient(twist_about({0, x}, 1));
    EXPECT_NEAR(g.fx, 4 / (3 * pi * x) * ((1 + x * x) * E - (1 - x * x) * K), handbook);
    EXPECT_NEAR(g.m, 4 / (9 * pi) * ((4 - 2 * x * x) * E - (1 - x * x) * K), handbook);
  }
  for (const double x : {1.001, 1.1, 2.0}) {
    const double K = std::comp_ellint_1(1 / x), E = std::comp_ellint_2(1 / x);
    const Wrench g = disc.gradient(twist_about({0, x}, 1));
    EXPECT_NEAR(g.fx, 4 / (3 * pi) * ((1 + x * x) * E - (x * x - 1) * K), handbook);
  }
}

TEST(UniformDisc, FarAwayTheMomentIsAQuarterOfRadiusOverDistance) {
  EXPECT_NEAR(UniformDisc::of_radius(1).gradient(twist_about({0, 1e8}, 1)).m / 1e-8, 0.25, tolerance);
}

TEST(UniformDisc, IsCentredWithThePolarMomentOfItsPressure) {
  const PressureMoments s = UniformDisc::of_radius(3).moments();
  EXPECT_EQ(s.x, 0);
  EXPECT_EQ(s.y, 0);
  EXPECT_DOUBLE_EQ(s.polar, 4.5);  // a^2 / 2
}

TEST(UniformDisc, HasItsOwnRadiusAsAreaRadius) {
  EXPECT_EQ(UniformDisc::of_radius(0.3).area_radius(), 0.3);
  EXPECT_EQ(UniformDisc::of_radius(0.3).radius(), 0.3);
}

TEST(UniformDisc, RadiiThatAreNotPositiveAndFiniteAreRefused) {
  const auto of = [](double radius) { return [radius] { UniformDisc::of_radius(radius); }; };
  EXPECT_THAT(of(-1), ThrowsMessage<std::invalid_argument>("radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT(of(0), ThrowsMessage<std::invalid_argument>("radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(std::numeric_limits<double>::quiet_NaN())(), std::invalid_argument);
  EXPECT_THROW(of(std::numeric_limits<double>::infinity())(), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
