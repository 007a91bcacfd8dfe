#include <patchgrip/contact/relative_radii.h>

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

#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

struct ExactRadii {
  Exact small, large, one_minus_ratio, angle;
  double condition;  // of det
  double roundness;  // (|dp| + |dm|) / D
};

// The 2x2 matrix of the gap, by its definition.
ExactRadii exact_radii(const PrincipalRadii& p, const PrincipalRadii& m, double alpha) {
  const auto curvature = [](double radius) { return radius == infinity ? Exact(0) : 1 / Exact(radius); };
  const Exact k1p = curvature(p.R1), k2p = curvature(p.R2), k1m = curvature(m.R1), k2m = curvature(m.R2);
  const Exact c = cos(Exact(alpha)), s = sin(Exact(alpha));
  const Exact xx = k1p + k1m * c * c + k2m * s * s, yy = k2p + k1m * s * s + k2m * c * c, xy = (k1m - k2m) * c * s;
  const Exact S = xx + yy, D = sqrt((xx - yy) * (xx - yy) + 4 * xy * xy), det = xx * yy - xy * xy;
  const Exact terms = abs((k1p + k1m) * (k2p + k2m)) * c * c + abs((k1p + k2m) * (k2p + k1m)) * s * s;
  return {2 / (S + D),
          (S + D) / (2 * det),
          2 * D / (S + D),
          atan2(2 * xy, xx - yy) / 2,
          static_cast<double>(terms / abs(det)),
          D == 0 ? 0 : static_cast<double>((abs(k1p - k2p) + abs(k1m - k2m)) / D)};
}

TEST(RelativeRadii, AgreeWithTheTable) {
  const auto rows = contact_rows("relative_radii");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const auto radii = RelativeRadii::of_bodies({row.input("R1p"), row.input("R2p")},
                                                {row.input("R1m"), row.input("R2m")}, row.input("alpha"));
    EXPECT_LE(units_of_rounding(radii.small, row.output("R_small")), 2);
    EXPECT_LE(units_of_rounding(radii.large, row.output("R_large")), 2);
  }
}

TEST(RelativeRadii, HoldTheirBound) {
  std::mt19937_64 engine(20060120);
  double worst = 0;
  int refused = 0;
  const int count = cases(4000);
  for (int i = 0; i < count; ++i) {
    const auto radius = [&] {
      if (i % 7 == 0) return infinity;
      const double size = log_uniform(engine, i % 2 == 0 ? 1e-3 : 1e-12, i % 2 == 0 ? 1 : 1e12);
      return uniform(engine, 0, 1) < 0.2 ? -size : size;
    };
    const PrincipalRadii p{radius(), log_uniform(engine, 1e-6, 1e6)}, m{radius(), radius()};
    const double alpha = i % 3 == 0 ? log_uniform(engine, 1e-12, 1) : uniform(engine, -4, 4);
    const ExactRadii exact = exact_radii(p, m, alpha);
    if (!(exact.large > 0 && exact.small > 0 && isfinite(exact.large))) {
      EXPECT_THROW(RelativeRadii::of_bodies(p, m, alpha), std::invalid_argument);
      ++refused;
      continue;
    }
    const auto radii = RelativeRadii::of_bodies(p, m, alpha);
    EXPECT_NEAR(radii.radius_units / (1.01 + 0x1p-9 * exact.condition), 1, 1e-6);
    worst =
        std::max({worst, units_of_rounding(radii.small, exact.small) / 1.01,
                  units_of_rounding(radii.large, exact.large) / radii.radius_units,
                  units_of_rounding(radii.one_minus_ratio, exact.one_minus_ratio) / (1.01 + 0x1p-9 * exact.roundness)});
    const double turn = std::remainder(static_cast<double>(radii.angle_a - exact.angle) - pi / 2, pi);
    EXPECT_LE(std::abs(turn), 1e-15 + 1e-18 * exact.roundness);
    EXPECT_TRUE(radii.angle_a >= -pi / 2 && radii.angle_a <= pi / 2);
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
  EXPECT_LE(worst, 1);
  EXPECT_GT(refused, count / 50);
  EXPECT_LT(refused, count * 2 / 3);
}

rc::Gen<double> positive_radius() {
  return rc::gen::map(rc::gen::inRange(-3000, 3000), [](int i) { return std::pow(10, 1e-3 * i); });
}

RC_GTEST_PROP(RelativeRadii, DoNotDependOnWhichBodyIsNamedFirst, ()) {
  const PrincipalRadii p{*positive_radius(), *positive_radius()}, m{*positive_radius(), *positive_radius()};
  const double alpha = 1e-3 * *rc::gen::inRange(-1570, 1571);
  const auto one = RelativeRadii::of_bodies(p, m, alpha);
  const auto other = RelativeRadii::of_bodies(m, p, -alpha);
  RC_ASSERT(std::abs(one.small / other.small - 1) < 4e-16);
  RC_ASSERT(std::abs(one.large / other.large - 1) < 4e-16);
  // The same line in space: seen from R1m it lies alpha further on.
  if (one.one_minus_ratio > 1e-6) RC_ASSERT(std::abs(std::remainder(one.angle_a - alpha - other.angle_a, pi)) < 1e-9);
}

RC_GTEST_PROP(RelativeRadii, ExchangeOfTheAxesIsAQuarterTurn, ()) {
  const PrincipalRadii p{*positive_radius(), *positive_radius()}, m{*positive_radius(), *positive_radius()};
  const double alpha = 1e-3 * *rc::gen::inRange(-1570, 1571);
  const auto one = RelativeRadii::of_bodies(p, m, alpha);
  const auto turned = RelativeRadii::of_bodies(p, {m.R2, m.R1}, alpha + pi / 2);
  RC_ASSERT(std::abs(one.small / turned.small - 1) < 1e-12);
  RC_ASSERT(std::abs(one.large / turned.large - 1) < 1e-12);
}

RC_GTEST_PROP(RelativeRadii, ScaleWithTheBodies, ()) {
  const PrincipalRadii p{*positive_radius(), *positive_radius()}, m{*positive_radius(), *positive_radius()};
  const double alpha = 1e-3 * *rc::gen::inRange(-1570, 1571);
  const auto one = RelativeRadii::of_bodies(p, m, alpha);
  const auto larger = RelativeRadii::of_bodies({4 * p.R1, 4 * p.R2}, {4 * m.R1, 4 * m.R2}, alpha);
  RC_ASSERT(larger.small == 4 * one.small);
  RC_ASSERT(larger.large == 4 * one.large);
  RC_ASSERT(larger.one_minus_ratio == one.one_minus_ratio);
}

RC_GTEST_PROP(RelativeRadii, OfTwoSpheresAreThoseOfTheCircle, ()) {
  const double first = *positive_radius(), second = *positive_radius();
  const auto radii = RelativeRadii::of_bodies({first, first}, {second, second}, 0.4);
  RC_ASSERT(std::abs(radii.small / relative_radius(first, second) - 1) < 3e-16);
  RC_ASSERT(radii.large == radii.small);
  RC_ASSERT(radii.one_minus_ratio == 0);
}

TEST(RelativeRadii, OfCrossedCylindersAreTheirOwn) {
  const auto radii = RelativeRadii::of_bodies({0.01, infinity}, {0.04, infinity}, pi / 2);
  EXPECT_DOUBLE_EQ(radii.small, 0.01);
  EXPECT_DOUBLE_EQ(radii.large, 0.04);
  EXPECT_DOUBLE_EQ(std::abs(radii.angle_a), pi / 2);
}

TEST(RelativeRadii, BodiesThatDoNotTouchInAPointAreRefused) {
  EXPECT_THROW(RelativeRadii::of_bodies({0.01, infinity}, {0.04, infinity}, 0), std::invalid_argument);  // a line
  EXPECT_THROW(RelativeRadii::of_bodies({infinity, infinity}, {infinity, infinity}, 0), std::invalid_argument);
  EXPECT_THROW(RelativeRadii::of_bodies({0.02, 0.02}, {-0.01, 1}, 0),
               std::invalid_argument);  // too wide for its groove
  EXPECT_THROW(RelativeRadii::of_bodies({-1, -1}, {-1, -1}, 0), std::invalid_argument);
}

TEST(RelativeRadii, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  const std::string rule =
      " is not allowed: must be positive (infinite for a plane), or negative and finite for a hollow";
  EXPECT_THAT([] { RelativeRadii::of_bodies({1, 0}, {1, 1}, 0); }, refused("R2p = 0" + rule));
  EXPECT_THAT([] { RelativeRadii::of_bodies({1, 1}, {-infinity, 1}, 0); }, refused("R1m = -inf" + rule));
  EXPECT_THAT(
      [] {
        RelativeRadii::of_bodies({1, 1}, {1, 1}, infinity);
      },
      refused("alpha = inf is not allowed: must be finite"));
  EXPECT_THAT([] { RelativeRadii::of(2, 1); }, refused("R_small = 2 is not allowed: must not exceed R_large"));
  EXPECT_THAT([] { RelativeRadii::of_one_minus_ratio(0.7, 1); },
              refused("one_minus_ratio = 0.7 is not allowed: must lie in [0, 0.5]"));
}

}  // namespace
}  // namespace patchgrip::contact
