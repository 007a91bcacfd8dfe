// The largest ratio of two support functions, against bodies whose ratio is known.
#include <patchgrip/friction/limit_surface/support_ratio.h>

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {
namespace {

// |(p vx, q vy, r w)|: the ellipsoid of these half axes.
SupportFunction ellipsoid(double p, double q, double r) {
  return [=](const Twist& v) -> SupportValue {
    const double size = std::sqrt(p * p * v.vx * v.vx + q * q * v.vy * v.vy + r * r * v.w * v.w);
    return {size, {p * p * v.vx / size, q * q * v.vy / size, r * r * v.w / size}, 1e-15};
  };
}

// A box of these half sides: its support function has kinks, at which any corner will do.
SupportFunction box(double p, double q, double r) {
  return [=](const Twist& v) -> SupportValue {
    const Wrench corner{std::copysign(p, v.vx), std::copysign(q, v.vy), std::copysign(r, v.w)};
    return {power(corner, v), corner, 1e-15};
  };
}

SupportFunction turned(const SupportFunction& h, double angle) {
  return [=](const Twist& v) -> SupportValue {
    const double c = std::cos(angle), s = std::sin(angle);
    const auto [value, t, error] = h({c * v.vx + s * v.vy, c * v.vy - s * v.vx, v.w});
    return {value, {c * t.fx - s * t.fy, s * t.fx + c * t.fy, t.m}, error};
  };
}

TEST(SupportRatio, OfEllipsoidsIsThatOfTheirAxes) {
  std::mt19937_64 engine(1);
  for (int i = 0; i < testing::cases(30); ++i) {
    const auto axis = [&] { return testing::log_uniform(engine, 0.5, 2); };
    const double p = axis(), q = axis(), r = axis(), x = axis(), y = axis(), z = axis();
    const double angle = testing::uniform(engine, -3, 3), tolerance = testing::log_uniform(engine, 1e-5, 1e-2);
    const double largest = std::max({p / x, q / y, r / z});
    const LargestRatio ratio =
        largest_ratio(turned(ellipsoid(p, q, r), angle), turned(ellipsoid(x, y, z), angle), tolerance);
    EXPECT_GE(ratio.bound, largest);
    EXPECT_LE(ratio.bound, largest + tolerance);
    EXPECT_LE(ratio.attained, largest * (1 + 1e-14));
    EXPECT_LE(ratio.bound - ratio.attained, tolerance);
  }
}

TEST(SupportRatio, OfABoxAndABallSeesTheCorners) {
  const double outside = largest_ratio(turned(box(1, 1, 1), 0.3), ellipsoid(1, 1, 1), 1e-4).bound;
  EXPECT_GE(outside, std::sqrt(3));
  EXPECT_LE(outside, std::sqrt(3) + 1e-4);
  const double inside = largest_ratio(ellipsoid(1, 1, 1), turned(box(1, 1, 1), 0.3), 1e-4).bound;
  EXPECT_GE(inside, 1);
  EXPECT_LE(inside, 1 + 1e-4);
}

TEST(SupportRatio, EndedEarlyItIsABoundStill) {
  const auto a = turned(box(1, 0.1, 1), 1), b = ellipsoid(1, 1, 0.2);
  const double largest = largest_ratio(a, b, 1e-5).bound;
  double before = largest_ratio(a, b, 1e-5, 10).bound;
  for (const int cones : {30, 100, 300, 1000}) {
    const auto [bound, attained] = largest_ratio(a, b, 1e-5, cones);
    EXPECT_GE(bound, largest - 1e-5);
    EXPECT_LE(attained, largest);
    if (cones < 1000) {
      EXPECT_GT(bound - attained, 1e-5);  // what the early end left open is told
    }
    EXPECT_LE(bound, before);
    before = bound;
  }
  EXPECT_LE(before, 1.01 * largest);
}

TEST(SupportRatio, CountsTheErrorsOfBothIn) {
  const auto vague = [](const SupportFunction& h, double error) {
    return [=](const Twist& v) {
      SupportValue at = h(v);
      at.error = error;
      return at;
    };
  };
  const auto [bound, attained] = largest_ratio(vague(ellipsoid(1, 1, 1), 0.02), vague(ellipsoid(1, 1, 1), 0.03), 1e-3);
  EXPECT_GE(bound, 1.02 * 1.03);
  EXPECT_LE(bound, 1.02 * 1.03 + 1.1e-3);
  EXPECT_LE(attained, 0.98 / 1.03);
  EXPECT_GE(attained, 0.98 / 1.03 - 1e-14);
}

TEST(GaugeSides, OfAModelOnBothSides) {
  const GaugeSides sides = gauge_sides(ellipsoid(1.25, 1, 0.8), ellipsoid(1, 1, 1));
  EXPECT_NEAR(sides.largest_excess, 0.25, 1e-5);  // a body of 0.8 asks for 1 / 0.8
  EXPECT_NEAR(sides.largest_deficit, 0.2, 1e-5);  // and one of 1.25 for 1 / 1.25
  const GaugeSides safe = sides.scaled(1.25);
  EXPECT_NEAR(safe.largest_deficit, 0, 1e-5);
  EXPECT_NEAR(safe.largest_excess, 0.5625, 2e-5);
  EXPECT_LE(sides.slack, 1e-5);
  EXPECT_EQ(safe.slack, 1.25 * sides.slack);
}

}  // namespace
}  // namespace patchgrip::friction
