#include <patchgrip/contact/rotational_pressure.h>

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

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/factorials.hpp>

#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/power_sum.h>
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

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

TEST(RotationalPressure, AgreesWithTheTable) {
  const auto rows = contact_rows("rot_sym_pressure_413");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const auto family = RotationalPressure::of_curvature(static_cast<int>(row.input("n")), row.input("a_K"),
                                                         row.input("R"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(family.peak_pressure, row.output("p0")), 4);
    EXPECT_LE(units_of_rounding(family.pressure(row.input("r")), row.output("p_at_r")), 8);
    EXPECT_LE(units_of_rounding(family.force, row.output("F_N")), 4);
    EXPECT_LE(units_of_rounding(family.approach, row.output("delta")), 2);
    EXPECT_LE(units_of_rounding(family.height(row.input("r")), row.output("f_at_r")), 8);
  }
}

// Seed 4.13d, a sum that loses n ln 2 digits and so needs the fifty.
Exact seed_height(int n, const Exact& rho) {
  Exact sum = 0;
  Exact term = rho * rho / 2;  // k = 1
  for (int k = 1; k <= n; ++k) {
    sum += term;
    // (-1)^(k+1) (n-1)! (2k)! / (4^k (n-k)! k!^3) rho^(2k): ratio of k + 1 to k
    term *= -rho * rho * (n - k) * (2 * k + 1) * (2 * k + 2) / (4 * pow(Exact(k + 1), 3));
  }
  return sum;
}

// p_0 of E*, a, R = 1 by the factorials of 4.13a.
Exact seed_peak(int n) {
  Exact c = 2 / boost::math::constants::pi<Exact>();  // n = 1
  for (int k = 1; k < n; ++k) c *= Exact(4) * (k + 1) * k / ((2 * k + 1) * (2 * k + 2));
  return c;
}

TEST(RotationalPressure, StatedErrorsHold) {
  std::mt19937_64 engine(437);
  double peak = 0, force = 0, approach = 0, pressure = 0, height = 0;
  for (int i = 0; i < cases(1000); ++i) {
    const int n = 1 + static_cast<int>(log_uniform(engine, 1, 60)) - (i % 2);
    if (n < 1) continue;
    const double a = log_uniform(engine, 1e-6, 1e3);
    const double R = log_uniform(engine, 1e-6, 1e3);
    const double E = log_uniform(engine, 1e3, 1e12);
    const auto family = RotationalPressure::of_curvature(n, a, R, E);
    const Exact p0 = seed_peak(n) * E * a / R;
    peak = std::max(peak, units_of_rounding(family.peak_pressure, p0));
    const Exact pi = boost::math::constants::pi<Exact>();
    force = std::max(force, units_of_rounding(family.force, p0 * pi * a * a / (n + Exact(0.5))));
    approach = std::max(approach, units_of_rounding(family.approach, Exact(a) * a / (Exact(n) * R)));
    const double r = i % 3 == 0 ? a * (1 - log_uniform(engine, 1e-12, 1)) : a * uniform(engine, 0, 1);
    const Exact rho = Exact(r) / a;
    const Exact p = p0 * pow(1 - rho * rho, n - Exact(0.5));
    if (p > 1e-290 * p0) {
      pressure = std::max(pressure, units_of_rounding(family.pressure(r), p) / (8 + 3. * n));
    }
    if (r > 0) {
      height = std::max(height, units_of_rounding(family.height(r), Exact(a) * a / R * seed_height(n, rho)));
    }
  }
  RecordProperty("peak", std::to_string(peak));
  RecordProperty("force", std::to_string(force));
  RecordProperty("approach", std::to_string(approach));
  RecordProperty("pressure", std::to_string(pressure));
  RecordProperty("height", std::to_string(height));
  EXPECT_LE(peak, 4);
  EXPECT_LE(force, 6);
  EXPECT_LE(approach, 3);
  EXPECT_LE(pressure, 1);
  EXPECT_LE(height, 20);
}

// Many terms, against the same sum, all of it positive, in fifty digits.
TEST(RotationalPressure, HighPowersHoldTheErrorOfTheirHeight) {
  std::mt19937_64 engine(438);
  for (const int n : {100, 300, 1000}) {
    const auto family = RotationalPressure::of_curvature(n, 1, 1, 1);
    for (int i = 0; i < cases(20); ++i) {
      const double r = i % 2 == 0 ? log_uniform(engine, 1e-3, 1) : uniform(engine, 0, 1);
      Exact sum = 0;
      for (int j = 1; j <= n; ++j) {
        const Exact s = r * sin(boost::math::constants::pi<Exact>() * j / (n + 1));
        sum += 1 - pow(1 - s * s, n);
      }
      EXPECT_LE(units_of_rounding(family.height(r), sum / (Exact(n) * (n + 1))), 20) << n << ' ' << r;
    }
  }
}

TEST(RotationalPressure, FirstOfTheFamilyIsHertz) {
  const auto family = RotationalPressure::of_curvature(1, 0.3, 2, 5);
  const auto hertz = AxisymmetricContact<Paraboloid>::at_radius(Paraboloid::of_radius(2), 0.3, 5);
  EXPECT_DOUBLE_EQ(family.force, hertz.force());
  EXPECT_DOUBLE_EQ(family.approach, hertz.approach());
  for (const double r : {0., 0.1, 0.299}) {
    EXPECT_DOUBLE_EQ(family.pressure(r), hertz.pressure(r));
    EXPECT_DOUBLE_EQ(family.displacement(r), hertz.displacement(r));
  }
  for (const double r : {0.3001, 0.5, 20.}) {
    EXPECT_NEAR(family.displacement(r) / hertz.displacement(r), 1, 4e-15);
  }
}

// n = 2: f = r^2/(2R) - (3/16) ... , a paraboloid less a quartic: the pressures superpose with signs.
TEST(RotationalPressure, SecondOfTheFamilyIsAParaboloidLessAQuartic) {
  const double a = 0.7;
  const auto family = RotationalPressure::of_curvature(2, a, 1, 1);
  const auto two = PowerProfile::of_coefficient(0.5, 2);
  const auto four = PowerProfile::of_coefficient(0.1875 / (a * a), 4);
  EXPECT_NEAR(family.height(0.5), two.height(0.5) - four.height(0.5), 1e-16);
  EXPECT_NEAR(family.approach / (two.approach(a) - four.approach(a)), 1, 1e-15);
  EXPECT_NEAR(family.force / (two.force(a) - four.force(a)), 1, 2e-15);
  for (const double r : {0., 0.3, 0.6}) {
    EXPECT_NEAR(family.pressure(r) / (two.pressure(r, a) - four.pressure(r, a)), 1, 1e-14);
  }
  for (const double r : {0.71, 0.9, 5.}) {
    EXPECT_NEAR(family.displacement(r) / (two.displacement(r, a) - four.displacement(r, a)), 1, 1e-13);
  }
}

TEST(RotationalPressure, LooksLikeAPointLoadFromFarAway) {
  for (const int n : {1, 2, 5, 40}) {
    const auto family = RotationalPressure::of_curvature(n, 1, 1, 1);
    EXPECT_NEAR(family.displacement(1e6) * std::numbers::pi * 1e6 / family.force, 1, 1e-12);
  }
}

TEST(RotationalPressure, SurfaceIsContinuousAtTheRim) {
  for (const int n : {1, 2, 5, 40}) {
    const auto family = RotationalPressure::of_curvature(n, 1, 1, 1);
    EXPECT_NEAR(family.displacement(std::nextafter(1., 2.)) / family.displacement(1), 1, 1e-13);
  }
}

TEST(RotationalPressure, IsEvenInTheRadiusAndNanOfNan) {
  const auto family = RotationalPressure::of_curvature(3, 1, 1, 1);
  for (const double r : {0., 0.3, 1., 1.7}) {
    EXPECT_EQ(family.pressure(-r), family.pressure(r)) << r;
    EXPECT_EQ(family.displacement(-r), family.displacement(r)) << r;
  }
  EXPECT_TRUE(std::isnan(family.pressure(std::nan(""))));
  EXPECT_TRUE(std::isnan(family.displacement(std::nan(""))));
}

TEST(RotationalPressure, OutOfRangeParametersAreNamed) {
  EXPECT_THAT([] { RotationalPressure::of_curvature(0, 1, 1, 1); },
              refused("n = 0 is not allowed: must lie in [1, 1000]"));
  EXPECT_THAT([] { RotationalPressure::of_curvature(1, 0, 1, 1); },
              refused("contact_radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { RotationalPressure::of_curvature(1, 1, std::nan(""), 1); },
              refused("curvature_radius = nan is not allowed: must be positive and finite"));
  EXPECT_THAT([] { RotationalPressure::of_curvature(1, 1, 1, 1).height(1.5); },
              refused("r = 1.5 is not allowed: must lie in [0, 1]"));
}

}  // namespace
}  // namespace patchgrip::contact
