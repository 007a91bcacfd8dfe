#include <patchgrip/contact/hertz_axis_stress.h>

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

double drawn_poisson_ratio(std::mt19937_64& engine, int i) {
  if (i % 4 == 0) return 0.5;
  if (i % 4 == 1) return -1 + log_uniform(engine, 1e-12, 1);
  return uniform(engine, -0.999, 0.5);
}

TEST(HertzAxisStress, AgreesWithTheTable) {
  const auto rows = contact_rows("hertz_axis_stress");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto stress = HertzAxisStress::of(row.input("p0"), row.input("a"), row.input("nu"));
    EXPECT_LE(units_of_rounding(stress.axial(row.input("z")), row.output("sigma_z")), 4);
    EXPECT_LE(units_of_rounding(stress.radial(row.input("z")), row.output("sigma_r")), 8);
    EXPECT_LE(units_of_rounding(stress.shear(row.input("z")), row.output("tau_max_at_z")), 8);
    EXPECT_LE(units_of_rounding(stress.depth_of_max_shear(), row.output("z_of_max_tau")), 8);
    EXPECT_LE(units_of_rounding(stress.max_shear(), row.output("max_tau")), 8);
  }
}

TEST(HertzAxisStress, StatedErrorsHold) {
  std::mt19937_64 engine(435);
  double axial = 0, radial = 0, shear = 0;
  for (int i = 0; i < cases(2000); ++i) {
    const double a = log_uniform(engine, 1e-6, 1e3);
    const auto stress = HertzAxisStress::of(1, a, drawn_poisson_ratio(engine, i));
    const double z = a * log_uniform(engine, 1e-9, 1e9);
    const double w = 1 / (1 + (z / a) * (z / a));
    axial = std::max(axial, units_of_rounding(stress.axial(z), stress.axial(Exact(z))));
    radial = std::max(radial, static_cast<double>(abs(stress.radial(z) - stress.radial(Exact(z)))) * 0x1p53);
    const Exact tau = stress.shear(Exact(z));
    const double allowed = 12 * static_cast<double>(tau) + 2 * w;
    shear = std::max(shear, static_cast<double>(abs(stress.shear(z) - tau)) * 0x1p53 / allowed);
  }
  RecordProperty("axial", std::to_string(axial));
  RecordProperty("radial", std::to_string(radial));
  RecordProperty("shear", std::to_string(shear));
  EXPECT_LE(axial, 4);
  EXPECT_LE(radial, 8);
  EXPECT_LE(shear, 1);
}

// The three stresses are one formula: tau = (sigma_r - sigma_z) / 2, in fifty digits.
TEST(HertzAxisStress, ShearIsHalfTheDifference) {
  for (const double nu : {-0.9, 0., 0.3, 0.5}) {
    const auto stress = HertzAxisStress::of(2, 3, nu);
    for (const double z : {1e-6, 0.1, 2.9, 3.1, 50.}) {
      const Exact half = (stress.radial(Exact(z)) - stress.axial(Exact(z))) / 2;
      EXPECT_LE(abs(half / stress.shear(Exact(z)) - 1), 1e-30);
    }
  }
}

TEST(HertzAxisStress, DepthOfTheLargestShearIsGoodToItsUnits) {
  std::mt19937_64 engine(436);
  double depth = 0, peak = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double nu = drawn_poisson_ratio(engine, i);
    const auto stress = HertzAxisStress::of(1, 1, nu);
    const auto condition = [&](const Exact& s) -> Exact {
      return (1 + Exact(nu)) * (atan(1 / s) - s / (1 + s * s)) - 3 * s / pow(1 + s * s, 2);
    };
    Exact s0 = stress.depth_of_max_shear();
    Exact s1 = s0 * (1 + Exact(1e-9));
    for (int k = 0; k < 6 && condition(s1) != condition(s0); ++k) {
      const Exact s2 = s1 - condition(s1) * (s1 - s0) / (condition(s1) - condition(s0));
      s0 = s1;
      s1 = s2;
    }
    depth = std::max(depth, units_of_rounding(stress.depth_of_max_shear(), s1));
    peak = std::max(peak, units_of_rounding(stress.max_shear(), stress.shear(s1)));
  }
  RecordProperty("depth", std::to_string(depth));
  RecordProperty("peak", std::to_string(peak));
  EXPECT_LE(depth, 12);
  EXPECT_LE(peak, 8);
}

RC_GTEST_PROP(HertzAxisStress, NoDepthShearsMore, ()) {
  const double nu = *rc::gen::map(rc::gen::inRange(-999, 501), [](int i) { return 1e-3 * i; });
  const double z = *rc::gen::map(rc::gen::inRange(0, 5000), [](int i) { return 1e-3 * i; });
  const auto stress = HertzAxisStress::of(1, 1, nu);
  RC_ASSERT(stress.shear(z) <= stress.max_shear() * (1 + 1e-15));
}

TEST(HertzAxisStress, SurfaceIsUnderThePeakPressure) {
  const auto stress = HertzAxisStress::of(1e5, 0.003, 0.3);
  EXPECT_EQ(stress.axial(0.), -1e5);
  EXPECT_DOUBLE_EQ(stress.radial(0.), -1e5 * 0.8);  // (1 + 2 nu) / 2
  EXPECT_DOUBLE_EQ(stress.shear(0.), 1e4);
}

TEST(HertzAxisStress, OutOfRangeParametersAreNamed) {
  EXPECT_THAT([] { HertzAxisStress::of(0, 1, 0.3); },
              refused("peak_pressure = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { HertzAxisStress::of(1, -1, 0.3); },
              refused("contact_radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { HertzAxisStress::of(1, 1, 0.51); },
              refused("poisson_ratio = 0.51 is not allowed: must lie in (-1, 0.5]"));
}

}  // namespace
}  // namespace patchgrip::contact
