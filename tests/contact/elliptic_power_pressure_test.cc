#include <patchgrip/contact/elliptic_power_pressure.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/elliptic_pressure.h>
#include <patchgrip/contact/rotational_pressure.h>
#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

TEST(EllipticPowerPressure, AgreesWithTheTable) {
  const auto rows = contact_rows("elliptic_pressure");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const auto family = EllipticPowerPressure::of(static_cast<int>(row.input("n")), row.input("a"), row.input("b"),
                                                  row.input("p0"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(family.force, row.output("F_N")), 4);
    EXPECT_LE(units_of_rounding(family.approach, row.output("delta")), 8);
    EXPECT_LE(units_of_rounding(family.curvature_x, row.output("curvature_x")), 8);
    EXPECT_LE(units_of_rounding(family.curvature_y, row.output("curvature_y")), 8);
    EXPECT_LE(units_of_rounding(family.displacement(row.input("x"), row.input("y")), row.output("u_z_at_xy")), 12);
  }
}

double drawn_ratio(std::mt19937_64& engine, int i) {
  return i % 2 == 0 ? uniform(engine, 0.01, 1) : log_uniform(engine, 1e-9, 1);
}

TEST(EllipticPowerPressure, StatedErrorsOfTheConstantsHold) {
  std::mt19937_64 engine(438);
  double force = 0, approach = 0, curvature_x = 0, curvature_y = 0;
  for (int i = 0; i < cases(300); ++i) {
    const int n = 1 + i % 9;
    const double a = log_uniform(engine, 1e-6, 1e3);
    const double b = a * drawn_ratio(engine, i);
    const auto family = EllipticPowerPressure::of(n, a, b, 2, 3);
    Exact C = Exact(1) / 4;  // (2n-1)! / (4^n n! (n-1)!)
    for (int k = 1; k < n; ++k) C *= Exact(2 * k) * (2 * k + 1) / (Exact(4) * k * (k + 1));
    const Exact k2 = Exact(b) * b / (Exact(a) * a);
    const Exact zero = 0;
    const Exact one = 1;
    const Exact scale = 4 * C * 2 / 3;
    force =
        std::max(force, units_of_rounding(family.force, 4 * boost::math::constants::pi<Exact>() * a * b / (2 * n + 1)));
    approach =
        std::max(approach, units_of_rounding(family.approach, scale * b * boost::math::ellint_rf(zero, k2, one)));
    const Exact D = boost::math::ellint_rd(zero, k2, one) / 3;
    const Exact B = k2 * boost::math::ellint_rd(zero, one, k2) / 3;
    curvature_x = std::max(curvature_x, units_of_rounding(family.curvature_x, 2 * n * scale * b / a * D / a));
    curvature_y =
        std::max(curvature_y, units_of_rounding(family.curvature_y, 2 * n * scale * B / b) / (8 * std::log(4 * a / b)));
  }
  RecordProperty("force", std::to_string(force));
  RecordProperty("approach", std::to_string(approach));
  RecordProperty("curvature_x", std::to_string(curvature_x));
  RecordProperty("curvature_y", std::to_string(curvature_y));
  EXPECT_LE(force, 4);
  EXPECT_LE(approach, 8);
  EXPECT_LE(curvature_x, 8);
  EXPECT_LE(curvature_y, 1);
}

TEST(EllipticPowerPressure, StatedErrorOfThePressureHolds) {
  std::mt19937_64 engine(440);
  double worst = 0;
  for (int i = 0; i < cases(1000); ++i) {
    const int n = 1 + i % 9;
    const double b = drawn_ratio(engine, i);
    const double angle = uniform(engine, 0, 2 * std::numbers::pi);
    const double rho = std::sqrt(uniform(engine, 0, 0.98));
    const double x = rho * std::cos(angle);
    const double y = b * rho * std::sin(angle);
    const Exact w = 1 - Exact(x) * x - Exact(y) * y / (Exact(b) * b);
    const double p = EllipticPowerPressure::of(n, 1, b, 1, 1).pressure(x, y);
    worst = std::max(worst, units_of_rounding(p, pow(w, n - Exact(0.5))) / (16 + n));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

// n = 1 is a quadric in the whole ellipse, however slender.
TEST(EllipticPowerPressure, FirstOfTheFamilyIsHertz) {
  std::mt19937_64 engine(439);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double b = drawn_ratio(engine, i);
    const auto family = EllipticPowerPressure::of(1, 1, b, 1, 1);
    const auto hertz = EllipticPressure::of(1, b, 1);
    const double angle = uniform(engine, 0, 2 * std::numbers::pi);
    const double rho = std::sqrt(uniform(engine, 0, 0.9999));
    const double x = rho * std::cos(angle);
    const double y = b * rho * std::sin(angle);
    worst = std::max(worst, std::abs(family.displacement(x, y) / hertz.displacement(x, y, 1) - 1) * 0x1p53);
    EXPECT_NEAR(family.pressure(x, y), hertz.pressure(x, y), 1e-15);
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 17);
}

TEST(EllipticPowerPressure, OnACircleIsTheRotationalFamily) {
  for (const int n : {1, 2, 3, 7, 40}) {
    const auto round = RotationalPressure::of_curvature(n, 0.5, 2, 3);
    const auto family = EllipticPowerPressure::of(n, 0.5, 0.5, round.peak_pressure, 3);
    EXPECT_NEAR(family.force / round.force, 1, 1e-15);
    EXPECT_NEAR(family.approach / round.approach, 1, 2e-15);
    EXPECT_NEAR(family.curvature_x * 2, 1, 2e-15);
    EXPECT_NEAR(family.curvature_y * 2, 1, 2e-15);
    for (const double r : {0., 0.2, 0.45}) {
      EXPECT_NEAR(family.displacement(0.6 * r, 0.8 * r) / round.displacement(r), 1, (16 + n) * 0x1p-53);
      const double w = 1 - r * r / 0.25;  // 0.6 r and 0.8 r are rounded
      EXPECT_NEAR(family.pressure(0.6 * r, 0.8 * r) / round.pressure(r), 1, (16 + 4 * n / w) * 0x1p-53);
    }
  }
}

// The displacement at the middle is the approach; its second differences are the curvatures.
TEST(EllipticPowerPressure, MiddleHasTheStatedApproachAndCurvatures) {
  for (const double b : {1., 0.3, 1e-3}) {
    for (const int n : {1, 2, 5}) {
      const auto family = EllipticPowerPressure::of(n, 1, b, 1, 1);
      EXPECT_NEAR(family.displacement(0, 0) / family.approach, 1, 4e-15);
      const double h = 1e-3;
      const double in_x = 2 * (family.approach - family.displacement(h, 0)) / (h * h);
      const double in_y = 2 * (family.approach - family.displacement(0, h * b)) / (h * b * h * b);
      EXPECT_NEAR(in_x / family.curvature_x, 1, 1e-5 * n);
      EXPECT_NEAR(in_y / family.curvature_y, 1, 1e-5 * n);
    }
  }
}

// Table A row 5: for n > 1 the stamp is flatter than its quadric at the middle.
TEST(EllipticPowerPressure, HigherMembersAreNoQuadrics) {
  const double expected[] = {1, 0.940, 0.886};
  for (const int n : {1, 2, 3}) {
    const auto family = EllipticPowerPressure::of(n, 1.5, 1, 1, 1);
    const double f = family.approach - family.displacement(0.4, 0.3);
    const double quadric = family.curvature_x * 0.16 / 2 + family.curvature_y * 0.09 / 2;
    EXPECT_NEAR(f / quadric, expected[n - 1], 6e-4);
  }
}

TEST(EllipticPowerPressure, OutOfRangeParametersAreNamed) {
  EXPECT_THAT([] { EllipticPowerPressure::of(0, 1, 1, 1, 1); }, refused("n = 0 is not allowed: must lie in [1, 1000]"));
  EXPECT_THAT([] { EllipticPowerPressure::of(1, 1, 2, 1, 1); },
              refused("b = 2 is not allowed: must lie in [1e-09, 1]"));
  EXPECT_THAT([] { EllipticPowerPressure::of(1, 1, 1, -1, 1); },
              refused("peak_pressure = -1 is not allowed: must be positive and finite"));
  EXPECT_THROW(EllipticPowerPressure::of(1, 2, 1, 1, 1).displacement(0, 1.01), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
