#include <patchgrip/contact/material.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::units_of_rounding;

Exact exact_modulus(const Material& first, const Material& second) {
  const auto compliance = [](const Material& body) {
    const Exact nu(body.poisson_ratio);
    return (1 - nu * nu) / Exact(body.youngs_modulus);
  };
  return 1 / (compliance(first) + compliance(second));
}

// Young's moduli log-uniform over the range of double, Poisson ratios uniform or within 1e-15 .. 1e-1 of -1.
class Draw {
 public:
  double poisson_ratio() {
    return unit_(engine_) < 0.5 ? 0.5 - 1.5 * unit_(engine_) : -1 + std::pow(10, -1 - 14 * unit_(engine_));
  }
  Material material(double decades) {
    return Material::elastic(std::pow(10, decades * (2 * unit_(engine_) - 1)), poisson_ratio());
  }

 private:
  std::mt19937_64 engine_{20060101};
  std::uniform_real_distribution<double> unit_{0, 1};
};

TEST(Material, ContactModulusAgreesWithTheTable) {
  const auto rows = contact_rows("material_pair");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const double modulus = contact_modulus(Material::elastic(row.input("E_p"), row.input("nu_p")),
                                           Material::elastic(row.input("E_m"), row.input("nu_m")));
    EXPECT_LE(units_of_rounding(modulus, row.output("E_star")), 2);
  }
}

TEST(Material, ContactModulusIsRoundedOnce) {
  Draw draw;
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const double decades = i % 2 == 0 ? 12 : 290;
    const Material first = draw.material(decades);
    const Material second = draw.material(decades);
    worst = std::max(worst, units_of_rounding(contact_modulus(first, second), exact_modulus(first, second)));
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.01);
}

TEST(Material, BodiesMayBeSwapped) {
  Draw draw;
  for (int i = 0; i < 1000; ++i) {
    const Material first = draw.material(12);
    const Material second = draw.material(12);
    EXPECT_EQ(contact_modulus(first, second), contact_modulus(second, first));
  }
}

TEST(Material, StifferBodyMeansStifferContact) {
  Draw draw;
  for (int i = 0; i < 1000; ++i) {
    const Material first = draw.material(12);
    const Material second = draw.material(12);
    const Material stiffer = Material::elastic(2 * first.youngs_modulus, first.poisson_ratio);
    EXPECT_GE(contact_modulus(stiffer, second), contact_modulus(first, second));
  }
}

TEST(Material, RigidPartnerLeavesThePlaneStrainModulusOfTheOther) {
  EXPECT_EQ(contact_modulus(Material::elastic(3e6, 0.5), Material::rigid()), 4e6);
  EXPECT_EQ(contact_modulus(Material::rigid(), Material::elastic(3e6, 0.5)), 4e6);
}

TEST(Material, EqualBodiesHalveThePlaneStrainModulus) {
  const Material rubber = Material::elastic(3e6, 0.5);
  EXPECT_EQ(contact_modulus(rubber, rubber), 2e6);
}

TEST(Material, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([] { Material::elastic(0, 0.3); },
              refused("youngs_modulus = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { Material::elastic(std::numeric_limits<double>::infinity(), 0.3); },
              refused("youngs_modulus = inf is not allowed: must be positive and finite"));
  EXPECT_THAT([] { Material::elastic(1e6, -1); }, refused("poisson_ratio = -1 is not allowed: must lie in (-1, 0.5]"));
  EXPECT_THAT([] { Material::elastic(1e6, 0.51); },
              refused("poisson_ratio = 0.51 is not allowed: must lie in (-1, 0.5]"));
  EXPECT_THAT([] { Material::elastic(1e6, std::nan("")); },
              refused("poisson_ratio = nan is not allowed: must lie in (-1, 0.5]"));
}

TEST(Material, TwoRigidBodiesAreRefused) {
  EXPECT_THROW(contact_modulus(Material::rigid(), Material::rigid()), std::invalid_argument);
}

TEST(Material, ContactModulusBeyondTheRangeOfDoubleIsRefused) {
  const Material stiff = Material::elastic(1e308, 0.5);
  EXPECT_EQ(contact_modulus(stiff, stiff), 1e308 / 1.5);
  const Material auxetic = Material::elastic(1e308, -0.999);
  EXPECT_THROW(contact_modulus(auxetic, auxetic), std::invalid_argument);
  const Material vanishing = Material::elastic(1e-310, 0);
  EXPECT_THROW(contact_modulus(vanishing, stiff), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
