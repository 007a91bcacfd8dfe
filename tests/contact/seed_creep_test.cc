#include <patchgrip/contact/creep/seed_creep.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/contact/creep/press_under_force.h>
#include <patchgrip/tests/contact/creep_table.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::contact_rows;
using patchgrip::testing::units_of_rounding;

ContactCreep solid(double E1, double E2, double eta) {
  return ContactCreep::against_rigid(ViscoelasticMaterial::of(PoyntingThomson::of(E1, E2, eta).modulus(), 0.5));
}

TEST(SeedCreep, IsTheRelationThatIsPrinted) {
  for (const std::string kind : {"visco_step", "visco_ramp", "visco_halfsine", "visco_sine"}) {
    for (const auto& row : contact_rows(kind)) {
      const auto force = [&] {
        if (kind == "visco_step") return History::step(row.input("F0"));
        if (kind == "visco_ramp") return History::ramp(row.input("rate"));
        if (kind == "visco_halfsine") return History::half_sine(row.input("F0"), row.input("omega"));
        return History::sine(row.input("F0"), row.input("m"), row.input("omega"));
      }();
      const auto delta =
          seed_creep_approach(paraboloid(row.input("R")), poynting_thomson_of(row), force, row.input("t"));
      const auto printed = row.output("delta_thesis_428");
      EXPECT_LE(units_of_rounding(delta.value, printed), 10) << kind;
      EXPECT_LE(std::abs(static_cast<double>(testing::Exact(delta.value) - printed)), delta.error);
      EXPECT_LE(delta.error, 1e-12 * delta.value);
    }
  }
}

// How wrong it is, as the header says: the ratio to the exact approach over alpha t, for E1 = E2 and E1 = 4 E2.
TEST(SeedCreep, IsTooDeepAsStated) {
  constexpr std::array alpha_t{0.1, 0.5, 1., 3., 10., 1e4};
  constexpr std::array step_1{1.0308, 1.1169, 1.1774, 1.2494, 1.2599, 1.2599};
  constexpr std::array ramp_1{1.0250, 1.0996, 1.1566, 1.2368, 1.2586, 1.2599};
  constexpr std::array step_4{1.1135, 1.3704, 1.5224, 1.6870, 1.7100, 1.7100};
  constexpr std::array ramp_4{1.0943, 1.3278, 1.4775, 1.6623, 1.7075, 1.7100};
  const auto check = [&](const ContactCreep& creep, const History& force, const std::array<double, 6>& ratios) {
    const auto press = PressUnderForce<PowerProfile>::of(paraboloid(0.02), creep, force, 1e5);
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      const double t = alpha_t[k] / 2.5;
      const double ratio = seed_creep_approach(paraboloid(0.02), creep, force, t).value / press.approach(t).value;
      EXPECT_NEAR(ratio, ratios[k], 1.5e-4) << alpha_t[k];
    }
  };
  check(solid(25000, 25000, 5000), History::step(10), step_1);
  check(solid(25000, 25000, 5000), History::ramp(10), ramp_1);
  check(solid(100000, 25000, 8000), History::step(10), step_4);
  check(solid(100000, 25000, 8000), History::ramp(10), ramp_4);
}

TEST(SeedCreep, RelaxesToTheWrongHertz) {
  const auto creep = solid(25000, 25000, 5000);
  // Figure 4.9: 17.17 mm; Hertz with E2 is 13.63 mm.
  EXPECT_NEAR(seed_creep_approach(paraboloid(0.02), creep, History::step(10), 100).value, 17.1707e-3, 1e-7);
  // The limit of a power profile is (E / E_inf)^(1/(m+1)) of the exact one.
  const auto profile = PowerProfile::of_coefficient(0.3, 1);
  const auto press = PressUnderForce<PowerProfile>::of(profile, creep, History::step(10), 200);
  const double ratio = seed_creep_approach(profile, creep, History::step(10), 100).value / press.approach(100).value;
  EXPECT_NEAR(ratio, std::sqrt(2.), 1e-12);
}

// The rate form: delta' + alpha delta = (C / F^(1/3)) (2/3 F' + E1/eta F), not with E1^2 / (eta (E1 + E2)).
TEST(SeedCreep, ObeysTheCorrectedRateForm) {
  const auto creep = solid(100000, 25000, 8000);
  const auto force = History::ramp(20);
  const double t = 0.3, h = 1e-4, F = 20 * t;
  const auto delta = [&](double at) { return seed_creep_approach(paraboloid(0.02), creep, force, at).value; };
  const double C = paraboloid(0.02).approach(paraboloid(0.02).radius_of_force(creep.compliance.instantaneous()));
  const double slope = (8 * (delta(t + h) - delta(t - h)) - (delta(t + 2 * h) - delta(t - 2 * h))) / (12 * h);
  const double left = slope + 2.5 * delta(t);
  EXPECT_NEAR(left / (C / std::cbrt(F) * (2. / 3. * 20 + 100000. / 8000 * F)), 1, 1e-9);
  EXPECT_GT(left / (C / std::cbrt(F) * (2. / 3. * 20 + 1e10 / (8000. * 125000) * F)), 1.1);
}

TEST(SeedCreep, BadInputIsRefused) {
  const auto creep = solid(1, 1, 1);
  EXPECT_EQ(seed_creep_approach(paraboloid(1), creep, History::step(1), -1).value, 0);
  EXPECT_THAT(
      [&] { seed_creep_approach(paraboloid(1), creep, History::step(-1), 1); },
      ::testing::ThrowsMessage<std::invalid_argument>("force = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([&] { seed_creep_approach(paraboloid(1), creep, History::step(1), NAN); },
              ::testing::ThrowsMessage<std::invalid_argument>("time = nan is not allowed: must be finite"));
  const auto dashpot = ContactCreep::against_rigid(ViscoelasticMaterial::of(kelvin_voigt(1, 1), 0.5));
  EXPECT_THAT([&] { seed_creep_approach(paraboloid(1), dashpot, History::step(1), 1); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "instantaneous compliance = 0 is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
