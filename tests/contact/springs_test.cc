#include <patchgrip/contact/creep/springs.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/creep/cycles.h>
#include <patchgrip/contact/creep/spring_press.h>
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

ContactCreep any_solid(std::mt19937_64& engine) {
  Modes<double> modes;
  for (int i = std::uniform_int_distribution<int>(1, 3)(engine); i > 0; --i) {
    modes.push_back({log_uniform(engine, 0.1, 10), log_uniform(engine, 1e-2, 1e2)});
  }
  return ContactCreep::against_rigid(ViscoelasticMaterial::of(RelaxationModulus::of(1, std::move(modes)), 0.3));
}

TEST(Springs, EstimateBoundsTheErrorOfAnyApproach) {
  std::mt19937_64 engine(20060471);
  double most = 0, sum = 0;
  int count = 0;
  for (int i = 0; i < cases(50); ++i) {
    const auto creep = any_solid(engine);
    std::vector<HistoryPoint<double>> points{{0, 0}};
    auto springs = Springs::under(paraboloid(1), creep, 0.35, std::uniform_int_distribution<int>(40, 400)(engine));
    for (int k = 0; k < 6; ++k) {
      const double h = log_uniform(engine, 0.05, 3);
      points.push_back({points.back().time + h, uniform(engine, -0.01, 0.1)});
      springs.advance_to_approach(h, points.back().value);
      const auto exact =
          Cycles<PowerProfile>::of(paraboloid(1), creep, History::points(points)).zone(points.back().time);
      if (!exact.is_one_circle || !(exact.force.value > 1e-6)) continue;
      const auto force = springs.force();
      const double off = std::abs(force.value - exact.force.value);
      EXPECT_LE(off, force.error + exact.force.error) << i << " " << k << " of " << exact.force.value;
      EXPECT_NEAR(springs.radius(), exact.radius, springs.distance());
      most = std::max(most, off / (force.error + exact.force.error));
      sum += std::log10(force.error / std::max(off, 1e-15));
      ++count;
    }
  }
  EXPECT_GT(count, cases(50));
  RecordProperty("worst_ratio", std::to_string(most));
  RecordProperty("decades_of_caution", std::to_string(sum / count));
}

TEST(Springs, ForceConvergesToTheTable) {
  for (const auto& row : contact_rows("visco_two_cycles")) {
    const auto modulus = RelaxationModulus::of(row.input("E_inf"), {{row.input("E_1"), row.input("tau_1")}});
    const auto creep = ContactCreep::against_rigid(ViscoelasticMaterial::of(modulus, row.input("nu")));
    const double t1 = row.input("t_1"), t2 = row.input("t_2"), t3 = row.input("t_3"), t = row.input("t");
    const double d = row.input("d_2") + (row.input("d_3") - row.input("d_2")) * (t - t2) / (t3 - t2);
    const double exact = static_cast<double>(row.output("F_N"));
    for (const auto& [count, error] : {std::pair{100, 5e-6}, {400, 5e-8}, {3200, 1e-10}}) {
      auto springs = Springs::under(paraboloid(row.input("R")), creep, 0.01, count);
      springs.advance_to_approach(t1, row.input("d_1"));
      springs.advance_to_approach(t2 - t1, row.input("d_2"));
      springs.advance_to_approach(t - t2, d);
      EXPECT_NEAR(springs.force().value / exact, 1, error);
      EXPECT_NEAR(springs.radius() / static_cast<double>(row.output("a_K")), 1, 2. / count / count);
      EXPECT_TRUE(springs.is_one_circle());
      EXPECT_TRUE(springs.stress_falls());
    }
  }
}

TEST(Springs, PressUnderForceHoldsItsEstimate) {
  for (const auto& row : contact_rows("ting_force_triangle")) {
    const auto creep = prony_of(row);
    const auto force = History::triangle(row.input("rate"), row.input("t_p"));
    for (const int steps : {10, 40}) {
      const auto press = press_springs(paraboloid(row.input("R")), creep, force, row.input("t"), 0.0115, 200, steps);
      const double off = std::abs(static_cast<double>(Exact(press.approach.value) - row.output("delta")));
      EXPECT_LE(off, press.approach.error);
      EXPECT_LE(press.approach.error, 0.2 / (steps * steps) * press.approach.value);
      const double wide = std::abs(static_cast<double>(Exact(press.radius.value) - row.output("a_K")));
      EXPECT_LE(wide, press.radius.error);
    }
  }
}

// One step or many, straight: not an approximation.
RC_GTEST_PROP(Springs, SplittingAStepChangesNothing, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  auto whole = Springs::under(paraboloid(1), any_solid(engine), 0.35, 60);
  auto parts = whole;
  double d = 0;
  for (int k = 0; k < 5; ++k) {
    const double next = uniform(engine, -0.01, 0.1), h = log_uniform(engine, 0.05, 3);
    whole.advance_to_approach(h, next);
    for (int i = 1; i <= 4; ++i) parts.advance_to_approach(h / 4, d + (next - d) * i / 4);
    d = next;
    RC_ASSERT(std::abs(whole.force().value - parts.force().value) <= 1e-13);
  }
}

RC_GTEST_PROP(Springs, ForceAndApproachAreInverse, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto creep = any_solid(engine);
  auto driven = Springs::under(paraboloid(1), creep, 0.4, 60);
  auto pressed = driven;
  double slack = 0;
  for (int k = 0; k < 5; ++k) {
    const double h = log_uniform(engine, 0.05, 3);
    driven.advance_to_approach(h, uniform(engine, 0.05, 0.1));
    const double force = driven.force().value;
    if (!(force > 1e-3)) break;
    pressed.advance_to_force(h, force);
    RC_ASSERT(std::abs(pressed.force().value / force - 1) < 1e-12);
    // Where the edge passes a spring the sum has a small step: one force, several approaches, alike within its error.
    slack += driven.force().error / (2 * driven.radius() * creep.modulus.equilibrium());
    RC_ASSERT(std::abs(pressed.approach() - driven.approach()) <= slack);
  }
}

// A cycle of loading never gives work: dissipation >= 0, over any history of force.
RC_GTEST_PROP(Springs, CyclesOfForceDissipate, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  auto springs = Springs::under(paraboloid(1), any_solid(engine), 0.5, 40);
  double work = 0;
  double force = 0;
  for (int k = 0; k < 4; ++k) {
    const double target = k == 3 ? 0 : uniform(engine, 0, 0.05), h = log_uniform(engine, 0.1, 2);
    const double start = force;
    for (int i = 1; i <= 80; ++i) {
      const double before = springs.approach(), pulled = force;
      force = i == 80 ? target : start + (target - start) * i / 80;
      springs.advance_to_force(h / 80, force);
      work += (pulled + force) / 2 * (springs.approach() - before);
    }
    RC_ASSERT(work >= -1e-7);
  }
}

TEST(Springs, ForceIsLostAndMetAgain) {
  const auto creep =
      ContactCreep::against_rigid(ViscoelasticMaterial::of(PoyntingThomson::of(3e4, 1e4, 3e3).modulus(), 0.5));
  auto springs = Springs::under(paraboloid(0.02), creep, 0.01, 200);
  springs.advance_to_force(1, 0.2);
  EXPECT_NEAR(springs.force().value, 0.2, 1e-12);
  springs.advance_to_force(0.5, 0);
  EXPECT_EQ(springs.radius(), 0);
  EXPECT_EQ(springs.force().value, 0);
  springs.advance_to_force(0.5, 0.2);
  EXPECT_NEAR(springs.force().value, 0.2, 1e-12);
  EXPECT_GT(springs.radius(), 0);
}

TEST(Springs, PressureIsThatOfHertzForAnElasticBody) {
  const auto creep = ContactCreep::against_rigid(ViscoelasticMaterial::elastic(Material::elastic(3, 0)));
  auto springs = Springs::under(paraboloid(1), creep, 0.5, 2000);
  springs.advance_to_approach(1, 0.09);
  for (const double r : {0., 0.1, 0.29}) {
    EXPECT_NEAR(springs.pressure(r), 2 * 3 / M_PI * std::sqrt(0.09 - r * r), 2e-3);
  }
  EXPECT_EQ(springs.pressure(0.31), 0);
}

TEST(Springs, RadiusIsRightToItsShareOfTheDistance) {
  const auto creep = ContactCreep::against_rigid(ViscoelasticMaterial::elastic(Material::elastic(3, 0)));
  std::mt19937_64 engine(20060413);
  double worst = 0;
  for (int i = 0; i < cases(300); ++i) {
    auto springs = Springs::under(paraboloid(1), creep, 0.5, 50);
    const double delta = uniform(engine, 0.01, 0.24);  // from ten springs on
    springs.advance_to_approach(1, delta);
    worst = std::max(worst, std::abs(springs.radius() - std::sqrt(delta)) / springs.distance());
  }
  RecordProperty("worst_share", std::to_string(worst));
  EXPECT_LE(worst, Springs::radius_share);
}

TEST(Springs, BadInputIsRefused) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  std::mt19937_64 engine(1);
  const auto creep = any_solid(engine);
  auto springs = Springs::under(paraboloid(1), creep, 0.1, 50);
  EXPECT_THAT([&] { Springs::under(paraboloid(1), creep, -1, 50); },
              refused("widest = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT([&] { Springs::under(paraboloid(1), creep, 1, 3); },
              refused("count = 3 is not allowed: must lie in [4, 1e+07]"));
  EXPECT_THAT([&] { springs.advance_to_approach(-1, 0); },
              refused("duration = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([&] { springs.advance_to_approach(1, 0.1); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  ::testing::StartsWith("approach = 0.1 is not allowed: must lie in [")));
  EXPECT_THAT([&] { springs.advance_to_force(1, -2); },
              refused("force = -2 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([&] { springs.advance_to_force(1, 1e9); },
              refused("force = 1e+09 is not allowed: must leave the radius within `widest`"));
  // What was refused did not happen.
  EXPECT_EQ(springs.approach(), 0);
  EXPECT_EQ(springs.force().value, 0);
}

}  // namespace
}  // namespace patchgrip::contact
