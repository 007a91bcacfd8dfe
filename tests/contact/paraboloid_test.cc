#include <patchgrip/contact/paraboloid.h>

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

#include <patchgrip/contact/hertz_circle.h>
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
using Contact = AxisymmetricContact<Paraboloid>;

static_assert(Profile<Paraboloid>);

TEST(Paraboloid, AgreesWithTheTable) {
  const auto rows = contact_rows("hertz_sphere");
  ASSERT_EQ(rows.size(), 1U);
  const auto& row = rows.front();
  const auto contact =
      Contact::at_approach(Paraboloid::of_radius(row.input("R")), row.input("delta"), row.input("E_star"));
  EXPECT_LE(units_of_rounding(contact.radius(), row.output("a_K")), 3);
  EXPECT_LE(units_of_rounding(contact.force(), row.output("F_N")), 4);
  EXPECT_LE(units_of_rounding(contact.pressure(0), row.output("p0")), 6);
  EXPECT_LE(units_of_rounding(contact.pressure(row.input("r")), row.output("p_at_r")), 6);
}

TEST(Paraboloid, FieldAroundAgreesWithTheTable) {
  const auto rows = contact_rows("hertz_sphere_field");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto contact =
        Contact::at_approach(Paraboloid::of_radius(row.input("R")), row.input("delta"), row.input("E_star"));
    const double r = row.input("r_out");
    EXPECT_LE(units_of_rounding(contact.displacement(r), row.output("u_z_at_r_out")), 8);
    EXPECT_LE(abs(Exact(contact.gap(r)) - row.output("gap_at_r_out")), contact.gap_error(r));
    EXPECT_LE(units_of_rounding(contact.stiffness(), row.output("stiffness")), 4);
  }
}

TEST(Paraboloid, StatedErrorsHold) {
  std::mt19937_64 engine(429);
  patchgrip::testing::WorstErrors worst;
  for (int i = 0; i < cases(3000); ++i) {
    const double R = log_uniform(engine, 1e-9, 1e9);
    const auto profile = Paraboloid::of_radius(R);
    const double a = R * log_uniform(engine, 1e-12, 1e3);
    const double inside = i % 2 == 0 ? a * uniform(engine, 0, 1) : a * (1 - log_uniform(engine, 1e-15, 1));
    const double beyond = i % 3 == 0 ? uniform(engine, 0, 2) : log_uniform(engine, 1e-15, 1e9);
    worst.of_functions(profile, a, inside, a * (1 + beyond));
    const double f = log_uniform(engine, 1e-30, 1e30);
    const double d = log_uniform(engine, 1e-30, 1e30);
    worst.of_inversions(profile, f, profile.radius_of_force(Exact(f)), d, profile.radius_of_approach(Exact(d)));
  }
  worst.expect_within_stated();
}

// With the radius known by the load alone, the pressure next to the rim is as uncertain as pressure_error says.
TEST(Paraboloid, BoundOfThePressureUnderALoadHolds) {
  std::mt19937_64 engine(430);
  double worst = 0;
  for (int i = 0; i < cases(3000); ++i) {
    const double R = log_uniform(engine, 1e-3, 1e3);
    const double E = log_uniform(engine, 1e3, 1e12);
    const double F = log_uniform(engine, 1e-12, 1e12);
    const auto contact = Contact::under_force(Paraboloid::of_radius(R), F, E);
    const Exact a = contact.profile().radius_of_force(Exact(F) / E);
    const double r = contact.radius() * (1 - log_uniform(engine, 1e-16, 1));
    const Exact exact = Exact(r) < a ? Exact(E) * contact.profile().pressure(Exact(r), a) : Exact(0);
    worst = std::max(worst, static_cast<double>(abs(Exact(contact.pressure(r)) - exact)) / contact.pressure_error(r));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

TEST(Paraboloid, IsThePowerProfileOfExponentTwo) {
  const auto paraboloid = Paraboloid::of_radius(0.25);
  const auto power = PowerProfile::of_coefficient(2, 2);
  for (const double a : {1e-6, 0.1, 3.}) {
    EXPECT_NEAR(paraboloid.force(a) / power.force(a), 1, 1e-15);
    EXPECT_NEAR(paraboloid.approach_slope(a) / power.approach_slope(a), 1, 1e-15);
    for (const double rho : {0., 0.3, 0.9999}) {
      EXPECT_NEAR(paraboloid.pressure(rho * a, a) / power.pressure(rho * a, a), 1, 1e-14);
    }
    for (const double rho : {1.0001, 1.3, 1.5, 1e4}) {
      EXPECT_NEAR(paraboloid.displacement(rho * a, a) / power.displacement(rho * a, a), 1, 1e-14);
    }
  }
}

TEST(Paraboloid, IsTheHertzCircle) {
  const auto circle = HertzCircle::under_force(3, 0.02, 66666);
  const auto contact = Contact::under_force(Paraboloid::of_radius(0.02), 3, 66666);
  EXPECT_NEAR(contact.radius() / circle.radius, 1, 4e-16);
  EXPECT_NEAR(contact.approach() / circle.approach, 1, 1e-15);
  EXPECT_NEAR(contact.pressure(0) / circle.peak_pressure, 1, 1e-15);
}

TEST(Paraboloid, OutOfRangeRadiusIsNamed) {
  EXPECT_THAT([] { Paraboloid::of_radius(-1); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "relative_radius = -1 is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
