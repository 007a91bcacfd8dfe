#include <patchgrip/contact/power_profile.h>

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

static_assert(Profile<PowerProfile>);

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

TEST(PowerProfile, AgreesWithTheTable) {
  const auto rows = contact_rows("power_profile_sneddon");
  ASSERT_EQ(rows.size(), 5U);
  for (const auto& row : rows) {
    const auto profile = PowerProfile::of_coefficient(row.input("A"), row.input("m"));
    const auto contact = AxisymmetricContact<PowerProfile>::at_radius(profile, row.input("a"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(contact.force(), row.output("F_N")), 10);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 10);
    EXPECT_LE(units_of_rounding(contact.pressure(row.input("r")), row.output("p_at_r")), 10);
  }
}

TEST(PowerProfile, EvenPowersAreThoseOfShtaerman) {
  const auto rows = contact_rows("steuermann_414");
  ASSERT_EQ(rows.size(), 7U);
  for (const auto& row : rows) {
    const auto profile = PowerProfile::through(row.input("c"), row.input("R"), 2 * row.input("n"));
    const auto contact = AxisymmetricContact<PowerProfile>::at_radius(profile, row.input("a_K"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(contact.force(), row.output("F_N")), 40);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 40);
    EXPECT_LE(units_of_rounding(contact.pressure(0), row.output("p_at_0")), 40);
    EXPECT_LE(units_of_rounding(contact.pressure(row.input("r")), row.output("p_at_r")), 200);
  }
}

TEST(PowerProfile, RadiusOfAForceAgreesWithTheTable) {
  const auto rows = contact_rows("power_profile_inverse");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto profile = PowerProfile::of_coefficient(row.input("A"), row.input("m"));
    const auto contact = AxisymmetricContact<PowerProfile>::under_force(profile, row.input("F_N"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(contact.radius(), row.output("a_K")), 4);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 20);
    EXPECT_LE(units_of_rounding(contact.stiffness(), row.output("stiffness")), 4);
    const double r = row.input("r_out_over_a") * contact.radius();
    EXPECT_LE(units_of_rounding(contact.displacement(r), row.output("u_z_at_r_out")), 30);
  }
}

struct Draw {
  PowerProfile profile;
  double a;
};

Draw draw(std::mt19937_64& engine) {
  const double m = std::min(log_uniform(engine, 1e-3, 1e3), 1000.);
  const double exponent = uniform(engine, 0, 1) < 0.3 ? std::ceil(m) : m;
  const double length = log_uniform(engine, 1e-9, 1e6);
  const double ratio = std::exp(uniform(engine, -200, 200) / std::max(exponent, 1.));
  return {PowerProfile::through(log_uniform(engine, 1e-30, 1e30), length, exponent), ratio * length};
}

TEST(PowerProfile, StatedErrorsHold) {
  std::mt19937_64 engine(411);
  double approach = 0, force = 0, pressure = 0, displacement = 0, radius = 0, exchange = 0;
  for (int i = 0; i < cases(540); ++i) {
    const auto [profile, a] = draw(engine);
    const ProfileErrors e = profile.errors();
    const Exact exact(a);
    const Exact delta = profile.approach(exact);
    const Exact load = profile.force(exact);
    approach = std::max(approach, units_of_rounding(profile.approach(a), delta) / e.approach);
    force = std::max(force, units_of_rounding(profile.force(a), load) / e.force);

    double inside = i % 2 == 0 ? a * uniform(engine, 0, 1) : a * (1 - log_uniform(engine, 1e-15, 1));
    if (i % 3 == 0) inside = a * log_uniform(engine, 1e-200, 1);
    if (inside > 0) {
      const Exact p = profile.pressure(Exact(inside), exact);
      pressure = std::max(pressure, units_of_rounding(profile.pressure(inside, a), p) / e.pressure);
    }
    const double outside = a * (1 + (i % 2 == 0 ? log_uniform(engine, 1e-15, 1e6) : uniform(engine, 0, 1)));
    if (i % 3 == 0 && outside > a) {
      const Exact u = profile.displacement(Exact(outside), exact);
      displacement = std::max(displacement, units_of_rounding(profile.displacement(outside, a), u) / e.displacement);
    }
    const double f = static_cast<double>(load);
    const double d = static_cast<double>(delta);
    const Exact a_of_force = exact * pow(Exact(f) / load, 1 / (Exact(profile.exponent()) + 1));
    const Exact a_of_approach = exact * pow(Exact(d) / delta, 1 / Exact(profile.exponent()));
    radius = std::max({radius, units_of_rounding(profile.radius_of_force(f), a_of_force) / e.radius,
                       units_of_rounding(profile.radius_of_approach(d), a_of_approach) / e.radius});
    using Contact = AxisymmetricContact<PowerProfile>;
    const auto loaded = Contact::under_force(profile, f, 1);
    const auto moved = Contact::at_approach(profile, d, 1);
    exchange = std::max({exchange,
                         units_of_rounding(loaded.approach(), profile.approach(a_of_force)) * 0x1p-53 *
                             loaded.approach() / loaded.approach_error(),
                         units_of_rounding(moved.force(), profile.force(a_of_approach)) * 0x1p-53 * moved.force() /
                             moved.force_error()});
  }
  RecordProperty("approach", std::to_string(approach));
  RecordProperty("force", std::to_string(force));
  RecordProperty("pressure", std::to_string(pressure));
  RecordProperty("displacement", std::to_string(displacement));
  RecordProperty("radius", std::to_string(radius));
  RecordProperty("exchange", std::to_string(exchange));
  EXPECT_LE(approach, 1);
  EXPECT_LE(force, 1);
  EXPECT_LE(pressure, 1);
  EXPECT_LE(displacement, 1);
  EXPECT_LE(radius, 1);
  EXPECT_LE(exchange, 1);
}

TEST(PowerProfile, BluntTipsPressWithFiniteAndSharpOnesWithInfinitePeak) {
  EXPECT_GT(PowerProfile::of_coefficient(1, 1.5).pressure(0., 1.),
            PowerProfile::of_coefficient(1, 1.5).pressure(0.1, 1.));
  EXPECT_LT(PowerProfile::of_coefficient(1, 1.5).pressure(0., 1.), 10);
  EXPECT_EQ(PowerProfile::of_coefficient(1, 1).pressure(0., 1.), std::numeric_limits<double>::infinity());
  EXPECT_EQ(PowerProfile::of_coefficient(1, 0.5).pressure(0., 1.), std::numeric_limits<double>::infinity());
}

TEST(PowerProfile, OutOfRangeParametersAreNamed) {
  EXPECT_THAT([] { PowerProfile::through(0, 1, 2); },
              refused("height = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { PowerProfile::through(1, -1, 2); },
              refused("at_radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { PowerProfile::of_coefficient(1, 0); },
              refused("exponent = 0 is not allowed: must lie in (0, 1000]"));
  EXPECT_THAT([] { PowerProfile::of_coefficient(1, 1001); },
              refused("exponent = 1001 is not allowed: must lie in (0, 1000]"));
  EXPECT_THAT([] { PowerProfile::of_coefficient(std::nan(""), 1); },
              refused("coefficient = nan is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
