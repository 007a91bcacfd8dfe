#include <patchgrip/friction/ring.h>

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

TEST(Ring, ForceAndMomentAgreeOnTheRim) {
  const Wrench g = Ring::of_radius(1).gradient(twist_about({0, 1}, 1));
  EXPECT_NEAR(g.fx, 2 / pi, tolerance);
  EXPECT_NEAR(g.m, 2 / pi, tolerance);
}

TEST(Ring, AtTheCentreAllOfItSlidesTangentially) {
  const Wrench g = Ring::of_radius(0.25).gradient({0, 0, 1});
  EXPECT_NEAR(g.m, 0.25, tolerance);
  EXPECT_EQ(g.fx, 0);
}

// An inversion at the ring swaps force and moment: f(1/x) = m(x).
TEST(Ring, ForceOfAPoleIsTheMomentOfItsInverse) {
  const Ring ring = Ring::of_radius(1);
  for (const double x : {0.0625, 0.5, 0.75, 2.0, 16.0}) {
    const Wrench g = ring.gradient(twist_about({0, x}, 1));
    const Wrench inverse = ring.gradient(twist_about({0, 1 / x}, 1));
    EXPECT_NEAR(g.fx, inverse.m, tolerance) << x;
  }
}

TEST(Ring, HasTheFormsWithEllipticIntegrals) {
  const Ring ring = Ring::of_radius(1);
  for (const double x : {0.3, 0.9, 1.1, 3.0}) {
    const double k = 2 * std::sqrt(x) / (1 + x);
    const double K = std::comp_ellint_1(k), E = std::comp_ellint_2(k);
    const Wrench g = ring.gradient(twist_about({0, x}, 1));
    // std::comp_ellint loses some hundred units near k = 1
    EXPECT_NEAR(g.fx, ((x + 1) * E + (x - 1) * K) / (pi * x), 5e-14);
    EXPECT_NEAR(g.m, ((1 + x) * E + (1 - x) * K) / pi, 5e-14);
  }
}

TEST(Ring, HessianOnTheRimIsRefused) {
  const auto hessian = [](const Twist& v) { return [v] { Ring::of_radius(5).hessian(v); }; };
  const char* message = "twist has its pole on the rim: the Hessian of D is infinite there";
  EXPECT_THAT(hessian({5, 0, 1}), ThrowsMessage<std::domain_error>(message));
  EXPECT_THAT(hessian({3, 4, -1}), ThrowsMessage<std::domain_error>(message));
  EXPECT_THAT(hessian({0, -5 * 0x1p-1000, 0x1p-1000}), ThrowsMessage<std::domain_error>(message));
}

TEST(Ring, HessianNextToTheRimIsLargeAndFinite) {
  const Ring ring = Ring::of_radius(1);
  for (const double x : {std::nextafter(1.0, 0), std::nextafter(1.0, 2)}) {
    const double d = std::fabs(1 - x);
    // f' = (ln(8 / d) - 2) / pi + O(d ln d) in the limit, on both sides.
    EXPECT_NEAR(ring.hessian(twist_about({0, x}, 1)).xx, (std::log(8 / d) - 2) / pi, 1e-14);
  }
}

TEST(Ring, WithThePoleOffTheRimByARoundingOfTheRadiusAloneIsToldFromIt) {
  // 0.1 * 3 and the speed round to the same double; V^2 - a^2 w^2 is not zero, and its sign decides the side.
  const Ring ring = Ring::of_radius(0.1);
  const double speed = 0.1 * 3;
  ASSERT_NE(std::fma(0.1, 3, -speed), 0);
  EXPECT_GT(ring.hessian({speed, 0, 3}).xx, 1);
}

TEST(Ring, IsCentredWithThePolarMomentOfItsPressure) {
  const PressureMoments s = Ring::of_radius(3).moments();
  EXPECT_EQ(s.x, 0);
  EXPECT_EQ(s.y, 0);
  EXPECT_DOUBLE_EQ(s.polar, 9.0);  // a^2
}

TEST(Ring, HasItsOwnRadiusAsAreaRadius) {
  EXPECT_EQ(Ring::of_radius(0.3).area_radius(), 0.3);
  EXPECT_EQ(Ring::of_radius(0.3).radius(), 0.3);
}

TEST(Ring, RadiiThatAreNotPositiveAndFiniteAreRefused) {
  const auto of = [](double radius) { return [radius] { Ring::of_radius(radius); }; };
  EXPECT_THAT(of(-1), ThrowsMessage<std::invalid_argument>("radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT(of(0), ThrowsMessage<std::invalid_argument>("radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(std::numeric_limits<double>::quiet_NaN())(), std::invalid_argument);
  EXPECT_THROW(of(std::numeric_limits<double>::infinity())(), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
