#include <patchgrip/contact/adhesion/dmt.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>

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
using patchgrip::testing::units_of_rounding;

constexpr double pi = std::numbers::pi;

TEST(Dmt, AgreesWithTheTable) {
  const auto rows = contact_rows("dmt");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const Dmt dmt(AdhesiveSphere::of(row.input("R"), row.input("E_star"), row.input("w")));
    const auto at = dmt.under_force(row.input("F"));
    // At F = -0.006 N the pull-off is close: the rounding of w counts 190 times.
    const double condition = 2 * pi * row.input("w") * row.input("R") / (row.input("F") - dmt.pull_off().normal_force);
    EXPECT_LE(units_of_rounding(at.contact_radius, row.output("a_K")), 2 + condition);
    EXPECT_LE(units_of_rounding(at.approach, row.output("delta")), 2 + 2 * condition);
    EXPECT_LE(units_of_rounding(dmt.pull_off().normal_force, row.output("F_pulloff")), 4);
    EXPECT_LE(units_of_rounding(dmt.no_load().contact_radius, row.output("a_zero_load")), 4);
  }
}

TEST(Dmt, HoldsItsBoundAlsoNextToThePullOff) {
  std::mt19937_64 engine(20060220);
  const Exact exact_pi = boost::math::constants::pi<Exact>();
  double worst = 0;
  for (int i = 0; i < cases(2000); ++i) {
    const double R = log_uniform(engine, 1e-9, 1e3), E = log_uniform(engine, 1e3, 1e12);
    const double w = log_uniform(engine, 1e-4, 1e2);
    const double force =
        i % 2 == 0 ? log_uniform(engine, 1e-12, 1e12) : -2 * pi * w * R * (1 - log_uniform(engine, 1e-15, 1));
    const auto at = Dmt(AdhesiveSphere::of(R, E, w)).under_force(force);
    const Exact a = cbrt(3 * Exact(R) / (4 * Exact(E)) * (force + 2 * exact_pi * w * R));
    worst = std::max({worst, units_of_rounding(at.contact_radius, a), units_of_rounding(at.approach, a * a / R),
                      units_of_rounding(at.stiffness, 2 * E * a)});
    const auto held = Dmt(AdhesiveSphere::of(R, E, w)).at_approach(at.approach);
    const Exact hertz = 4 * Exact(E) * sqrt(Exact(R) * at.approach) * at.approach / 3, pull = 2 * exact_pi * w * R;
    worst =
        std::max(worst, static_cast<double>(abs(held.normal_force - (hertz - pull)) / std::max(hertz, pull)) * 0x1p53);
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.1);
}

RC_GTEST_PROP(Dmt, IsHertzUnderAnotherLoad, ()) {
  const auto magnitude = [] { return std::pow(10, 1e-3 * *rc::gen::inRange(-3000, 3000)); };
  const auto s = AdhesiveSphere::of(magnitude(), 1e6 * magnitude(), magnitude());
  const double pull = 2 * pi * s.work_of_adhesion * s.relative_radius;
  const double force = pull * (magnitude() - 0.99);
  const auto hertz = HertzCircle::under_force(force + pull, s.relative_radius, s.contact_modulus);
  const auto dmt = Dmt(s).under_force(force);
  RC_ASSERT(std::abs(dmt.contact_radius / hertz.radius - 1) < 1e-13);
  RC_ASSERT(std::abs(Dmt(s).pressure(dmt.contact_radius, 0) / hertz.peak_pressure - 1) < 1e-13);
}

TEST(Dmt, EndsWithoutContactAtThePullOff) {
  const Dmt dmt(AdhesiveSphere::of(0.01, 65798, 0.096));
  const double limit = dmt.pull_off().normal_force;
  EXPECT_EQ(dmt.pull_off().contact_radius, 0);
  EXPECT_LT(dmt.under_force(limit).contact_radius, 1e-7);  // the rounded limit is not the limit
  EXPECT_THROW(dmt.under_force(limit * (1 + 1e-15)), std::invalid_argument);
  EXPECT_THROW(dmt.under_force(std::nan("")), std::invalid_argument);
  EXPECT_THROW(dmt.at_approach(-1e-12), std::invalid_argument);
  EXPECT_THROW(dmt.pressure(1, 1.5), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
