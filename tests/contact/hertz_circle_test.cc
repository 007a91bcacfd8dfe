#include <patchgrip/contact/hertz_circle.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>

#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::units_of_rounding;

constexpr double infinity = std::numeric_limits<double>::infinity();

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

double log_uniform(std::mt19937_64& engine, double decades) {
  return std::pow(10, std::uniform_real_distribution<double>(-decades, decades)(engine));
}

rc::Gen<double> magnitude(int decades) {
  return rc::gen::map(rc::gen::inRange(-decades * 1000, decades * 1000), [](int i) { return std::pow(10, 1e-3 * i); });
}

TEST(HertzCircle, AgreesWithTheTable) {
  const auto rows = contact_rows("hertz_sphere_inverse");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const auto circle = HertzCircle::under_force(row.input("F_N"), row.input("R"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(circle.radius, row.output("a_K")), 2);
    EXPECT_LE(units_of_rounding(circle.approach, row.output("delta")), 3);
    EXPECT_LE(units_of_rounding(circle.peak_pressure, row.output("p0")), 3);
  }
}

TEST(HertzCircle, EveryResultIsRoundedOnce) {
  std::mt19937_64 engine(20060102);
  double worst = 0;
  for (int i = 0; i < 30000; ++i) {
    const double decades = i % 2 == 0 ? 9 : 60;
    const double force = log_uniform(engine, decades);
    const double curved = log_uniform(engine, decades);
    const double modulus = log_uniform(engine, decades);
    const auto circle = HertzCircle::under_force(force, curved, modulus);

    const Exact cube = 3 * Exact(force) * curved / (4 * Exact(modulus));
    const Exact radius = cbrt(cube);
    const Exact& pi = boost::math::constants::pi<Exact>();
    worst = std::max({worst, units_of_rounding(circle.radius, radius),
                      units_of_rounding(circle.approach, radius * radius / curved),
                      units_of_rounding(circle.peak_pressure, 3 * Exact(force) / (2 * pi * radius * radius))});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.01);
}

RC_GTEST_PROP(HertzCircle, RadiusGrowsWithTheCubeRootOfTheForce, ()) {
  const double force = *magnitude(9);
  const double modulus = *magnitude(9);
  const double curved = *magnitude(3);
  const auto circle = HertzCircle::under_force(force, curved, modulus);
  const auto eightfold = HertzCircle::under_force(8 * force, curved, modulus);
  RC_ASSERT(eightfold.radius == 2 * circle.radius);
  RC_ASSERT(eightfold.approach == 4 * circle.approach);
  RC_ASSERT(eightfold.peak_pressure == 2 * circle.peak_pressure);
}

RC_GTEST_PROP(HertzCircle, PressureCarriesTheForce, ()) {
  const double force = *magnitude(9);
  const auto circle = HertzCircle::under_force(force, *magnitude(3), *magnitude(9));
  const double carried = 2. / 3. * circle.peak_pressure * std::numbers::pi * circle.radius * circle.radius;
  RC_ASSERT(std::abs(carried / force - 1) < 1e-15);
}

// At equal load the true circle of a sphere is narrower than the paraboloid's: by (2/15)(a/R)^2 while that is small,
// and by a factor of three where Hertz would let the sphere sink in whole.
TEST(HertzCircle, IsTooWideForASphereThatSinksIn) {
  const auto rows = contact_rows("sphere_exact_inverse");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const double curved = row.input("R");
    const auto circle = HertzCircle::under_force(row.input("F_N"), curved, row.input("E_star"));
    const double ratio = circle.radius / curved;
    const double excess = static_cast<double>(1 - row.output("a_over_R") / Exact(ratio));
    EXPECT_GT(excess, 0);
    EXPECT_LE(excess, 2. / 15. * ratio * ratio * (1 + ratio * ratio));
    if (ratio < 0.6) {
      EXPECT_NEAR(excess, 2. / 15. * ratio * ratio, 0.2 * std::pow(ratio, 4) + 1e-15);
    }
  }
}

TEST(RelativeRadius, IsRoundedOnceAlsoInANearlyConformingSocket) {
  std::mt19937_64 engine(20060103);
  double worst = 0;
  for (int i = 0; i < 30000; ++i) {
    const double ball = log_uniform(engine, 140);
    const double other = i % 2 == 0 ? log_uniform(engine, 140) : -ball * (1 + log_uniform(engine, 7) * 1e-8);
    const Exact exact = Exact(ball) * other / (Exact(ball) + other);
    worst = std::max(worst, units_of_rounding(relative_radius(ball, other), exact));
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.01);
}

TEST(RelativeRadius, OfEqualSpheresIsHalf) { EXPECT_EQ(relative_radius(0.02, 0.02), 0.01); }

TEST(RelativeRadius, OnAPlaneIsThatOfTheSphere) {
  EXPECT_EQ(relative_radius(0.02, infinity), 0.02);
  EXPECT_EQ(relative_radius(infinity, 0.02), 0.02);
}

RC_GTEST_PROP(RelativeRadius, OfTwoSpheresIsSymmetricAndBelowBoth, ()) {
  const double first = *magnitude(6);
  const double second = *magnitude(6);
  const double relative = relative_radius(first, second);
  RC_ASSERT(relative == relative_radius(second, first));
  RC_ASSERT(relative <= std::min(first, second));
}

RC_GTEST_PROP(RelativeRadius, InASocketIsAboveThatOfTheBall, ()) {
  const double ball = *magnitude(6);
  const double socket = -ball * (1 + *magnitude(6));
  RC_ASSERT(relative_radius(ball, socket) >= ball);
}

TEST(RelativeRadius, BodiesThatCannotTouchInACircleAreRefused) {
  EXPECT_THROW(relative_radius(infinity, infinity), std::invalid_argument);
  EXPECT_THROW(relative_radius(1, -1), std::invalid_argument);
  EXPECT_THROW(relative_radius(1, -0.5), std::invalid_argument);
  EXPECT_THROW(relative_radius(-1, -2), std::invalid_argument);
  EXPECT_THROW(relative_radius(-1, infinity), std::invalid_argument);
}

TEST(RelativeRadius, OutOfRangeRadiiAreNamed) {
  const std::string rule =
      " is not allowed: must be positive (infinite for a plane), or negative and finite for a hollow";
  EXPECT_THAT([] { relative_radius(0, 1); }, refused("first_radius = 0" + rule));
  EXPECT_THAT([] { relative_radius(1, std::nan("")); }, refused("second_radius = nan" + rule));
  EXPECT_THAT([] { relative_radius(-infinity, 1); }, refused("first_radius = -inf" + rule));
}

TEST(HertzCircle, OutOfRangeParametersAreNamed) {
  const std::string rule = " is not allowed: must be positive and finite";
  EXPECT_THAT([] { HertzCircle::under_force(0, 1, 1); }, refused("normal_force = 0" + rule));
  EXPECT_THAT([] { HertzCircle::under_force(1, infinity, 1); }, refused("relative_radius = inf" + rule));
  EXPECT_THAT([] { HertzCircle::under_force(1, 1, std::nan("")); }, refused("contact_modulus = nan" + rule));
}

TEST(HertzCircle, ResultsBeyondTheRangeOfDoubleAreRefused) {
  const std::string rule = " is not allowed: must lie in [2.2250738585072014e-308, 1.7976931348623157e+308]";
  EXPECT_THAT([] { HertzCircle::under_force(1e-300, 1, 1e300); }, refused("approach = 0" + rule));
  EXPECT_THAT([] { HertzCircle::under_force(1e300, 1, 1e-300); }, refused("approach = inf" + rule));
  EXPECT_THAT([] { HertzCircle::under_force(1e300, 1e-300, 1e300); }, refused("peak_pressure = inf" + rule));
}

}  // namespace
}  // namespace patchgrip::contact
