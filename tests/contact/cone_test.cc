#include <patchgrip/contact/cone.h>

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

#include <patchgrip/contact/power_profile.h>
#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/contact/profile_errors.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

static_assert(Profile<Cone>);

TEST(Cone, AgreesWithTheTable) {
  const auto rows = contact_rows("cone_inverse");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto contact = AxisymmetricContact<Cone>::under_force(Cone::of_slope(row.input("slope")), row.input("F_N"),
                                                                row.input("E_star"));
    EXPECT_LE(units_of_rounding(contact.radius(), row.output("a_K")), 3);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 4);
    EXPECT_LE(units_of_rounding(contact.stiffness(), row.output("stiffness")), 4);
    EXPECT_LE(units_of_rounding(contact.pressure(row.input("rho") * contact.radius()), row.output("p_at_rho")), 6);
    EXPECT_LE(
        units_of_rounding(contact.displacement(row.input("rho_out") * contact.radius()), row.output("u_z_at_rho_out")),
        8);
  }
}

TEST(Cone, StatedErrorsHold) {
  std::mt19937_64 engine(431);
  patchgrip::testing::WorstErrors worst;
  for (int i = 0; i < cases(3000); ++i) {
    const auto profile = Cone::of_slope(log_uniform(engine, 1e-9, 1e3));
    const double a = log_uniform(engine, 1e-12, 1e3);
    const double inside = i % 2 == 0 ? a * log_uniform(engine, 1e-12, 1) : a * (1 - log_uniform(engine, 1e-15, 1));
    const double beyond = i % 3 == 0 ? uniform(engine, 0, 2) : log_uniform(engine, 1e-15, 1e9);
    worst.of_functions(profile, a, inside, a * (1 + beyond));
    const double f = log_uniform(engine, 1e-30, 1e30);
    const double d = log_uniform(engine, 1e-30, 1e30);
    worst.of_inversions(profile, f, profile.radius_of_force(Exact(f)), d, profile.radius_of_approach(Exact(d)));
  }
  worst.expect_within_stated();
}

TEST(Cone, IsThePowerProfileOfExponentOne) {
  const auto cone = Cone::of_slope(0.3);
  const auto power = PowerProfile::of_coefficient(0.3, 1);
  const double a = 0.7;
  EXPECT_NEAR(cone.force(a) / power.force(a), 1, 1e-15);
  for (const double rho : {1e-9, 0.3, 0.7, 0.9999}) {
    EXPECT_NEAR(cone.pressure(rho * a, a) / power.pressure(rho * a, a), 1, 1e-14);
  }
  for (const double rho : {1.0001, 1.3, 1.5, 1e4}) {
    EXPECT_NEAR(cone.displacement(rho * a, a) / power.displacement(rho * a, a), 1, 1e-14);
  }
}

// The mean pressure of a sharp tip does not depend on the load: that is what makes it a hardness.
RC_GTEST_PROP(Cone, MeanPressureIsIndependentOfTheLoad, ()) {
  const double force = *rc::gen::map(rc::gen::inRange(-90, 90), [](int i) { return std::pow(10, 0.1 * i); });
  const auto contact = AxisymmetricContact<Cone>::under_force(Cone::of_slope(0.2), force, 7e10);
  RC_ASSERT(std::abs(contact.mean_pressure() / (0.2 * 7e10 / 2) - 1) < 2e-15);
}

TEST(Cone, PressureIsInfiniteAtTheTip) {
  EXPECT_EQ(Cone::of_slope(1).pressure(0., 1.), std::numeric_limits<double>::infinity());
  const auto contact = AxisymmetricContact<Cone>::under_force(Cone::of_slope(1), 1, 1);
  EXPECT_EQ(contact.pressure(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(contact.pressure_error(0), std::numeric_limits<double>::infinity());
}

TEST(Cone, OutOfRangeSlopeIsNamed) {
  EXPECT_THAT([] { Cone::of_slope(0); },
              ::testing::ThrowsMessage<std::invalid_argument>("slope = 0 is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
