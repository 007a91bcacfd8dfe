#include <patchgrip/contact/creep/rabotnov.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
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
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

TEST(RabotnovModel, AgreesWithTheTable) {
  const auto rows = contact_rows("rabotnov_elastic_ex43");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const double d = row.input_or(2, "d");
    const auto model =
        RabotnovModel::of(row.input("mu"), d, row.input("w1"), row.input("F1"), row.input("c"), row.input("E"));
    EXPECT_LE(units_of_rounding(model.compliance, row.output("C")), 4);
    EXPECT_LE(units_of_rounding(model.force(row.input("delta")), row.output("F_N")), 40);
    EXPECT_LE(units_of_rounding(model.radius(row.input("delta")), row.output("a_K")), 20);
    EXPECT_LE(units_of_rounding(model.gamma, row.output("gamma")), 2);
  }
}

TEST(RabotnovModel, IsRoundedAsStated) {
  std::mt19937_64 engine(20060441);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double mu = uniform(engine, 0.2, 2), d = uniform(engine, 1, 6), w1 = log_uniform(engine, 0.1, 10);
    const double F1 = log_uniform(engine, 0.1, 10), c = log_uniform(engine, 0.5, 5), E = log_uniform(engine, 1e3, 1e9);
    const double delta = log_uniform(engine, 1e-6, 1e-1);
    const auto model = RabotnovModel::of(mu, d, w1, F1, c, E);
    const auto exact = BasicRabotnovModel<Exact>::of(mu, d, w1, F1, c, E);
    const double n = 1 / (mu * d * model.gamma);
    const double logs =
        std::abs(std::log(delta)) * (1 + mu) + std::abs(std::log(model.compliance)) + std::abs(std::log(F1));
    worst = std::max({worst, units_of_rounding(model.force(delta), exact.force(delta)) / (1 + n * logs),
                      units_of_rounding(model.radius(delta), exact.radius(delta)) / (1 + logs * (1 / d + 1 / (mu * d))),
                      units_of_rounding(model.compliance, exact.compliance) / (1 + logs)});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 8);
}

// mu = 1, d = 2 with Hertz's pressure is Hertz: F_1 = (4/3) E*/R, w_1 = pi E* c / E.
TEST(RabotnovModel, IsHertzForALinearMaterial) {
  const double E = 5e4, nu = 0.5, R = 0.02, E_star = E / (1 - nu * nu);
  const double c = M_PI / (1 - nu * nu);
  const auto model = RabotnovModel::of(1., 2., c * E / R, 4. / 3. * E_star / R, c, E);
  const double delta = 1e-3;
  EXPECT_NEAR(model.radius(delta) / std::sqrt(R * delta), 1, 1e-14);
  EXPECT_NEAR(model.force(delta) / (4. / 3. * E_star * std::sqrt(R) * std::pow(delta, 1.5)), 1, 1e-14);
}

TEST(RabotnovModel, IsSimilar) {
  const auto model = RabotnovModel::of(0.6, 2., 2.5, 0.7, 2.1, 5e4);
  for (const double delta : {1e-5, 1e-3, 0.1}) {
    EXPECT_NEAR(model.approach(model.force(delta)) / delta, 1, 1e-13);
    const double grown = model.force(2 * delta) / model.force(delta);
    EXPECT_NEAR(model.radius(2 * delta) / model.radius(delta), std::pow(grown, model.gamma), 1e-13);
    EXPECT_NEAR(2, std::pow(grown, 2 * model.gamma), 1e-13);
  }
  EXPECT_EQ(model.force(0), 0);
  EXPECT_EQ(model.radius(-1), 0);
  // The measured gamma below 1/3 takes mu > 1.
  EXPECT_GT(RabotnovModel::of(0.9, 2., 1., 1., 1., 1.).gamma, 1. / 3.);
  EXPECT_LT(RabotnovModel::of(1.1, 2., 1., 1., 1., 1.).gamma, 1. / 3.);
}

TEST(RabotnovModel, BadInputIsRefused) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([] { RabotnovModel::of(0., 2., 1., 1., 1., 1.); },
              refused("mu = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { RabotnovModel::of(1., -2., 1., 1., 1., 1.); },
              refused("d = -2 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { RabotnovModel::of(1., 2., 1., 1., NAN, 1.); },
              refused("c = nan is not allowed: must be positive and finite"));
  EXPECT_THAT([] { RabotnovModel::of(1., 2., 1., 1., 1., INFINITY); },
              refused("E = inf is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
