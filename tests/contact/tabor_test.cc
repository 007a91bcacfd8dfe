#include <patchgrip/contact/adhesion/tabor.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
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
using patchgrip::testing::units_of_rounding;

TEST(Tabor, AgreesWithTheTable) {
  const auto rows = contact_rows("tabor");
  ASSERT_EQ(rows.size(), 1U);
  for (const auto& row : rows) {
    const auto s = AdhesiveSphere::of(row.input("R"), row.input("E_star"), row.input("w"));
    const double sigma = lennard_jones_attraction(row.input("w"), row.input("z0"));
    EXPECT_LE(units_of_rounding(tabor_parameter(s, row.input("z0")), row.output("mu_T")), 4);
    EXPECT_LE(units_of_rounding(sigma, row.output("sigma0_LJ")), 4);
    EXPECT_LE(units_of_rounding(maugis_parameter(s, sigma), row.output("lam")), 4);
    EXPECT_LE(
        units_of_rounding(maugis_parameter(s, sigma) / tabor_parameter(s, row.input("z0")), row.output("lam_over_mu")),
        6);
    EXPECT_LE(units_of_rounding(dugdale_attraction(row.input("w"), row.input("z0")), row.output("sigma0_dugdale_z0")),
              4);
  }
}

TEST(Tabor, IsRoundedOnce) {
  std::mt19937_64 engine(20060230);
  const Exact pi = boost::math::constants::pi<Exact>();
  double worst = 0;
  for (int i = 0; i < cases(2000); ++i) {
    const double R = log_uniform(engine, 1e-9, 1e3), E = log_uniform(engine, 1e3, 1e12);
    const double w = log_uniform(engine, 1e-6, 1e2), z = log_uniform(engine, 1e-11, 1e-3);
    const auto s = AdhesiveSphere::of(R, E, w);
    const double sigma = lennard_jones_attraction(w, z);
    const Exact K = 4 * Exact(E) / 3;
    worst = std::max({worst, units_of_rounding(tabor_parameter(s, z), cbrt(R * pow(Exact(w) / E / z, 2) / z)),
                      units_of_rounding(sigma, 16 * Exact(w) / (9 * sqrt(Exact(3)) * z)),
                      units_of_rounding(maugis_parameter(s, sigma), 2 * sigma * cbrt(R / (pi * w * K * K))),
                      units_of_rounding(dugdale_attraction(w, z), Exact(w) / z)});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.01);
}

// The law (8w/3z0)[(z0/z)^3 - (z0/z)^9] has its peak where (z0/z)^6 = 1/3.
TEST(Tabor, AttractionIsThePeakOfLennardJones) {
  const double w = 0.05, z0 = 3e-10;
  const auto law = [&](double z) { return 8 * w / (3 * z0) * (std::pow(z0 / z, 3) - std::pow(z0 / z, 9)); };
  const double peak = z0 * std::pow(3, 1. / 6);
  EXPECT_NEAR(law(peak) / lennard_jones_attraction(w, z0), 1, 1e-14);
  EXPECT_LT(law(1.001 * peak), law(peak));
  EXPECT_LT(law(0.999 * peak), law(peak));
}

TEST(Tabor, OutOfRangeParametersAreRefused) {
  const auto s = AdhesiveSphere::of(1, 1, 1);
  EXPECT_THROW(tabor_parameter(s, 0), std::invalid_argument);
  EXPECT_THROW(maugis_parameter(s, -1), std::invalid_argument);
  EXPECT_THROW(lennard_jones_attraction(1, std::nan("")), std::invalid_argument);
  EXPECT_THROW(dugdale_attraction(0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
