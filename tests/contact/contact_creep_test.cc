#include <patchgrip/contact/creep/contact_creep.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/contact/creep/growing_ellipse.h>
#include <patchgrip/contact/creep/standard_models.h>
#include <patchgrip/contact/creep/wide.h>
#include <patchgrip/tests/contact/creep_table.h>
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

ViscoelasticMaterial any_body(std::mt19937_64& engine) {
  Modes<double> modes;
  for (int i = std::uniform_int_distribution<int>(0, 5)(engine); i > 0; --i) {
    modes.push_back({log_uniform(engine, 1e3, 1e6), log_uniform(engine, 1e-3, 1e3)});
  }
  return ViscoelasticMaterial::of(RelaxationModulus::of(log_uniform(engine, 1e3, 1e6), std::move(modes)),
                                  uniform(engine, -0.9, 0.5));
}

TEST(ContactCreep, AddsTheCompliancesOfTheBodies) {
  std::mt19937_64 engine(20060451);
  double worst = 0;
  for (int i = 0; i < cases(100); ++i) {
    const auto one = any_body(engine), other = any_body(engine);
    const auto pair = ContactCreep::between(one, other);
    const auto exact = [&](const Exact& t) -> Exact {
      const Exact nu = one.poisson_ratio, mu = other.poisson_ratio;
      return (1 - nu * nu) * compliance_as<Exact>(one.compliance)(t) +
             (1 - mu * mu) * compliance_as<Exact>(other.compliance)(t);
    };
    worst = std::max(worst, units_of_rounding(pair.compliance(0), exact(0)));
    worst = std::max(worst, units_of_rounding(1 / pair.modulus.instantaneous(), exact(0)) -
                                0.5 * static_cast<double>(pair.modulus.modes().size()));
    const double t = log_uniform(engine, 1e-4, 1e4);
    EXPECT_LE(units_of_rounding(pair.compliance(t), exact(t)), 12);
    ASSERT_EQ(pair.coupling.size(), pair.modulus.modes().size());
    // sum C_j tau_i / (lambda_j - tau_i) = C_0 at every tau_i: the coupling to its last digits.
    for (std::size_t k = 0; k < pair.coupling.size(); ++k) {
      double sum = 0, size = 0;
      for (std::size_t j = 0; j < pair.compliance.modes().size(); ++j) {
        const double term = pair.compliance.modes()[j].strength * pair.modulus.modes()[k].time * pair.coupling[k][j];
        sum += term;
        size += std::abs(term);
      }
      EXPECT_LE(std::abs(sum - pair.compliance.instantaneous()), 8 * 0x1p-53 * size);
    }
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 2);
}

TEST(ContactCreep, OfElasticBodiesIsTheContactModulus) {
  const Material steel = Material::elastic(2e11, 0.3), rubber = Material::elastic(5e4, 0.49);
  const auto pair = ContactCreep::between(ViscoelasticMaterial::elastic(steel), ViscoelasticMaterial::elastic(rubber));
  EXPECT_NEAR(pair.secant_modulus(7) / contact_modulus(steel, rubber), 1, 1e-15);
  EXPECT_NEAR(pair.modulus(7) / contact_modulus(steel, rubber), 1, 1e-15);
}

// The seed adds k_E without 1 - nu^2: two equal bodies of nu = 1/2, E1 = E2 would relax by 2.333 instead of 2.
TEST(ContactCreep, RelaxesByTheFactorOfTheBodies) {
  const auto body = ViscoelasticMaterial::of(PoyntingThomson::of(3e4, 3e4, 5e3).modulus(), 0.5);
  const auto pair = ContactCreep::between(body, body);
  EXPECT_DOUBLE_EQ(pair.compliance(1e9) / pair.compliance(0), 2);
  EXPECT_EQ(pair.compliance.modes().size(), 1U);
}

TEST(ContactCreep, IsSymmetricAndFromEitherSeries) {
  std::mt19937_64 engine(20060452);
  const auto one = any_body(engine), other = any_body(engine);
  EXPECT_EQ(ContactCreep::between(one, other).compliance(0.3), ContactCreep::between(other, one).compliance(0.3));
  const auto from_compliance = ViscoelasticMaterial::of(one.compliance, one.poisson_ratio);
  EXPECT_NEAR(from_compliance.modulus(0.3) / one.modulus(0.3), 1, 1e-12);
}

TEST(ContactCreep, BadInputIsRefused) {
  EXPECT_THAT(
      [] { ViscoelasticMaterial::of(maxwell(1, 1), 0.7); },
      ::testing::ThrowsMessage<std::invalid_argument>("poisson_ratio = 0.7 is not allowed: must lie in (-1, 0.5]"));
  EXPECT_THAT([] { ViscoelasticMaterial::elastic(Material::rigid()); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "youngs_modulus = inf is not allowed: must be positive and finite"));
}

TEST(GrowingEllipse, AgreesWithTheTable) {
  const auto rows = contact_rows("visco_ellipse_step");
  ASSERT_EQ(rows.size(), 1U);
  for (const auto& row : rows) {
    const double large = row.input("R_large");
    const auto ellipse =
        GrowingEllipse::under_force(RelativeRadii::of(row.input("ratio") * large, large), poynting_thomson_of(row),
                                    History::step(row.input("F0")), row.input("t"));
    EXPECT_LE(units_of_rounding(ellipse.a, row.output("a")), 6);
    EXPECT_LE(units_of_rounding(ellipse.b, row.output("b")), 6);
    EXPECT_LE(units_of_rounding(ellipse.approach, row.output("delta")), 8);
  }
}

TEST(GrowingEllipse, KeepsItsShapeUntilItWouldShrink) {
  const auto creep =
      ContactCreep::against_rigid(ViscoelasticMaterial::of(PoyntingThomson::of(25000, 25000, 5000).modulus(), 0.5));
  const auto radii = RelativeRadii::of(0.01, 0.03);
  const auto force = History::triangle(10, 1);
  const auto early = GrowingEllipse::under_force(radii, creep, force, 0.1);
  const auto late = GrowingEllipse::under_force(radii, creep, force, 1);
  EXPECT_NEAR(early.a / early.b, late.a / late.b, 1e-14);
  EXPECT_GT(late.a, early.a);
  EXPECT_THAT([&] { GrowingEllipse::under_force(radii, creep, force, 1.5); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "time = 1.5 is not allowed: must not be after the load integral falls: the ellipse would shrink"));
}

}  // namespace
}  // namespace patchgrip::contact
