#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/creep/conversion.h>
#include <patchgrip/contact/creep/standard_models.h>
#include <patchgrip/contact/creep/wide.h>
#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::ContactRow;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

RelaxationModulus modulus_of(const ContactRow& row) {
  const double equilibrium = row.input_or(0, "E_inf");
  return RelaxationModulus::of(equilibrium, {{row.input("E_1"), row.input("tau_1")},
                                             {row.input("E_2"), row.input("tau_2")},
                                             {row.input("E_3"), row.input("tau_3")}});
}

TEST(Conversion, ToComplianceAgreesWithTheTable) {
  const auto rows = contact_rows("prony_conversion");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto modulus = modulus_of(row);
    const auto compliance = creep_compliance(modulus);
    EXPECT_LE(units_of_rounding(compliance.instantaneous(), row.output("J_0")), 1.5);
    EXPECT_LE(units_of_rounding(compliance.equilibrium(), row.output("J_inf")), 3);
    ASSERT_EQ(compliance.modes().size(), 3U);
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_LE(units_of_rounding(compliance.modes()[j].time, row.output(numbered("lambda", j + 1))), 2);
      EXPECT_LE(units_of_rounding(compliance.modes()[j].strength, row.output(numbered("J", j + 1))), 2);
    }
    EXPECT_LE(units_of_rounding(compliance(row.input("t")), row.output("J_at_t")), 4);
    EXPECT_LE(units_of_rounding(modulus(row.input("t")), row.output("E_at_t")), 4);
  }
}

TEST(Conversion, OfAFluidAgreesWithTheTable) {
  const auto rows = contact_rows("prony_conversion_fluid");
  ASSERT_EQ(rows.size(), 1U);
  for (const auto& row : rows) {
    const auto modulus = modulus_of(row);
    const auto compliance = creep_compliance(modulus);
    EXPECT_LE(units_of_rounding(compliance.instantaneous(), row.output("J_0")), 1.5);
    EXPECT_LE(units_of_rounding(1 / compliance.fluidity(), row.output("viscosity")), 2);
    EXPECT_LE(units_of_rounding(compliance.equilibrium(), row.output("J_e0")), 3);
    ASSERT_EQ(compliance.modes().size(), 2U);
    for (std::size_t j = 0; j < 2; ++j) {
      EXPECT_LE(units_of_rounding(compliance.modes()[j].time, row.output(numbered("lambda", j + 1))), 2);
      EXPECT_LE(units_of_rounding(compliance.modes()[j].strength, row.output(numbered("J", j + 1))), 2);
    }
    EXPECT_LE(units_of_rounding(compliance(row.input("t")), row.output("J_at_t")), 4);
    EXPECT_LE(units_of_rounding(modulus(row.input("t")), row.output("E_at_t")), 4);
  }
}

TEST(Conversion, ToModulusAgreesWithTheTable) {
  const auto rows = contact_rows("prony_creep_to_relax");
  ASSERT_EQ(rows.size(), 1U);
  for (const auto& row : rows) {
    const auto modulus = relaxation_modulus(CreepCompliance::of(
        row.input("J_0"), {{row.input("J_1"), row.input("lam_1")}, {row.input("J_2"), row.input("lam_2")}}));
    EXPECT_LE(units_of_rounding(modulus.equilibrium(), row.output("E_inf")), 2);
    ASSERT_EQ(modulus.modes().size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(units_of_rounding(modulus.modes()[i].time, row.output(numbered("tau", i + 1))), 2);
      EXPECT_LE(units_of_rounding(modulus.modes()[i].strength, row.output(numbered("E", i + 1))), 2);
    }
    EXPECT_LE(units_of_rounding(modulus(row.input("t")), row.output("E_at_t")), 4);
  }
}

TEST(PoyntingThomson, AgreesWithTheTable) {
  const auto rows = contact_rows("poynting_thomson");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const auto solid = PoyntingThomson::of(row.input("E1"), row.input("E2"), row.input("eta"));
    const double t = row.input("t");
    EXPECT_LE(units_of_rounding(solid.creep(t), row.output("K_E")), 4);
    EXPECT_LE(units_of_rounding(solid.creep(0), row.output("K_E_0")), 2);
    EXPECT_LE(units_of_rounding(solid.creep(1e9), row.output("K_E_inf")), 3);
    EXPECT_LE(units_of_rounding(solid.creep_rate(t), row.output("k_E")), 6);
    EXPECT_LE(units_of_rounding(solid.retardation_rate(), row.output("alpha")), 3);
    EXPECT_LE(units_of_rounding(solid.modulus()(t), row.output("E_relax")), 4);
    const auto compliance = creep_compliance(solid.modulus());
    EXPECT_LE(units_of_rounding(compliance(t), row.output("K_E")), 6);
    EXPECT_LE(units_of_rounding(compliance.slope(t), row.output("k_E")), 6);
  }
}

// 1 to 20 modes; times over 12 decades, or within a part in 10^9 of each other, or equal; strengths over 6 decades.
RelaxationModulus any_modulus(std::mt19937_64& engine) {
  const int count = std::uniform_int_distribution<int>(1, 20)(engine);
  const bool is_clustered = std::uniform_int_distribution<int>(0, 2)(engine) == 0;
  Modes<double> modes;
  for (int i = 0; i < count; ++i) {
    const double time = is_clustered ? 1 + std::round(uniform(engine, 0, 30)) * 1e-9 : log_uniform(engine, 1e-6, 1e6);
    modes.push_back({log_uniform(engine, 1, 1e6), time});
  }
  const double equilibrium = std::uniform_int_distribution<int>(0, 3)(engine) == 0 ? 0 : log_uniform(engine, 1, 1e6);
  const double dashpot = std::uniform_int_distribution<int>(0, 3)(engine) == 0 ? log_uniform(engine, 1e-6, 1e6) : 0;
  return RelaxationModulus::of(equilibrium, std::move(modes), dashpot);
}

double worst_units(const Modes<double>& rounded, const Modes<Exact>& exact) {
  EXPECT_EQ(rounded.size(), exact.size());
  double worst = 0;
  for (std::size_t i = 0; i < std::min(rounded.size(), exact.size()); ++i) {
    worst = std::max({worst, units_of_rounding(rounded[i].strength, exact[i].strength),
                      units_of_rounding(rounded[i].time, exact[i].time)});
  }
  return worst;
}

TEST(Conversion, IsRoundedOnceBothWays) {
  std::mt19937_64 engine(20060401);
  double worst = 0;
  for (int i = 0; i < cases(100); ++i) {
    const auto modulus = any_modulus(engine);
    const auto compliance = creep_compliance(modulus);
    const auto exact = reciprocal(modulus_as<Exact>(modulus));
    worst = std::max({worst, worst_units(compliance.modes(), exact.modes()),
                      units_of_rounding(compliance.instantaneous(), exact.instantaneous()),
                      units_of_rounding(compliance.fluidity(), exact.fluidity())});
    const auto back = relaxation_modulus(compliance);
    const auto exact_back = reciprocal(compliance_as<Exact>(compliance));
    worst = std::max({worst, worst_units(back.modes(), exact_back.modes()),
                      units_of_rounding(back.equilibrium(), exact_back.equilibrium()),
                      units_of_rounding(back.dashpot(), exact_back.dashpot())});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.01);
}

// s^2 E(s) J(s) = 1 at any s: what conversion means, by another route than its roots.
TEST(Conversion, IsReciprocalInTheLaplaceDomain) {
  std::mt19937_64 engine(20060402);
  Exact worst = 0;
  for (int i = 0; i < cases(60); ++i) {
    const auto modulus = modulus_as<Exact>(any_modulus(engine));
    const auto compliance = reciprocal(modulus);
    for (const double s : {1e-7, 1e-3, 1., 1e3, 1e7}) {
      Exact stress = modulus.equilibrium() + s * modulus.dashpot();
      for (const auto& mode : modulus.modes()) stress += mode.strength * s * mode.time / (1 + s * mode.time);
      Exact strain = compliance.instantaneous() + compliance.fluidity() / s;
      for (const auto& mode : compliance.modes()) strain += mode.strength / (1 + s * mode.time);
      worst = std::max<Exact>(worst, abs(stress * strain - 1));
    }
  }
  EXPECT_LE(worst, Exact(1e-33));
}

TEST(Conversion, ComesBack) {
  std::mt19937_64 engine(20060403);
  for (int i = 0; i < cases(40); ++i) {
    const auto modulus = modulus_as<Exact>(any_modulus(engine));
    const auto back = reciprocal(reciprocal(modulus));
    ASSERT_EQ(back.modes().size(), modulus.modes().size());
    for (std::size_t k = 0; k < modulus.modes().size(); ++k) {
      EXPECT_LE(abs(back.modes()[k].time / modulus.modes()[k].time - 1), Exact(1e-30));
      EXPECT_LE(abs(back.modes()[k].strength / modulus.modes()[k].strength - 1), Exact(1e-22));
    }
    EXPECT_LE(abs(back.equilibrium() - modulus.equilibrium()), Exact(1e-30) * modulus.instantaneous());
  }
}

TEST(Conversion, TimesInterlace) {
  std::mt19937_64 engine(20060404);
  for (int i = 0; i < cases(100); ++i) {
    const auto modulus = modulus_as<Wide>(any_modulus(engine));
    const auto compliance = reciprocal(modulus);
    const std::size_t before = modulus.dashpot() > 0 ? 1 : 0;
    ASSERT_EQ(compliance.modes().size() + 1, modulus.modes().size() + before + (modulus.equilibrium() > 0 ? 1 : 0));
    for (std::size_t j = 0; j < compliance.modes().size(); ++j) {
      if (j >= before) {
        EXPECT_GT(compliance.modes()[j].time, modulus.modes()[j - before].time);
      }
      if (j + 1 - before < modulus.modes().size()) {
        EXPECT_LT(compliance.modes()[j].time, modulus.modes()[j + 1 - before].time);
      }
    }
  }
}

TEST(Series, AreRoundedAsStated) {
  std::mt19937_64 engine(20060405);
  double modulus_excess = 0, compliance_excess = 0, dynamic_excess = 0;
  for (int i = 0; i < cases(300); ++i) {
    const auto modulus = any_modulus(engine);
    const auto compliance = creep_compliance(modulus);
    const double half = 0.5 * static_cast<double>(modulus.modes().size());
    const auto exact_modulus = modulus_as<Exact>(modulus);
    const auto exact_compliance = compliance_as<Exact>(compliance);
    const double t = log_uniform(engine, 1e-7, 1e7);
    if (exact_modulus(t) > Exact(1e-290)) {
      // exp(-x) carries the rounding of x: x units of each mode's share.
      double steepness = 0;
      for (const auto& mode : modulus.modes()) {
        const double x = t / mode.time;
        steepness += x * mode.strength * std::exp(-x) / modulus(t);
      }
      modulus_excess = std::max(modulus_excess, units_of_rounding(modulus(t), exact_modulus(t)) - half - steepness);
    }
    compliance_excess = std::max(compliance_excess, units_of_rounding(compliance(t), exact_compliance(t)) - half);
    const double w = log_uniform(engine, 1e-8, 1e8);
    const auto dynamic = modulus.dynamic(w);
    const auto exact_dynamic = exact_modulus.dynamic(w);
    dynamic_excess = std::max({dynamic_excess, units_of_rounding(dynamic.storage, exact_dynamic.storage) - half,
                               units_of_rounding(dynamic.loss, exact_dynamic.loss) - half});
  }
  RecordProperty("modulus", std::to_string(modulus_excess));
  RecordProperty("compliance", std::to_string(compliance_excess));
  RecordProperty("dynamic", std::to_string(dynamic_excess));
  EXPECT_LE(modulus_excess, 3);
  EXPECT_LE(compliance_excess, 4);
  EXPECT_LE(dynamic_excess, 6);
}

TEST(Series, LimitsOfTheComplexModulus) {
  const auto modulus = RelaxationModulus::of(2e4, {{1e4, 0.1}, {3e4, 5}});
  EXPECT_DOUBLE_EQ(modulus.dynamic(0).storage, 2e4);
  EXPECT_EQ(modulus.dynamic(0).loss, 0);
  EXPECT_DOUBLE_EQ(modulus.dynamic(1e300).storage, 6e4);
  EXPECT_GT(modulus.dynamic(1e300).loss, 0);
  const auto kelvin = kelvin_voigt(2e4, 10).dynamic(3);
  EXPECT_DOUBLE_EQ(kelvin.storage, 2e4);
  EXPECT_DOUBLE_EQ(kelvin.loss, 30);
}

RC_GTEST_PROP(Series, RelaxAndCreepMonotonically, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto modulus = any_modulus(engine);
  const auto compliance = creep_compliance(modulus);
  const double t = log_uniform(engine, 1e-7, 1e7);
  const double later = t * uniform(engine, 1.001, 10);
  RC_ASSERT(modulus(later) <= modulus(t));
  RC_ASSERT(compliance(later) >= compliance(t));
  // E(t) J(t) <= 1: the stress of a strain that was reached by creep is less than that of its step.
  if (modulus.dashpot() == 0) RC_ASSERT(modulus(t) * compliance(t) <= 1 + 1e-14);
}

TEST(StandardModels, KelvinVoigtAndMaxwellCreepAsTheirClosedForms) {
  const auto kelvin = creep_compliance(kelvin_voigt(25000, 5000));
  EXPECT_EQ(kelvin.instantaneous(), 0);
  ASSERT_EQ(kelvin.modes().size(), 1U);
  EXPECT_DOUBLE_EQ(kelvin.modes()[0].strength, 1 / 25000.);
  EXPECT_DOUBLE_EQ(kelvin.modes()[0].time, 0.2);
  const auto fluid = creep_compliance(maxwell(50000, 60000));
  EXPECT_DOUBLE_EQ(fluid(0.7), 1 / 50000. + 0.7 / 60000);
  EXPECT_TRUE(fluid.modes().empty());
  EXPECT_DOUBLE_EQ(relaxation_modulus(fluid)(0.7), 50000 * std::exp(-0.7 * 50000 / 60000));
  EXPECT_DOUBLE_EQ(relaxation_modulus(kelvin).dashpot(), 5000);
}

TEST(StandardModels, PoyntingThomsonTendsToTheOthers) {
  const double t = 0.3;
  EXPECT_NEAR(PoyntingThomson::of(1e15, 25000, 5000).creep(t) * 25000, -std::expm1(-t * 5), 1e-9);
  EXPECT_NEAR(PoyntingThomson::of(50000, 1e-6, 60000).creep(t) / (1 / 50000. + t / 60000), 1, 1e-9);
}

TEST(PoyntingThomson, OfModuliFarApartIsRightOrRefused) {
  for (const double E1 : {1e-200, 1e-3, 1e200}) {
    for (const double E2 : {1e-200, 1e-3, 1e200}) {
      for (const double eta : {1e-150, 1., 1e150}) {
        const Exact alpha = Exact(E1) * E2 / (Exact(eta) * (Exact(E1) + E2));
        if (alpha > std::numeric_limits<double>::max() || alpha < std::numeric_limits<double>::min()) {
          EXPECT_THROW(PoyntingThomson::of(E1, E2, eta), std::invalid_argument);
          continue;
        }
        const auto solid = PoyntingThomson::of(E1, E2, eta);
        EXPECT_LE(units_of_rounding(solid.retardation_rate(), alpha), 3);
        EXPECT_LE(units_of_rounding(solid.creep(0), 1 / (Exact(E1) + E2)), 2);
        const double t = static_cast<double>(0.7 / alpha);
        if (!std::isfinite(t)) continue;
        const Exact end = (1 - Exact(E1) / E2 * expm1(Exact(-alpha * t))) / (Exact(E1) + E2);
        EXPECT_LE(units_of_rounding(solid.creep(t), end), 6) << E1 << ' ' << E2 << ' ' << eta;
      }
    }
  }
  EXPECT_THAT([] { PoyntingThomson::of(1.5e308, 1.5e308, 1); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::StartsWith("E1 + E2 = inf is not allowed")));
}

TEST(Series, BeforeTheStepNothingHappens) {
  const auto solid = PoyntingThomson::of(1e4, 2e4, 1e3);
  EXPECT_EQ(solid.modulus()(-1), 0);
  EXPECT_EQ(creep_compliance(solid.modulus())(-1e-300), 0);
  EXPECT_EQ(creep_compliance(solid.modulus()).slope(-1), 0);
  EXPECT_EQ(solid.creep(-1), 0);
  EXPECT_EQ(solid.creep_rate(-1), 0);
}

TEST(Series, ModesOfOneTimeAreOneMode) {
  const auto modulus = RelaxationModulus::of(1, {{2, 3}, {4, 1}, {5, 3}});
  ASSERT_EQ(modulus.modes().size(), 2U);
  EXPECT_EQ(modulus.modes()[0].time, 1);
  EXPECT_EQ(modulus.modes()[1].strength, 7);
}

TEST(Series, BadInputIsRefused) {
  EXPECT_THAT(
      [] {
        RelaxationModulus::of(-1, {{1, 1}});
      },
      refused("E_inf = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT(
      [] {
        RelaxationModulus::of(1, {{1, 1}}, -2);
      },
      refused("eta = -2 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { RelaxationModulus::of(0, {}); },
              refused("E_inf = 0 is not allowed: must be positive where there is neither a mode nor a dashpot"));
  EXPECT_THAT(
      [] {
        RelaxationModulus::of(1, {{1, 1}, {1, -3}});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::StartsWith("tau_2 = -3 is not allowed")));
  EXPECT_THAT(
      [] {
        RelaxationModulus::of(1, {{NAN, 1}});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::StartsWith("E_1 = nan is not allowed")));
  EXPECT_THAT([] { CreepCompliance::of(-1e-5, {}); },
              refused("J_0 = -1e-05 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { CreepCompliance::of(0, {}); },
              refused("J_0 = 0 is not allowed: must be positive where there is neither a mode nor a fluidity"));
  EXPECT_THAT([] { PoyntingThomson::of(0, 1, 1); }, refused("E1 = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { maxwell(1, -1); }, refused("eta = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { kelvin_voigt(INFINITY, 1); }, refused("E2 = inf is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
