#include <patchgrip/contact/creep/cycles.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/creep/press_at_approach.h>
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

using RoundCycles = Cycles<PowerProfile>;

ContactCreep any_solid(std::mt19937_64& engine, bool is_fluid = false) {
  Modes<double> modes;
  for (int i = std::uniform_int_distribution<int>(1, 4)(engine); i > 0; --i) {
    modes.push_back({log_uniform(engine, 0.1, 10), log_uniform(engine, 1e-2, 1e2)});
  }
  const auto modulus = RelaxationModulus::of(is_fluid ? 0 : 1, std::move(modes));
  return ContactCreep::against_rigid(ViscoelasticMaterial::of(modulus, 0.3));
}

// Up and down, with holds and jumps, off the surface now and then; starts at rest.
History any_approach(std::mt19937_64& engine, int count) {
  std::vector<HistoryPoint<double>> points{{0, 0}};
  for (int k = 0; k < count; ++k) {
    const double time = points.back().time + log_uniform(engine, 0.05, 3);
    const int kind = std::uniform_int_distribution<int>(0, 5)(engine);
    const double value = kind == 0 ? points.back().value : uniform(engine, -0.03, 0.1);
    points.push_back({time, value});
    if (kind == 1) points.push_back({time, uniform(engine, -0.03, 0.1)});
  }
  return History::points(points);
}

double end_of(const History& history) { return history.pieces().back().start; }

TEST(Cycles, AgreeWithTheTable) {
  const auto rows = contact_rows("visco_two_cycles");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto modulus = RelaxationModulus::of(row.input("E_inf"), {{row.input("E_1"), row.input("tau_1")}});
    const auto approach = History::points({{0, 0},
                                           {row.input("t_1"), row.input("d_1")},
                                           {row.input("t_2"), row.input("d_2")},
                                           {row.input("t_3"), row.input("d_3")}});
    const auto cycles =
        RoundCycles::of(paraboloid(row.input("R")),
                        ContactCreep::against_rigid(ViscoelasticMaterial::of(modulus, row.input("nu"))), approach);
    const auto zone = cycles.zone(row.input("t"));
    EXPECT_LE(units_of_rounding(zone.radius, row.output("a_K")), 8);
    EXPECT_LE(units_of_rounding(cycles.radius(row.input("t_2")), row.output("a_min")), 8);
    EXPECT_LE(units_of_rounding(zone.force.value, row.output("F_N")), 16);
    EXPECT_LE(std::abs(static_cast<double>(Exact(zone.force.value) - row.output("F_N"))), zone.force.error);
    EXPECT_LE(zone.force.error, 1e-12 * zone.force.value);
    EXPECT_TRUE(zone.is_one_circle);
    EXPECT_TRUE(zone.stress_falls);
  }
}

// Ting's equation and independent springs share nothing but the materials.
TEST(Cycles, OfOnePressAreTing) {
  std::mt19937_64 engine(20060461);
  for (int i = 0; i < cases(12); ++i) {
    const auto creep = any_solid(engine, i % 4 == 0);
    const auto approach = History::points({{0, 0}, {0.3, 0.02}, {uniform(engine, 0.4, 2), 0.1}, {2.5, 0}});
    const auto press = PressAtApproach<PowerProfile>::of(paraboloid(1), creep, approach, 2.5);
    const auto cycles = RoundCycles::of(paraboloid(1), creep, approach);
    for (const double part : {0.1, 0.5, 0.8, 0.97}) {
      const double t = part * press.valid_until();
      const auto zone = cycles.zone(t);
      const auto force = press.force(t);
      EXPECT_NEAR(zone.radius / press.radius(t), 1, 1e-11);
      EXPECT_LE(std::abs(zone.force.value - force.value), zone.force.error + force.error);
      const double r = uniform(engine, 0.01, 0.99) * zone.radius;
      const auto p = cycles.pressure(r, t), q = press.pressure(r, t);
      EXPECT_LE(std::abs(p.value - q.value), p.error + q.error) << p.value << " " << q.value;
      EXPECT_NEAR(p.value / q.value, 1, 1e-5);
    }
    EXPECT_LE(cycles.zone(std::min(2.5, press.contact_lost() * (1 + 1e-9))).force.value, 1e-9);
  }
}

TEST(Cycles, PressureHoldsItsErrorUpToTheAxis) {
  std::mt19937_64 engine(20060462);
  for (int i = 0; i < cases(8); ++i) {
    const auto creep = any_solid(engine, i % 4 == 0);
    const auto approach = History::points({{0, 0}, {uniform(engine, 0.4, 2), 0.1}, {2.5, 0}});
    const auto press = PressAtApproach<PowerProfile>::of(paraboloid(1), creep, approach, 2.5);
    const auto cycles = RoundCycles::of(paraboloid(1), creep, approach);
    for (const double part : {0.1, 0.5, 0.8}) {
      const double t = part * press.valid_until();
      for (const double r : {0., 1e-300, 1e-12, 1e-6, 1e-3, 0.0137, 0.0143, 0.1}) {
        const auto p = cycles.pressure(r * cycles.radius(t), t), q = press.pressure(r * cycles.radius(t), t);
        EXPECT_LE(std::abs(p.value - q.value), p.error + q.error) << i << ": r/a = " << r;
        EXPECT_LE(p.error, 1e-4 * q.value) << i << ": r/a = " << r;
      }
    }
  }
}

RC_GTEST_PROP(Cycles, OfAnElasticBodyForget, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto creep = ContactCreep::against_rigid(ViscoelasticMaterial::elastic(Material::elastic(3, 0.5)));
  const auto approach = any_approach(engine, 6);
  const double t = uniform(engine, 0, 1.2) * end_of(approach);
  const double delta = std::max(0., approach(t));
  const auto zone = RoundCycles::of(paraboloid(0.5), creep, approach).zone(t);
  RC_ASSERT(std::abs(zone.force.value - 4. / 3. * 4 * std::sqrt(0.5) * std::pow(delta, 1.5)) <= 1e-12);
  RC_ASSERT(std::abs(zone.radius - std::sqrt(0.5 * delta)) <= 1e-12);
}

// A press soon after another meets a dent; long after, a surface that has forgotten.
TEST(Cycles, SurfacesRecover) {
  const auto creep =
      ContactCreep::against_rigid(ViscoelasticMaterial::of(PoyntingThomson::of(3e4, 1e4, 3e3).modulus(), 0.5));
  const auto second = [&](double pause) {
    const auto approach = History::points({{0, 0}, {1, 1e-3}, {1, -1e-3}, {1 + pause, 0}, {2 + pause, 1e-3}});
    return RoundCycles::of(paraboloid(0.02), creep, approach).zone(2 + pause).force.value;
  };
  const double first =
      RoundCycles::of(paraboloid(0.02), creep, History::points({{0, 0}, {1, 1e-3}})).zone(1).force.value;
  EXPECT_LT(second(0.01), 0.999 * first);
  EXPECT_LT(second(0.01), second(0.3));
  EXPECT_NEAR(second(100) / first, 1, 1e-12);
  // A fluid keeps it for good.
  const auto fluid = ContactCreep::against_rigid(ViscoelasticMaterial::of(maxwell(3e4, 3e3), 0.5));
  const auto approach = History::points({{0, 0}, {1, 1e-3}, {1, -1e-3}, {1e6, 0}, {1e6 + 1, 9e-4}});
  EXPECT_LT(RoundCycles::of(paraboloid(0.02), fluid, approach).zone(1e6 + 1).force.value, 0.5 * first);
}

// The spring law over a free time: the stress stays zero, the state is one.
RC_GTEST_PROP(SpringLaw, SplittingAStepChangesNothing, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const SpringLaw law(any_solid(engine, seed % 5 == 0));
  std::vector<double> whole_modes(law.modes()), part_modes(law.modes());
  Spring whole, part;
  double d = 0;
  for (int k = 0; k < 8; ++k) {
    const double next = uniform(engine, -0.5, 1), h = log_uniform(engine, 1e-2, 3);
    law.advance(whole, whole_modes, d, (next - d) / h, h);
    const int pieces = 5;
    for (int i = 0; i < pieces; ++i)
      law.advance(part, part_modes, d + (next - d) * i / pieces, (next - d) / h, h / pieces);
    d = next;
    RC_ASSERT(whole.is_touching == part.is_touching);
    RC_ASSERT(std::abs(law.stress(whole, whole_modes) - law.stress(part, part_modes)) < 1e-11);
    RC_ASSERT(std::abs(whole.depth - part.depth) < 1e-12);
    // No spring pulls, none is left behind by the stamp.
    RC_ASSERT(law.stress(whole, whole_modes) >= -1e-13);
    RC_ASSERT(whole.depth >= d - 1e-14);
    if (!whole.is_touching) {
      double rest = law.creep().modulus.equilibrium() * whole.depth;
      for (const double q : whole_modes) rest += q;
      RC_ASSERT(std::abs(rest) < 1e-12);
    }
  }
}

// From rest, no history gives work back that was not put in.
RC_GTEST_PROP(SpringLaw, IsPassive, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const SpringLaw law(any_solid(engine, seed % 5 == 0));
  std::vector<double> modes(law.modes());
  Spring spring;
  double d = 0, work = 0;
  for (int k = 0; k < 10; ++k) {
    const double next = uniform(engine, -0.5, 1), h = log_uniform(engine, 1e-2, 3);
    const int pieces = 400;
    for (int i = 0; i < pieces; ++i) {
      const double before = law.stress(spring, modes);
      law.advance(spring, modes, d + (next - d) * i / pieces, (next - d) / h, h / pieces);
      work += (before + law.stress(spring, modes)) / 2 * (next - d) / pieces;
    }
    d = next;
    RC_ASSERT(work >= -1e-4);
  }
}

TEST(SpringLaw, MeetsAndLeavesAJumpAtOnce) {
  const SpringLaw law(ContactCreep::against_rigid(ViscoelasticMaterial::of(PoyntingThomson::of(3, 1, 1).modulus(), 0)));
  std::vector<double> modes(1);
  Spring spring;
  law.jump(spring, modes, -1);
  EXPECT_FALSE(spring.is_touching);
  law.jump(spring, modes, 0.5);
  EXPECT_TRUE(spring.is_touching);
  EXPECT_DOUBLE_EQ(law.stress(spring, modes), 2);
  law.advance(spring, modes, 0.5, 0, 1e3);
  EXPECT_DOUBLE_EQ(law.stress(spring, modes), 0.5);
  law.jump(spring, modes, 0);
  // It follows as far as it can at once, to 0.375, then creeps home.
  EXPECT_FALSE(spring.is_touching);
  EXPECT_DOUBLE_EQ(spring.depth, 0.375);
  law.advance(spring, modes, -1, 0, 1);
  EXPECT_DOUBLE_EQ(spring.depth, 0.375 * std::exp(-0.75));
}

TEST(Cycles, CoursesOfDifferentPiecesDiffer) {
  std::vector<std::uint64_t> courses{0};
  constexpr std::size_t pieces = 60;
  for (std::size_t i = 0; i < pieces; ++i) {
    const auto first = next_course(0, i);
    courses.push_back(first);
    for (std::size_t j = 0; j < pieces; ++j) {
      const auto second = next_course(first, j);
      courses.push_back(second);
      for (std::size_t k = 0; k < pieces; ++k) courses.push_back(next_course(second, k));
    }
  }
  std::sort(courses.begin(), courses.end());
  EXPECT_EQ(std::adjacent_find(courses.begin(), courses.end()), courses.end());
}

TEST(Cycles, BadInputIsRefused) {
  std::mt19937_64 engine(1);
  const auto creep = any_solid(engine);
  EXPECT_THAT(
      [&] { RoundCycles::of(paraboloid(1), creep, History::half_sine(1, 1)); },
      ::testing::ThrowsMessage<std::invalid_argument>("amplitude = 1 is not allowed: must be 0: straight pieces only"));
  const auto dashpot = ContactCreep::against_rigid(ViscoelasticMaterial::of(kelvin_voigt(1, 1), 0));
  EXPECT_THAT([&] { RoundCycles::of(paraboloid(1), dashpot, History::ramp(1)); },
              ::testing::ThrowsMessage<std::invalid_argument>("dashpot = 1 is not allowed: must lie in [0, 0]"));
  const auto cycles = RoundCycles::of(paraboloid(1), creep, History::ramp(1));
  EXPECT_THAT([&] { cycles.zone(-1); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::StartsWith("time = -1")));
  EXPECT_THAT([&] { cycles.zone(NAN); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::StartsWith("time = nan")));
  EXPECT_EQ(cycles.zone(0).force.value, 0);
  EXPECT_EQ(cycles.pressure(2, 1).value, 0);
}

}  // namespace
}  // namespace patchgrip::contact
