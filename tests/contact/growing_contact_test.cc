#include <patchgrip/contact/creep/growing_contact.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/creep/load_integral.h>
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

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

CreepCompliance any_compliance(std::mt19937_64& engine) {
  Modes<double> modes;
  for (int i = std::uniform_int_distribution<int>(1, 8)(engine); i > 0; --i) {
    modes.push_back({log_uniform(engine, 1e-3, 1), log_uniform(engine, 1e-6, 1e6)});
  }
  const bool has_spring = std::uniform_int_distribution<int>(0, 3)(engine) != 0;
  const bool is_fluid = std::uniform_int_distribution<int>(0, 3)(engine) == 0;
  return CreepCompliance::of(has_spring ? log_uniform(engine, 1e-3, 1) : 0, std::move(modes),
                             is_fluid ? log_uniform(engine, 1e-6, 1) : 0);
}

std::vector<HistoryPoint<double>> growing_points(std::mt19937_64& engine) {
  std::vector<HistoryPoint<double>> points;
  double time = 0, value = std::uniform_int_distribution<int>(0, 1)(engine) == 0 ? 0 : uniform(engine, 0, 1);
  for (int k = std::uniform_int_distribution<int>(1, 6)(engine); k > 0; --k) {
    points.push_back({time, value});
    time += log_uniform(engine, 1e-6, 1e3);
    value += log_uniform(engine, 1e-6, 1e6);
  }
  return points;
}

TEST(LoadIntegral, OfForcesThatDoNotFallIsRoundedAsStated) {
  std::mt19937_64 engine(20060421);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const auto compliance = any_compliance(engine);
    const auto points = growing_points(engine);
    std::vector<HistoryPoint<Exact>> exact_points;
    for (const auto& point : points) exact_points.push_back({point.time, point.value});
    const double t = points.back().time + log_uniform(engine, 1e-6, 1e3);
    const double value = load_integral(compliance, History::points(points), t);
    const Exact exact =
        load_integral(compliance_as<Exact>(compliance), BasicHistory<Exact>::points(exact_points), Exact(t));
    if (exact == 0) continue;
    worst = std::max(worst, units_of_rounding(value, exact) - 0.5 * static_cast<double>(compliance.modes().size()));
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 12);
}

TEST(LoadIntegral, OfStepAndRampAreTheirClosedForms) {
  const auto solid = PoyntingThomson::of(25000, 25000, 5000);
  const auto compliance = creep_compliance(solid.modulus());
  for (const double t : {1e-6, 0.05, 0.5, 40.}) {
    const Exact alpha = 2.5, K0 = Exact(2) / 100000;
    const Exact step = 10 * K0 * (1 + (1 - exp(-alpha * t)));
    const Exact ramp = 20 * K0 * (2 * Exact(t) - (1 - exp(-alpha * t)) / alpha);
    EXPECT_LE(units_of_rounding(load_integral(compliance, History::step(10), t), step), 6);
    EXPECT_LE(units_of_rounding(load_integral(compliance, History::ramp(20), t), ramp), 6);
  }
}

TEST(LoadIntegral, AgreesWithTheTable) {
  const auto rows = contact_rows("prony_piecewise_load");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const auto contact = prony_of(row);
    const auto force = History::points({{0, row.input("F_0")},
                                        {row.input("t_1"), row.input("F_1")},
                                        {row.input("t_2"), row.input("F_2")},
                                        {row.input("t_3"), row.input("F_3")}});
    const double t = row.input("t");
    const double X = load_integral(contact.compliance, force, t);
    EXPECT_LE(units_of_rounding(X, row.output("int_J_dF") * Exact("0.75")), 6);
    EXPECT_LE(units_of_rounding(paraboloid(row.input("R")).radius_of_force(X), row.output("a_K")), 8);
  }
}

TEST(LoadIntegral, FallsWhereItsRateTurns) {
  const auto compliance = creep_compliance(PoyntingThomson::of(25000, 25000, 5000).modulus());
  // A triangle: at the peak itself while J(t_p) <= 2 J_0, which E1 = E2 never exceeds.
  EXPECT_EQ(load_integral_falls_at(compliance, History::triangle(3, 0.7), 1.4), 0.7);
  const auto slow = creep_compliance(PoyntingThomson::of(100000, 25000, 8000).modulus());
  const double turn = load_integral_falls_at(slow, History::triangle(3, 2), 4);
  EXPECT_GT(turn, 2);
  EXPECT_NEAR(load_integral_rate(slow, History::triangle(3, 2), turn), 0, 1e-18);
  EXPECT_EQ(load_integral_falls_at(slow, History::ramp(1), 1e6), INFINITY);
  EXPECT_EQ(load_integral_falls_at(slow, History::step(1), 1e6), INFINITY);
  EXPECT_EQ(load_integral_falls_at(slow, History::points({{0, 2}, {1, 2}, {1, 1}}), 5), std::nextafter(1., 0.));
  // A jump at the very end is seen, too.
  EXPECT_EQ(load_integral_falls_at(slow, History::points({{0, 2}, {1, 2}, {1, 1}}), 1), std::nextafter(1., 0.));
  EXPECT_THROW(load_integral_falls_at(slow, History::sine(1, 0.5, 1e9), 1), std::invalid_argument);
}

TEST(GrowingContact, StepsAreTheClosedForm) {
  std::mt19937_64 engine(20060422);
  for (int i = 0; i < cases(200); ++i) {
    const auto compliance = any_compliance(engine);
    const auto points = growing_points(engine);
    GrowingContact contact(compliance);
    double time = 0;
    for (const auto& point : points) {
      contact.advance(point.time - time, point.value);
      time = point.time;
    }
    const double exact = load_integral(compliance, History::points(points), time);
    EXPECT_LE(std::abs(contact.load_integral() - exact), 40 * 0x1p-53 * exact);
    EXPECT_TRUE(contact.is_growing());
  }
}

// Exact, not just accurate: a straight course in one step or in many is the same.
RC_GTEST_PROP(GrowingContact, SplittingAStepChangesNothing, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto compliance = any_compliance(engine);
  GrowingContact whole(compliance), parts(compliance);
  const double before = uniform(engine, 0, 2), after = before + uniform(engine, 0, 2);
  const double h = log_uniform(engine, 1e-6, 1e6);
  whole.advance(0, before);
  parts.advance(0, before);
  whole.advance(h, after);
  const int count = 7;
  for (int k = 1; k <= count; ++k) parts.advance(h / count, before + (after - before) * k / count);
  RC_ASSERT(std::abs(whole.load_integral() - parts.load_integral()) <= 1e-14 * whole.load_integral());
}

RC_GTEST_PROP(GrowingContact, IsLinearInTheForce, (unsigned seed)) {
  std::mt19937_64 engine(seed);
  const auto compliance = any_compliance(engine);
  GrowingContact one(compliance), four(compliance);
  for (int k = 0; k < 5; ++k) {
    const double force = k + uniform(engine, 0, 1), h = log_uniform(engine, 1e-3, 1e3);
    one.advance(h, force);
    four.advance(h, 4 * force);
  }
  RC_ASSERT(four.load_integral() == 4 * one.load_integral());
  const auto profile = paraboloid(0.02);
  RC_ASSERT(std::abs(four.radius(profile) / one.radius(profile) - std::cbrt(4.)) < 1e-14);
}

TEST(GrowingContact, SaysWhenItHasShrunk) {
  GrowingContact contact(creep_compliance(PoyntingThomson::of(25000, 25000, 5000).modulus()));
  contact.advance(0, 10);
  contact.advance(3, 10);
  EXPECT_TRUE(contact.is_growing());
  contact.advance(0.01, 5);
  EXPECT_FALSE(contact.is_growing());
  contact.advance(1, 50);
  EXPECT_FALSE(contact.is_growing());
}

TEST(GrowingContact, TendsToHertzOfTheRelaxedModulus) {
  const auto body = ViscoelasticMaterial::of(PoyntingThomson::of(25000, 25000, 5000).modulus(), 0.5);
  GrowingContact contact(ContactCreep::against_rigid(body).compliance);
  contact.advance(0, 10);
  // Figure 4.9: 8.585 mm at once, 13.628404 mm in the end; not 17.17 mm.
  EXPECT_NEAR(contact.approach(paraboloid(0.02)), 8.585357e-3, 1e-9);
  contact.advance(1e3, 10);
  EXPECT_NEAR(contact.approach(paraboloid(0.02)), 13.628404e-3, 1e-9);
}

// Without a spring of its own X starts with the lag z / 2 of a mode, z = h / lambda, however small.
TEST(GrowingContact, StepsThatHardlyLastAreNotLost) {
  const auto compliance = CreepCompliance::of(0, {{0.25, 8.}});
  for (const double duration : {1e-3, 1e-100, 1e-160, 1e-300, 1e-306}) {
    GrowingContact contact(compliance);
    contact.advance(duration, 2);
    const Exact z = Exact(duration) / 8;
    const Exact lag = z < 1e-60 ? Exact(z / 2) : Exact(1 + expm1(Exact(-z)) / z);
    EXPECT_LE(units_of_rounding(contact.load_integral(), Exact(0.25 * 2 * lag)), 4) << duration;
  }
  GrowingContact contact(CreepCompliance::of(1, {{0.25, 1e300}}));
  contact.advance(5e-324, 2);  // h / lambda underflows
  EXPECT_EQ(contact.load_integral(), 2);
  EXPECT_TRUE(contact.is_growing());
}

TEST(GrowingContact, LoadBeyondTheRangeOfDoubleIsRefused) {
  GrowingContact contact(CreepCompliance::of(1e200, {{0.25, 8.}}));
  EXPECT_THAT([&] { contact.advance(0, 1e200); },
              refused("load_integral = inf is not allowed: must be non-negative and finite"));
}

TEST(GrowingContact, BadInputIsRefused) {
  GrowingContact contact(creep_compliance(maxwell(1, 1)));
  EXPECT_THAT([&] { contact.advance(-1, 1); },
              refused("duration = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([&] { contact.advance(1, -1); }, refused("force = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([&] { contact.advance(1, NAN); }, refused("force = nan is not allowed: must be non-negative and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
