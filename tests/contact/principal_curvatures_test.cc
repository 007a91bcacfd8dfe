#include <patchgrip/contact/principal_curvatures.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

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

double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

TEST(PrincipalCurvatures, OfAGraphAgreeWithTheTable) {
  const auto rows = contact_rows("principal_curvatures_graph");
  ASSERT_EQ(rows.size(), 1U);
  for (const auto& row : rows) {
    const auto k =
        curvatures_of_graph(row.input("fx"), row.input("fy"), row.input("fxx"), row.input("fxy"), row.input("fyy"));
    EXPECT_LE(units_of_rounding(k.k_max, row.output("k_max")), 2);
    EXPECT_LE(units_of_rounding(k.k_min, row.output("k_min")), 2);
    EXPECT_LE(units_of_rounding(k.radii().R1, row.output("R_small")), 3);
    EXPECT_LE(units_of_rounding(k.radii().R2, row.output("R_large")), 3);
  }
}

TEST(PrincipalCurvatures, OfAnEllipsoidAgreeWithTheTable) {
  const auto rows = contact_rows("ellipsoid_curvature");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto ellipsoid = Ellipsoid::of_axes(row.input("ax"), row.input("ay"), row.input("az"));
    const auto point = ellipsoid.point(row.input("u"), row.input("v"));
    EXPECT_LE(units_of_rounding(point[0], row.output("x")), 3);
    EXPECT_LE(units_of_rounding(point[1], row.output("y")), 3);
    EXPECT_LE(units_of_rounding(point[2], row.output("z")), 3);
    const auto k = ellipsoid.curvatures(row.input("u"), row.input("v"));
    EXPECT_LE(units_of_rounding(k.k_max, row.output("k_max")), 3);
    EXPECT_LE(units_of_rounding(k.k_min, row.output("k_min")), 3);
  }
}

// H and K as the table has them, in fifty digits.
TEST(PrincipalCurvatures, OfAGraphHoldTheirBound) {
  std::mt19937_64 engine(20060170);
  double worst = 0;
  for (int i = 0; i < cases(1500); ++i) {
    const auto either = [&](double lo, double hi) {
      return (uniform(engine, 0, 1) < 0.5 ? -1 : 1) * log_uniform(engine, lo, hi);
    };
    const double fx = either(1e-6, 1e2), fy = either(1e-6, 1e2);
    const double fxx = either(1e-9, 1e9), fyy = i % 2 == 0 ? either(1e-9, 1e9) : fxx * (1 + either(1e-14, 1));
    const double fxy = i % 3 == 0 ? std::sqrt(std::abs(fxx * fyy)) * (1 + either(1e-14, 1)) : either(1e-9, 1e9);
    const auto k = curvatures_of_graph(fx, fy, fxx, fxy, fyy);
    const Exact gx(fx), gy(fy), W = 1 + gx * gx + gy * gy;
    const Exact H = ((1 + gy * gy) * fxx - 2 * gx * gy * fxy + (1 + gx * gx) * fyy) / (2 * W * sqrt(W));
    const Exact K = (Exact(fxx) * fyy - Exact(fxy) * fxy) / (W * W);
    const Exact root = sqrt(H * H - K);
    worst = std::max({worst, units_of_rounding(k.k_max, H + root), units_of_rounding(k.k_min, H - root)});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.1);
}

TEST(PrincipalCurvatures, OfAnEllipsoidHoldTheirBound) {
  std::mt19937_64 engine(20060171);
  double worst = 0;
  for (int i = 0; i < cases(1000); ++i) {
    const double ax = log_uniform(engine, 1e-3, 1e3);
    const double ay = i % 2 == 0 ? log_uniform(engine, 1e-3, 1e3) : ax * (1 + log_uniform(engine, 1e-12, 1));
    const double az = i % 3 == 0 ? log_uniform(engine, 1e-3, 1e3) : ax * (1 + log_uniform(engine, 1e-12, 1));
    const double u = uniform(engine, -4, 4), v = uniform(engine, -1.6, 1.6);
    const auto k = Ellipsoid::of_axes(ax, ay, az).curvatures(u, v);
    const Exact a2 = Exact(ax) * ax, b2 = Exact(ay) * ay, c2 = Exact(az) * az;
    const Exact x = ax * cos(Exact(v)) * cos(Exact(u)), y = ay * cos(Exact(v)) * sin(Exact(u)), z = az * sin(Exact(v));
    const Exact P = x * x / (a2 * a2) + y * y / (b2 * b2) + z * z / (c2 * c2);
    const Exact K = 1 / (a2 * b2 * c2 * P * P);
    const Exact H = (a2 + b2 + c2 - x * x - y * y - z * z) / (2 * a2 * b2 * c2 * P * sqrt(P));
    const Exact root = sqrt(abs(H * H - K));
    worst = std::max({worst, units_of_rounding(k.k_max, H + root), units_of_rounding(k.k_min, K / (H + root))});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.1);
}

RC_GTEST_PROP(PrincipalCurvatures, DirectionsAndNormalAreAFrame, ()) {
  const auto number = [] { return 1e-2 * *rc::gen::inRange(-300, 301); };
  const auto k = curvatures_of_graph(number(), number(), number(), number(), number());
  for (const auto& v : {k.direction_of_k_max, k.direction_of_k_min, k.normal})
    RC_ASSERT(std::abs(dot(v, v) - 1) < 1e-15);
  RC_ASSERT(std::abs(dot(k.direction_of_k_max, k.direction_of_k_min)) < 1e-15);
  RC_ASSERT(std::abs(dot(k.direction_of_k_max, k.normal)) < 1e-15);
  RC_ASSERT(std::abs(dot(k.direction_of_k_min, k.normal)) < 1e-15);
}

// Along a tangent t of the graph the normal curvature is f_tt / (sqrt(W) |t|^2): extreme in the directions given.
RC_GTEST_PROP(PrincipalCurvatures, DirectionsTakeTheirCurvature, ()) {
  const auto number = [] { return 1e-2 * *rc::gen::inRange(-300, 301); };
  const double fx = number(), fy = number(), fxx = number(), fxy = number(), fyy = number();
  const auto k = curvatures_of_graph(fx, fy, fxx, fxy, fyy);
  const double scale = std::max(std::abs(k.k_max), std::abs(k.k_min));
  const auto along = [&](const Vector& t) {
    return (fxx * t[0] * t[0] + 2 * fxy * t[0] * t[1] + fyy * t[1] * t[1]) / std::sqrt(1 + fx * fx + fy * fy);
  };
  RC_ASSERT(std::abs(along(k.direction_of_k_max) - k.k_max) <= 1e-13 * scale);
  RC_ASSERT(std::abs(along(k.direction_of_k_min) - k.k_min) <= 1e-13 * scale);
}

RC_GTEST_PROP(PrincipalCurvatures, DoNotDependOnTheFrame, ()) {
  const auto number = [] { return 1e-2 * *rc::gen::inRange(-300, 301); };
  const double fx = number(), fy = number(), fxx = number(), fxy = number(), fyy = number();
  const double turn = number(), c = std::cos(turn), s = std::sin(turn);
  const auto k = curvatures_of_graph(fx, fy, fxx, fxy, fyy);
  const auto turned =
      curvatures_of_graph(c * fx + s * fy, c * fy - s * fx, c * c * fxx + 2 * c * s * fxy + s * s * fyy,
                          c * s * (fyy - fxx) + (c * c - s * s) * fxy, s * s * fxx - 2 * c * s * fxy + c * c * fyy);
  const double scale = std::max(std::abs(k.k_max), std::abs(k.k_min)) + 1e-300;
  RC_ASSERT(std::abs(k.k_max - turned.k_max) <= 1e-13 * scale);
  RC_ASSERT(std::abs(k.k_min - turned.k_min) <= 1e-13 * scale);
}

TEST(PrincipalCurvatures, OfASphereAreEqualEverywhere) {
  const auto sphere = Ellipsoid::of_axes(0.25, 0.25, 0.25);
  for (const double v : {-1.5, -0.3, 0., 0.8, 1.5707963267948966}) {
    const auto k = sphere.curvatures(0.7, v);
    EXPECT_DOUBLE_EQ(k.k_max, 4);
    EXPECT_DOUBLE_EQ(k.k_min, 4);
  }
}

TEST(PrincipalCurvatures, OfAPlaneAreZeroAndItsRadiiInfinite) {
  const auto k = curvatures_of_graph(0.3, -2, 0, 0, 0);
  EXPECT_EQ(k.k_max, 0);
  EXPECT_EQ(k.k_min, 0);
  EXPECT_EQ(k.radii().R1, std::numeric_limits<double>::infinity());
  EXPECT_EQ(k.radii().R2, std::numeric_limits<double>::infinity());
}

TEST(PrincipalCurvatures, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([] { curvatures_of_graph(std::nan(""), 0, 0, 0, 0); },
              refused("fx = nan is not allowed: must be finite"));
  EXPECT_THAT([] { Ellipsoid::of_axes(1, 0, 1); }, refused("ay = 0 is not allowed: must be positive and finite"));
  const auto sphere = Ellipsoid::of_axes(1, 1, 1);
  EXPECT_THAT([&] { sphere.curvatures(0, std::numeric_limits<double>::infinity()); },
              refused("v = inf is not allowed: must be finite"));
  EXPECT_THAT([&] { sphere.point(std::nan(""), 0); }, refused("u = nan is not allowed: must be finite"));
}

}  // namespace
}  // namespace patchgrip::contact
