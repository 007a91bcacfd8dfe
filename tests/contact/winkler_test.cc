#include <patchgrip/contact/fingertip/winkler.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

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

TEST(WinklerFingertip, AgreesWithTheTable) {
  const auto rows = contact_rows("winkler_theta0_0");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const auto tip = WinklerFingertip::of(row.input("R"), row.input("c"));
    EXPECT_LE(units_of_rounding(tip.contact_radius(row.input("delta")), row.output("a_K")), 3);
    EXPECT_LE(units_of_rounding(tip.normal_force(row.input("delta")), row.output("F_N")), 4);
    EXPECT_LE(units_of_rounding(tip.peak_pressure(row.input("delta")), row.output("p0")), 4);
  }
}

TEST(WinklerFingertip, HoldsItsBoundForEveryApproach) {
  std::mt19937_64 engine(20060280);
  const Exact pi = boost::math::constants::pi<Exact>();
  double worst = 0;
  for (int i = 0; i < cases(800); ++i) {
    const double R = log_uniform(engine, 1e-6, 1e3), c = log_uniform(engine, 1, 1e12);
    const double part = log_uniform(engine, 1e-14, 1);
    const double delta = i % 2 == 0 ? R * part : std::max(0.5 * R, R * (1 - part));
    if (!(delta < R)) continue;
    const auto tip = WinklerFingertip::of(R, c);
    const Exact d(delta), h = R - d;
    worst = std::max({worst, units_of_rounding(tip.contact_radius(delta), sqrt(d * (2 * Exact(R) - d))),
                      units_of_rounding(tip.peak_pressure(delta), c * d * h / (Exact(R) * R)),
                      units_of_rounding(tip.normal_force(delta), 2 * pi * c * h * (d - h * log(R / h)))});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.1);
}

// The seed's integral over the zone, by brute force: an independent route to both forms of the force.
double integrated(const WinklerFingertip& tip, double approach, double inclination) {
  const double h = tip.tip_radius - approach, a = tip.contact_radius(approach);
  boost::math::quadrature::tanh_sinh<double> over_x, over_y;
  const double middle = h * std::sin(inclination), reach = a * std::cos(inclination);
  return over_x.integrate(
      [&](double x) {
        const double u = (x - middle) / reach;
        const double width = a * std::sqrt(std::max(0., 1 - u * u));
        if (width == 0) return 0.;
        return 2 * over_y.integrate([&](double y) { return tip.inclined_pressure(approach, inclination, x, y); }, 0.,
                                    width);
      },
      middle - reach, middle + reach);
}

TEST(WinklerFingertip, ForceIsTheIntegralOfThePressure) {
  const auto tip = WinklerFingertip::of(0.02, 1e5);
  for (const double approach : {0.0005, 0.004, 0.012}) {
    EXPECT_NEAR(integrated(tip, approach, 0) / tip.normal_force(approach), 1, 1e-7);
    for (const double inclination : {0.1, 0.3}) {
      const auto inclined = tip.inclined_force(approach, inclination);
      EXPECT_NEAR(integrated(tip, approach, inclination) / inclined.normal_force, 1, 1e-7);
    }
  }
}

TEST(WinklerFingertip, UprightForceIsTheLimitOfTheInclinedOneWithinItsError) {
  std::mt19937_64 engine(20060281);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const auto tip = WinklerFingertip::of(log_uniform(engine, 1e-3, 1), log_uniform(engine, 1, 1e9));
    const double approach = tip.tip_radius * log_uniform(engine, 1e-12, 0.9);
    const auto force = tip.inclined_force(approach, 0);
    worst = std::max(worst, std::abs(force.normal_force - tip.normal_force(approach)) / force.force_error);
    EXPECT_LE(force.force_error, 1e-13 * force.normal_force);
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

RC_GTEST_PROP(WinklerFingertip, ForceRisesWithTheApproachLikeItsFourthRootLaw, ()) {
  const auto tip = WinklerFingertip::of(0.02, 1e5);
  const double approach = 0.02 * std::pow(10, -1e-3 * *rc::gen::inRange(3000, 12000));
  RC_ASSERT(tip.normal_force(1.01 * approach) > tip.normal_force(approach));
  RC_ASSERT(std::abs(tip.normal_force(approach) / (std::numbers::pi * 1e5 * approach * approach) - 1) <
            2 * approach / 0.02);
}

// A slight contact: springs are shortened by depth / cos theta and are R cos theta long, the zone is seen cos theta
// smaller: F -> pi c delta^2 / cos theta.
RC_GTEST_PROP(WinklerFingertip, InclinationOfASlightContactCountsByItsCosine, ()) {
  const auto tip = WinklerFingertip::of(0.02, 1e5);
  const double inclination = 1e-2 * *rc::gen::inRange(0, 120);
  const double approach = 2e-8;
  const double force = tip.inclined_force(approach, inclination).normal_force;
  RC_ASSERT(std::abs(force * std::cos(inclination) / tip.normal_force(approach) - 1) < 1e-4);
}

TEST(WinklerFingertip, PressureIsThatOfTheSeedAndEndsAtTheRim) {
  const auto tip = WinklerFingertip::of(0.02, 1e5);
  EXPECT_DOUBLE_EQ(tip.inclined_pressure(0.004, 0, 0, 0), tip.peak_pressure(0.004));
  const double a = tip.contact_radius(0.004);
  EXPECT_NEAR(tip.inclined_pressure(0.004, 0, a * (1 - 1e-9), 0), 0, 1);
  EXPECT_EQ(tip.inclined_pressure(0.004, 0, a * (1 + 1e-9), 0), 0);
  // Inclined by 0.4: g = 1 on the whole rim.
  const double h = 0.016, c = std::cos(0.4), s = std::sin(0.4);
  for (double psi = 0; psi < 6.3; psi += 0.5) {
    const auto at = [&](double reach) {
      return tip.inclined_pressure(0.004, 0.4, h * s + reach * a * c * std::cos(psi), reach * a * std::sin(psi));
    };
    EXPECT_EQ(at(1 + 1e-9), 0);
    EXPECT_GT(at(1 - 1e-9), 0);
  }
}

TEST(WinklerFingertip, OutOfRangeParametersAreRefused) {
  EXPECT_THROW(WinklerFingertip::of(0, 1), std::invalid_argument);
  EXPECT_THROW(WinklerFingertip::of(1, -1), std::invalid_argument);
  const auto tip = WinklerFingertip::of(1, 1);
  EXPECT_THAT([&] { tip.normal_force(1); },
              ::testing::ThrowsMessage<std::invalid_argument>("approach = 1 is not allowed: must lie in (0, 1)"));
  EXPECT_THROW(tip.contact_radius(0), std::invalid_argument);
  EXPECT_THROW(tip.inclined_force(0.5, -0.1), std::invalid_argument);
  EXPECT_THROW(tip.inclined_force(0.5, 0.6), std::invalid_argument);  // the rim would pass below the base
  EXPECT_THROW(tip.inclined_pressure(0.5, 0.1, std::nan(""), 0), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
