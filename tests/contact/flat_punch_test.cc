#include <patchgrip/contact/flat_punch.h>

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

#include <patchgrip/contact/power_profile.h>
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

TEST(FlatPunch, AgreesWithTheTable) {
  const auto rows = contact_rows("flat_punch");
  ASSERT_EQ(rows.size(), 1U);
  const auto punch = FlatPunch::under_force(rows[0].input("R"), rows[0].input("F_N"), rows[0].input("E_star"));
  EXPECT_LE(units_of_rounding(punch.approach, rows[0].output("delta")), 2);
  EXPECT_LE(units_of_rounding(punch.pressure(rows[0].input("r")), rows[0].output("p_at_r")), 5);

  const auto fields = contact_rows("flat_punch_field");
  ASSERT_EQ(fields.size(), 1U);
  const auto& field = fields.front();
  const auto other = FlatPunch::under_force(field.input("R"), field.input("F_N"), field.input("E_star"));
  EXPECT_LE(units_of_rounding(other.displacement(field.input("r_out")), field.output("u_z_at_r_out")), 4);
  EXPECT_LE(units_of_rounding(other.stiffness(), field.output("stiffness")), 2);
  EXPECT_LE(units_of_rounding(other.strain_energy(), field.output("strain_energy")), 4);
}

TEST(FlatPunch, StatedErrorsHold) {
  std::mt19937_64 engine(433);
  double approach = 0, force = 0, pressure = 0, displacement = 0, energy = 0;
  const Exact pi = boost::math::constants::pi<Exact>();
  for (int i = 0; i < cases(3000); ++i) {
    const double a = log_uniform(engine, 1e-9, 1e9);
    const double F = log_uniform(engine, 1e-12, 1e12);
    const double E = log_uniform(engine, 1e-3, 1e12);
    const auto punch = FlatPunch::under_force(a, F, E);
    const Exact delta = Exact(F) / (2 * Exact(E) * a);
    approach = std::max(approach, units_of_rounding(punch.approach, delta));
    energy = std::max(energy, units_of_rounding(punch.strain_energy(), F * delta / 2));
    const double r = a * (1 - log_uniform(engine, 1e-16, 1));
    if (r < a) {
      const Exact p = Exact(F) / (2 * pi * a * sqrt((Exact(a) - r) * (Exact(a) + r)));
      pressure = std::max(pressure, units_of_rounding(punch.pressure(r), p));
    }
    const double out = a * (1 + (i % 2 == 0 ? log_uniform(engine, 1e-15, 1e9) : uniform(engine, 0, 1)));
    if (out > a) {
      displacement =
          std::max(displacement, units_of_rounding(punch.displacement(out), 2 * delta / pi * asin(Exact(a) / out)));
    }
    const auto moved = FlatPunch::at_approach(a, punch.approach, E);
    force = std::max(force, units_of_rounding(moved.force, 2 * Exact(E) * a * punch.approach));
  }
  for (const auto& [name, value] : {std::pair{"approach", approach},
                                    {"force", force},
                                    {"pressure", pressure},
                                    {"displacement", displacement},
                                    {"energy", energy}}) {
    RecordProperty(name, std::to_string(value));
  }
  EXPECT_LE(approach, 2);
  EXPECT_LE(force, 2);
  EXPECT_LE(pressure, 8);
  EXPECT_LE(displacement, 8);
  EXPECT_LE(energy, 4);
}

// Seed 4.1.1: the limit of r^(2n). The approach of a given load tends to F / (2 E* a) like 1/n.
TEST(FlatPunch, IsTheLimitOfHighPowers) {
  const auto punch = FlatPunch::under_force(1, 1, 1);
  for (const double m : {10., 100., 1000.}) {
    const auto power = AxisymmetricContact<PowerProfile>::under_force(PowerProfile::through(1, 1, m), 1, 1);
    EXPECT_NEAR(power.approach() * power.radius() / (punch.approach * punch.radius), 1 + 1 / m, 1e-12);
    EXPECT_NEAR(power.pressure(0.5 * power.radius()) * std::pow(power.radius(), 2) / punch.pressure(0.5), 1, 3 / m);
  }
}

TEST(FlatPunch, EdgeCarriesAnInfinitePressure) {
  const auto punch = FlatPunch::under_force(1, 1, 1);
  EXPECT_EQ(punch.pressure(1), std::numeric_limits<double>::infinity());
  EXPECT_EQ(punch.pressure(1.0001), 0);
  EXPECT_EQ(punch.displacement(1), punch.approach);
}

TEST(FlatPunch, IsEvenInTheRadiusAndNanOfNan) {
  const auto punch = FlatPunch::under_force(1, 1, 1);
  for (const double r : {0., 0.3, 1., 1.7}) {
    EXPECT_EQ(punch.pressure(-r), punch.pressure(r)) << r;
    EXPECT_EQ(punch.displacement(-r), punch.displacement(r)) << r;
  }
  EXPECT_TRUE(std::isnan(punch.pressure(std::nan(""))));
  EXPECT_TRUE(std::isnan(punch.displacement(std::nan(""))));
}

TEST(FlatPunch, OutOfRangeParametersAreNamed) {
  const std::string rule = " is not allowed: must be positive and finite";
  EXPECT_THAT([] { FlatPunch::under_force(0, 1, 1); }, refused("radius = 0" + rule));
  EXPECT_THAT([] { FlatPunch::under_force(1, -1, 1); }, refused("normal_force = -1" + rule));
  EXPECT_THAT([] { FlatPunch::at_approach(1, std::nan(""), 1); }, refused("approach = nan" + rule));
  EXPECT_THAT([] { FlatPunch::at_approach(1, 1, 0); }, refused("contact_modulus = 0" + rule));
}

}  // namespace
}  // namespace patchgrip::contact
