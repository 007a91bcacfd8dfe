#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <patchgrip/contact/cone.h>
#include <patchgrip/contact/creep/press_at_approach.h>
#include <patchgrip/contact/creep/press_under_force.h>
#include <patchgrip/tests/contact/creep_table.h>
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

using UnderForce = PressUnderForce<PowerProfile>;
using AtApproach = PressAtApproach<PowerProfile>;

::testing::AssertionResult holds(const Estimate& estimate, const Exact& exact, double most) {
  const double off = static_cast<double>(abs(Exact(estimate.value) - exact));
  if (off > estimate.error) return ::testing::AssertionFailure() << "off by " << off << ", stated " << estimate.error;
  if (estimate.error > most * std::abs(estimate.value)) {
    return ::testing::AssertionFailure() << "stated " << estimate.error / estimate.value << " of the value";
  }
  return ::testing::AssertionSuccess();
}

double units(const Estimate& estimate, const Exact& exact) { return units_of_rounding(estimate.value, exact); }

ContactCreep solid(double E1, double E2, double eta) {
  return ContactCreep::against_rigid(ViscoelasticMaterial::of(PoyntingThomson::of(E1, E2, eta).modulus(), 0.5));
}

TEST(PressUnderForce, StepsAndRampsAgreeWithTheTable) {
  for (const auto& row : contact_rows("visco_step")) {
    const double t = row.input("t");
    const auto press =
        UnderForce::of(paraboloid(row.input("R")), poynting_thomson_of(row), History::step(row.input("F0")), 3);
    EXPECT_LE(units(press.approach(t), row.output("delta_exact_LR")), 10);
    EXPECT_LE(units_of_rounding(press.radius(t), row.output("a_exact_LR")), 6);
    EXPECT_TRUE(holds(press.pressure(0, t), row.output("p_centre_exact_LR"), 1e-12));
    EXPECT_LE(units(press.pressure(0, t), row.output("p_centre_exact_LR")), 20);
    EXPECT_EQ(press.grows_until(), 3);
  }
  for (const auto& row : contact_rows("visco_ramp")) {
    const double t = row.input("t");
    const auto press =
        UnderForce::of(paraboloid(row.input("R")), poynting_thomson_of(row), History::ramp(row.input("rate")), 3);
    EXPECT_LE(units(press.approach(t), row.output("delta_exact_LR")), 10);
    EXPECT_LE(units_of_rounding(press.radius(t), row.output("a_exact_LR")), 6);
  }
}

TEST(PressUnderForce, HalfSinesAgreeWithTheTable) {
  const auto rows = contact_rows("visco_halfsine");
  ASSERT_EQ(rows.size(), 12U);
  for (const auto& row : rows) {
    const double t = row.input("t");
    const auto press = UnderForce::of(paraboloid(row.input("R")), poynting_thomson_of(row),
                                      History::half_sine(row.input("F0"), row.input("omega")), 1.5);
    EXPECT_LE(units_of_rounding(press.grows_until(), row.output("t_max_radius")), 4);
    EXPECT_TRUE(holds(press.approach(t), row.output("delta_exact_Ting"), 1e-12));
    EXPECT_LE(units(press.approach(t), row.output("delta_exact_Ting")), 12);
    EXPECT_LE(units_of_rounding(press.radius(t), row.output("a_exact_Ting")), 12);
    EXPECT_DOUBLE_EQ(press.valid_until(), 1);  // lost with the force
  }
}

TEST(PressUnderForce, TrianglesAgreeWithTheTable) {
  const auto rows = contact_rows("ting_force_triangle");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const double t = row.input("t");
    const auto press = UnderForce::of(paraboloid(row.input("R")), prony_of(row),
                                      History::triangle(row.input("rate"), row.input("t_p")), 4);
    EXPECT_LE(units_of_rounding(press.grows_until(), row.output("t_max_radius")), 4);
    EXPECT_LE(units_of_rounding(press.radius(press.grows_until()), row.output("a_max")), 8);
    EXPECT_LE(units_of_rounding(press.earlier_time(t), row.output("t1")), 16);
    EXPECT_LE(units_of_rounding(press.radius(t), row.output("a_K")), 16);
    EXPECT_TRUE(holds(press.approach(t), row.output("delta"), 1e-12));
    EXPECT_LE(units(press.approach(t), row.output("delta")), 16);
  }
}

TEST(PressUnderForce, BareDashpotsAndFluidsAgreeWithTheTable) {
  const auto check = [](const ContactRow& row, const RelaxationModulus& modulus) {
    const auto contact = ContactCreep::against_rigid(ViscoelasticMaterial::of(modulus, row.input("nu")));
    const auto press = UnderForce::of(paraboloid(row.input("R")), contact, History::step(row.input("F0")), 2);
    EXPECT_LE(units(press.approach(row.input("t")), row.output("delta")), 8);
    EXPECT_LE(units_of_rounding(press.radius(row.input("t")), row.output("a_K")), 6);
    return press;
  };
  for (const auto& row : contact_rows("kelvin_voigt_step")) {
    const auto press = check(row, kelvin_voigt(row.input("E_2"), row.input("eta")));
    EXPECT_EQ(press.radius(0), 0);
    EXPECT_THAT([&] { press.pressure(0, 0.1); },
                ::testing::ThrowsMessage<std::invalid_argument>(
                    "instantaneous compliance = 0 is not allowed: must be positive and finite"));
  }
  for (const auto& row : contact_rows("maxwell_step")) check(row, maxwell(row.input("E_1"), row.input("eta")));
}

TEST(PressUnderForce, PowerProfilesAgreeWithTheTable) {
  const auto rows = contact_rows("visco_step_power_profile");
  ASSERT_EQ(rows.size(), 6U);
  for (const auto& row : rows) {
    const auto press = UnderForce::of(PowerProfile::of_coefficient(row.input("A"), row.input("d")),
                                      poynting_thomson_of(row), History::step(row.input("F0")), 1);
    EXPECT_LE(units_of_rounding(press.radius(row.input("t")), row.output("a_exact_LR")), 12);
    EXPECT_LE(units(press.approach(row.input("t")), row.output("delta_exact_LR")), 16);
  }
}

TEST(PressUnderForce, OfTwoBodiesAgreesWithTheTable) {
  for (const auto& row : contact_rows("visco_two_bodies_step")) {
    const auto creep = ContactCreep::between(
        ViscoelasticMaterial::of(
            PoyntingThomson::of(row.input("E1_p"), row.input("E2_p"), row.input("eta_p")).modulus(), row.input("nu_p")),
        ViscoelasticMaterial::of(
            PoyntingThomson::of(row.input("E1_m"), row.input("E2_m"), row.input("eta_m")).modulus(),
            row.input("nu_m")));
    const auto press = UnderForce::of(paraboloid(row.input("R")), creep, History::step(row.input("F0")), 1);
    EXPECT_LE(units(press.approach(row.input("t")), row.output("delta")), 8);
    EXPECT_LE(units_of_rounding(creep.secant_modulus(0), row.output("E_star_0")), 3);
    EXPECT_LE(units_of_rounding(creep.secant_modulus(row.input("t")), row.output("E_star_eff")), 5);
  }
}

TEST(PressAtApproach, AgreesWithTheTable) {
  for (const auto& row : contact_rows("ting_approach_triangle")) {
    const double t = row.input("t");
    const auto press = AtApproach::of(paraboloid(row.input("R")), prony_of(row),
                                      History::triangle(row.input("v"), row.input("t_m")), 1);
    EXPECT_LE(units_of_rounding(press.contact_lost(), row.output("t_contact_lost")), 8);
    EXPECT_LE(units_of_rounding(press.earlier_time(t), row.output("t1")), 16);
    EXPECT_LE(units_of_rounding(press.radius(t), row.output("a_K")), 16);
    EXPECT_TRUE(holds(press.force(t), row.output("F_N"), 1e-12));
    EXPECT_LE(units(press.force(t), row.output("F_N")), 24);
  }
  for (const auto& row : contact_rows("prony_approach_ramp_hold")) {
    const double t = row.input("t"), hold = row.input("t_1");
    const auto press = AtApproach::of(paraboloid(row.input("R")), prony_of(row),
                                      History::points({{0, 0}, {hold, row.input("v") * hold}}), 3);
    EXPECT_LE(units_of_rounding(press.radius(t), row.output("a_K")), 6);
    EXPECT_TRUE(holds(press.force(t), row.output("F_N"), 1e-12));
    EXPECT_LE(units(press.force(t), row.output("F_N")), 16);
  }
}

ContactCreep any_solid(std::mt19937_64& engine) {
  Modes<double> modes;
  for (int i = std::uniform_int_distribution<int>(1, 4)(engine); i > 0; --i) {
    modes.push_back({log_uniform(engine, 0.1, 10), log_uniform(engine, 1e-2, 1e2)});
  }
  return ContactCreep::against_rigid(ViscoelasticMaterial::of(RelaxationModulus::of(1, std::move(modes)), 0.3));
}

// Where the growing contact stood at a kink of the force, p has a part like sqrt(r_k^2 - r^2) at r < r_k: between two
// such radii r^2 = lo^2 + (hi^2 - lo^2) sin^2(s), in which p is smooth.
double carried_force(const UnderForce& press, double t) {
  std::vector<double> radii{0};
  for (const auto& piece : press.load().force().pieces()) {
    if (piece.start > 0 && piece.start < press.earlier_time(t)) radii.push_back(press.radius(piece.start));
  }
  radii.push_back(press.radius(t));
  double carried = 0;
  for (std::size_t k = 0; k + 1 < radii.size(); ++k) {
    const double lo = radii[k], hi = radii[k + 1], width = (hi - lo) * (hi + lo);
    carried += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
        [&](double s) {
          const double sine = std::sin(s);
          return 2 * M_PI * width * sine * std::cos(s) *
                 press.pressure(std::sqrt(lo * lo + width * sine * sine), t).value;
        },
        0., M_PI / 2, 6, 1e-12);
  }
  return carried;
}

// The pressure carries the force, while the contact grows and while it shrinks.
TEST(PressUnderForce, PressureCarriesTheForce) {
  std::mt19937_64 engine(20060431);
  for (int i = 0; i < cases(8); ++i) {
    const auto force = i % 2 == 0 ? History::half_sine(2, 1) : History::triangle(1, 1.5);
    const auto press = UnderForce::of(paraboloid(1), any_solid(engine), force, 3);
    for (const double part : {0.3, 0.7, 0.95}) {
      const double t = part * press.valid_until();
      EXPECT_NEAR(carried_force(press, t) / force(t), 1, 1e-11) << i << " at " << part;
    }
  }
}

// A force to the points between which straight lines miss it by at most `miss` of it, or of a hundredth of `largest`.
void sample_force(const AtApproach& press, HistoryPoint<double> from, HistoryPoint<double> to, double miss,
                  double largest, std::vector<HistoryPoint<double>>& points) {
  const double middle = (from.time + to.time) / 2, force = press.force(middle).value;
  if (std::abs((from.value + to.value) / 2 - force) > miss * std::max(force, 0.01 * largest)) {
    sample_force(press, from, {middle, force}, miss, largest, points);
    sample_force(press, {middle, force}, to, miss, largest, points);
  } else {
    points.push_back(to);
  }
}

// Force to approach and back: two routes that share no formula of the shrinking contact. The force is known at points:
// where it is off by a part e at any time, so is X = C_0 F + int C'(t - s) F ds, the radius ~ X^(1/3) by e / 3 and the
// approach ~ X^(2/3) by 2 e / 3.
TEST(Press, UnderForceAndAtApproachAreOneContact) {
  std::mt19937_64 engine(20060432);
  const double miss = 3e-3;
  for (int i = 0; i < cases(2); ++i) {
    const auto creep = any_solid(engine);
    const double kink = 1;
    const auto approach = History::triangle(0.1, kink);
    const auto driven = AtApproach::of(paraboloid(1), creep, approach, 2);
    const double end = 0.98 * driven.valid_until();
    const HistoryPoint<double> highest{kink, driven.force(kink).value};
    std::vector<HistoryPoint<double>> points{{0, 0}};
    sample_force(driven, points[0], highest, miss, highest.value, points);
    sample_force(driven, highest, {end, driven.force(end).value}, miss, highest.value, points);
    const auto pressed = UnderForce::of(paraboloid(1), creep, History::points(points), end);
    for (const double part : {0.3, 0.8}) {
      const double t = part * pressed.valid_until();
      EXPECT_NEAR(pressed.radius(t) / driven.radius(t), 1, miss / 2) << i << " at " << part;
      EXPECT_NEAR(pressed.approach(t).value / approach(t), 1, miss) << i << " at " << part;
    }
  }
}

RC_GTEST_PROP(PressAtApproach, ShrinksMonotonicallyAfterThePeak, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto press = AtApproach::of(paraboloid(1), any_solid(engine), History::triangle(0.1, 1), 2);
  RC_ASSERT(press.contact_lost() <= 2);
  RC_ASSERT(press.contact_lost() == press.valid_until());
  double before = press.radius(press.grows_until());
  for (int k = 1; k <= 10; ++k) {
    const double a = press.radius(press.grows_until() + (press.contact_lost() - press.grows_until()) * k / 10);
    RC_ASSERT(a < before);
    before = a;
  }
  RC_ASSERT(press.force(press.contact_lost()).value <= 1e-5 * press.force(press.grows_until()).value);
}

RC_GTEST_PROP(Press, DoesNotKnowWhatTimeItIs, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto creep = any_solid(engine);
  const double shift = 0.75;
  const auto now = AtApproach::of(paraboloid(1), creep, History::points({{0, 0}, {1, 0.1}, {2, 0}}), 2);
  const auto later =
      AtApproach::of(paraboloid(1), creep, History::points({{shift, 0}, {1 + shift, 0.1}, {2 + shift, 0}}), 2 + shift);
  const double t = uniform(engine, 0.1, 0.9) * now.valid_until();
  RC_ASSERT(std::abs(later.radius(t + shift) / now.radius(t) - 1) < 1e-12);
  RC_ASSERT(std::abs(later.force(t + shift).value / now.force(t).value - 1) < 1e-11);
}

TEST(Press, OfAnElasticBodyIsElastic) {
  const auto creep = ContactCreep::against_rigid(ViscoelasticMaterial::elastic(Material::elastic(3e4, 0.5)));
  const auto press = UnderForce::of(paraboloid(0.02), creep, History::half_sine(10, 1), 3.2);
  for (const double t : {0.4, 1.5, 2.9}) {
    const auto contact = AxisymmetricContact<PowerProfile>::under_force(paraboloid(0.02), 10 * std::sin(t), 4e4);
    EXPECT_NEAR(press.radius(t) / contact.radius(), 1, 1e-14);
    EXPECT_NEAR(press.approach(t).value / contact.approach(), 1, 1e-14);
    EXPECT_NEAR(press.pressure(0.5 * contact.radius(), t).value / contact.pressure(0.5 * contact.radius()), 1, 1e-13);
  }
}

// A press that begins with a jump: what it reached at once is left in one instant of its past.
TEST(Press, ShrinksIntoTheJumpItBeganWith) {
  const auto creep = solid(25000, 25000, 5000);
  const auto press = UnderForce::of(paraboloid(0.02), creep, History::points({{0, 10}, {0.2, 10}, {0.6, 0}}), 0.6);
  EXPECT_EQ(press.grows_until(), 0.2);
  const double t = 0.55;
  EXPECT_EQ(press.earlier_time(t), 0);
  // M(t) X_1 = F(t): all of what is left was reached at t = 0.
  const double X = History::points({{0, 10}, {0.2, 10}, {0.6, 0}})(t) / creep.modulus(t);
  EXPECT_NEAR(press.radius(t) / paraboloid(0.02).radius_of_force(X), 1, 1e-13);
  EXPECT_LT(press.radius(t), press.radius(0));
}

// Histories are those just after a jump, and so are radius and approach.
TEST(Press, AtAJumpIsThePressJustAfterIt) {
  const auto creep = solid(30e3, 20e3, 9e3);
  const std::vector<std::vector<HistoryPoint<double>>> forces{{{0, 0}, {1, 1}, {1, 0.2}, {1.1, 0}},
                                                              {{0, 1}, {1, 1}, {1, 0.5}, {1.1, 0}},
                                                              {{0, 0.5}, {1, 1}, {1, 1.5}, {3, 1.5}}};
  for (const auto& points : forces) {
    const auto press = UnderForce::of(paraboloid(0.02), creep, History::points(points), 1.05);
    const double at = press.radius(1), after = press.radius(1 + 1e-9), before = press.radius(1 - 1e-9);
    EXPECT_NEAR(at / after, 1, 1e-7);
    EXPECT_GT(std::abs(before / after - 1), 1e-2);
    EXPECT_NEAR(press.approach(1).value / press.approach(1 + 1e-9).value, 1, 1e-7);
  }
}

TEST(Press, AModeThatNobodyCanFeelChangesNothing) {
  const auto creep = [](Modes<double> modes) {
    return ContactCreep::against_rigid(ViscoelasticMaterial::of(RelaxationModulus::of(20e3, std::move(modes)), 0.5));
  };
  const auto force = History::points({{0, 0}, {1, 1}, {2, 0.5}});
  const auto with = UnderForce::of(paraboloid(0.02), creep({{30e3, 0.3}, {1e-32, 10}}), force, 2);
  const auto without = UnderForce::of(paraboloid(0.02), creep({{30e3, 0.3}}), force, 2);
  for (const double t : {0.5, 1., 1.5, 2.}) EXPECT_NEAR(with.radius(t) / without.radius(t), 1, 1e-14);
}

TEST(Press, EndsWhereTheContactGrowsAgain) {
  const auto creep = solid(100000, 25000, 8000);
  // Off quickly, then held: the surface comes back and the contact grows.
  const auto held = UnderForce::of(paraboloid(0.02), creep, History::points({{0, 0}, {1, 10}, {1.1, 3}}), 5);
  EXPECT_EQ(held.grows_until(), 1);
  EXPECT_DOUBLE_EQ(held.valid_until(), 1.1);
  EXPECT_THAT([&] { held.radius(1.2); },
              ::testing::ThrowsMessage<std::invalid_argument>("time = 1.2 is not allowed: must lie in [0, 1.1]"));
  const auto driven = AtApproach::of(paraboloid(0.02), creep, History::points({{0, 0}, {1, 1e-3}, {1.02, 8e-4}}), 5);
  EXPECT_DOUBLE_EQ(driven.valid_until(), 1.02);
  const auto again =
      AtApproach::of(paraboloid(0.02), creep, History::points({{0, 0}, {1, 1e-3}, {1.1, 9e-4}, {2, 2e-3}}), 2);
  EXPECT_DOUBLE_EQ(again.valid_until(), 1.1);
}

// Held until nothing is left to relax, then let go in part: what the contact grows by is below its rounding.
TEST(Press, RestsAfterARelease) {
  const auto creep = solid(1e6, 0.5e6, 2e5);  // relaxes within 0.2 or 0.4 s
  const auto force = [](double held) { return History::points({{0, 1}, {held, 1}, {held, 0.2}, {2 * held, 0.2}}); };
  const auto press = UnderForce::of(paraboloid(0.015), creep, force(20), 40);
  EXPECT_EQ(press.valid_until(), 40);
  const double relaxed = press.radius(20);
  for (const double t : {20.5, 25., 30., 40.}) EXPECT_NEAR(press.radius(t) / relaxed, 1, 1e-14) << t;
  // Let go early it does grow.
  EXPECT_DOUBLE_EQ(UnderForce::of(paraboloid(0.015), creep, force(0.2), 0.4).valid_until(), 0.2);
}

TEST(Press, TheTipOfAConePressesWithoutLimit) {
  const auto press = PressUnderForce<Cone>::of(Cone::of_slope(0.1), solid(25000, 25000, 5000), History::ramp(1), 1);
  EXPECT_EQ(press.pressure(0, 0.5).value, INFINITY);
  EXPECT_LT(press.pressure(1e-6, 0.5).value, INFINITY);
  EXPECT_EQ(press.pressure(2 * press.radius(0.5), 0.5).value, 0);
}

TEST(Press, BadInputIsRefused) {
  const auto creep = solid(1, 1, 1);
  EXPECT_THAT([&] { UnderForce::of(paraboloid(1), creep, History::step(1), 0); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "until = 0 is not allowed: must be finite and after the start of the force"));
  EXPECT_THAT(
      [&] { UnderForce::of(paraboloid(1), creep, History::step(-1), 1); },
      ::testing::ThrowsMessage<std::invalid_argument>("force = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([&] { AtApproach::of(paraboloid(1), creep, History::step(1), NAN); },
              ::testing::ThrowsMessage<std::invalid_argument>(
                  "until = nan is not allowed: must be finite and after the start of the approach"));
  const auto dashpot = ContactCreep::against_rigid(ViscoelasticMaterial::of(kelvin_voigt(1, 1), 0.5));
  EXPECT_THAT([&] { AtApproach::of(paraboloid(1), dashpot, History::ramp(1), 1); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::StartsWith("dashpot = 1.33")));
  const auto press = UnderForce::of(paraboloid(1), creep, History::ramp(1), 1);
  EXPECT_THAT([&] { press.radius(NAN); },
              ::testing::ThrowsMessage<std::invalid_argument>("time = nan is not allowed: must lie in [0, 1]"));
  EXPECT_THAT([&] { press.pressure(-1, 0.5); }, ::testing::ThrowsMessage<std::invalid_argument>(
                                                    "r = -1 is not allowed: must be non-negative and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
