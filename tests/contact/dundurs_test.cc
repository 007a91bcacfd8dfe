#include <patchgrip/contact/dundurs.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

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

TEST(Dundurs, AgreesWithTheTable) {
  const auto rows = contact_rows("material_pair");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const auto pair = Dundurs::of(Material::elastic(row.input("E_p"), row.input("nu_p")),
                                  Material::elastic(row.input("E_m"), row.input("nu_m")));
    // nu = 0.49 is rounded before 1 - 2 nu = 0.02 is taken.
    EXPECT_LE(units_of_rounding(std::abs(pair.beta), row.output("beta_dundurs")), 20);
    EXPECT_LE(units_of_rounding(pair.seed_printed_beta(), row.output("beta_thesis_printed")), 20);
  }
}

Material any_material(std::mt19937_64& engine) {
  const double nu = uniform(engine, 0, 1) < 0.5 ? uniform(engine, -1, 0.5) : -1 + log_uniform(engine, 1e-15, 0.1);
  return Material::elastic(log_uniform(engine, 1e-12, 1e12), std::max(nu, std::nextafter(-1., 0)));
}

TEST(Dundurs, HoldsItsBound) {
  std::mt19937_64 engine(20060150);
  double worst = 0;
  for (int i = 0; i < cases(3000); ++i) {
    const Material p = any_material(engine);
    const Material m = i % 2 == 0
                           ? any_material(engine)
                           : Material::elastic(p.youngs_modulus * (1 + log_uniform(engine, 1e-15, 1)), p.poisson_ratio);
    const auto pair = Dundurs::of(p, m);
    const auto compliance = [](const Material& body) {
      return (1 - Exact(body.poisson_ratio)) * (1 + Exact(body.poisson_ratio)) / body.youngs_modulus;
    };
    const auto coupling = [](const Material& body) {
      return (1 - 2 * Exact(body.poisson_ratio)) * (1 + Exact(body.poisson_ratio)) / body.youngs_modulus;
    };
    const Exact sum = compliance(p) + compliance(m);
    const auto of_bound = [](double value, const Exact& exact) {
      return static_cast<double>(abs(value - exact) / (1.01 * 0x1p-53 * abs(exact) + 0x1p-62));
    };
    worst = std::max({worst, of_bound(pair.alpha, (compliance(m) - compliance(p)) / sum),
                      of_bound(pair.beta, (coupling(m) - coupling(p)) / (2 * sum))});
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

RC_GTEST_PROP(Dundurs, ChangesSignWithTheOrderOfTheBodies, ()) {
  std::mt19937_64 engine(*rc::gen::arbitrary<unsigned>());
  const Material p = any_material(engine), m = any_material(engine);
  const auto one = Dundurs::of(p, m), other = Dundurs::of(m, p);
  RC_ASSERT(one.alpha == -other.alpha);
  RC_ASSERT(one.beta == -other.beta);
  RC_ASSERT(one.seed_printed_beta() == other.seed_printed_beta());
}

RC_GTEST_PROP(Dundurs, LiesInItsParallelogram, ()) {
  std::mt19937_64 engine(*rc::gen::arbitrary<unsigned>());
  const auto pair = Dundurs::of(any_material(engine), any_material(engine));
  RC_ASSERT(std::abs(pair.alpha) <= 1);
  RC_ASSERT(std::abs(pair.beta) <= 0.75);
}

TEST(Dundurs, IsZeroForEqualOrIncompressibleBodies) {
  const Material steel = Material::elastic(2.1e11, 0.3);
  EXPECT_EQ(Dundurs::of(steel, steel).alpha, 0);
  EXPECT_EQ(Dundurs::of(steel, steel).beta, 0);
  EXPECT_EQ(Dundurs::of(Material::elastic(1e6, 0.5), Material::elastic(1e9, 0.5)).beta, 0);
  EXPECT_EQ(Dundurs::of(Material::elastic(1e6, 0.5), Material::rigid()).beta, 0);
}

// Seed example 4.5: rubber on glass and on steel, printed as about 0.078.
TEST(Dundurs, OfRubberOnGlassAndSteelIsTheSeeds) {
  const Material rubber = Material::elastic(5e7, 0.49);
  EXPECT_NEAR(Dundurs::of(rubber, Material::elastic(7e10, 0.25)).seed_printed_beta(), 0.0772, 5e-5);
  EXPECT_NEAR(Dundurs::of(rubber, Material::elastic(2e11, 0.3)).seed_printed_beta(), 0.0781, 5e-5);
}

TEST(Dundurs, TwoRigidBodiesAreRefused) {
  EXPECT_THROW(Dundurs::of(Material::rigid(), Material::rigid()), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
