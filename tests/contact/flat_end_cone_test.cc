#include <patchgrip/contact/flat_end_cone.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/cone.h>
#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/contact/displacement_integral.h>
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
using Contact = AxisymmetricContact<FlatEndCone>;
using ExactCircle = BasicFlatEndCircle<Exact>;
using Quad = boost::multiprecision::cpp_bin_float_quad;  // 34 digits do to judge a quadrature, and are faster

static_assert(Profile<FlatEndCone>);

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

TEST(FlatEndCone, AgreesWithTheTable) {
  const auto rows = contact_rows("flat_end_cone");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto profile = FlatEndCone::of(row.input("b"), row.input("slope"));
    const auto contact = Contact::at_radius(profile, row.input("a"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(contact.force(), row.output("F_N")), 8);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 8);
    EXPECT_LE(units_of_rounding(contact.stiffness(), row.output("stiffness")), 2);
    EXPECT_LE(units_of_rounding(contact.pressure(row.input("r")), row.output("p_at_r")), 8);
  }
}

TEST(FlatEndCone, StatedErrorsHold) {
  std::mt19937_64 engine(418);
  double approach = 0, slope = 0, force = 0, pressure = 0, displacement = 0;
  for (int i = 0; i < cases(540); ++i) {
    const double b = log_uniform(engine, 1e-6, 1e3);
    const double a = b * (1 + log_uniform(engine, 1e-12, 1e9));
    const auto profile = FlatEndCone::of(b, log_uniform(engine, 1e-3, 1e3));
    const ProfileErrors e = profile.errors();
    const Exact exact(a);
    approach = std::max(approach, units_of_rounding(profile.approach(a), profile.approach(exact)) / e.approach);
    slope = std::max(slope, units_of_rounding(profile.approach_slope(a), profile.approach_slope(exact)) / e.approach);
    force = std::max(force, units_of_rounding(profile.force(a), profile.force(exact)) / e.force);
    double inside = a * uniform(engine, 0, 1);
    if (i % 3 == 1) inside = b * (1 - log_uniform(engine, 1e-14, 1));
    if (i % 3 == 2) inside = a - (a - b) * log_uniform(engine, 1e-9, 1);
    if (i % 5 == 0) {
      const Exact p(profile.pressure(Quad(inside), Quad(a)));
      pressure = std::max(pressure, units_of_rounding(profile.pressure(inside, a), p) / e.pressure);
    }
    const double outside = a * (1 + log_uniform(engine, 1e-15, 1e6));
    if (outside > a) {
      const Exact u = profile.displacement(Exact(outside), exact);
      displacement = std::max(displacement, units_of_rounding(profile.displacement(outside, a), u) / e.displacement);
    }
  }
  RecordProperty("approach", std::to_string(approach));
  RecordProperty("slope", std::to_string(slope));
  RecordProperty("force", std::to_string(force));
  RecordProperty("pressure", std::to_string(pressure));
  RecordProperty("displacement", std::to_string(displacement));
  EXPECT_LE(approach, 1);
  EXPECT_LE(slope, 1);
  EXPECT_LE(force, 1);
  EXPECT_LE(pressure, 1);
  EXPECT_LE(displacement, 1);
}

TEST(FlatEndCone, DisplacementIsItsIntegral) {
  patchgrip::testing::expect_displacement_is_its_integral(FlatEndCone::of(0.7, 3), 0.7);
}

TEST(FlatEndCone, DisplacementHoldsItsErrorNextToTheRimAndFarAway) {
  patchgrip::testing::expect_displacement_holds_its_error(FlatEndCone::of(0.7, 3), 0.7);
}

// The reach of a load in fifty digits: secant steps from the answer in double.
template <class Value>
Exact exact_reach(const Value& value, double start, const Exact& target) {
  Exact x0 = start;
  Exact x1 = Exact(start) * (1 + Exact(1e-10));
  Exact y0 = value(x0) - target;
  for (int i = 0; i < 8; ++i) {
    const Exact y1 = value(x1) - target;
    if (y1 == y0) break;
    const Exact x2 = x1 - y1 * (x1 - x0) / (y1 - y0);
    x0 = x1;
    y0 = y1;
    x1 = x2;
  }
  return x1;
}

TEST(FlatEndCone, StatedErrorsOfTheInversionsHold) {
  std::mt19937_64 engine(419);
  double radius = 0, exchange = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double b = log_uniform(engine, 1e-3, 1e3);
    const auto profile = FlatEndCone::of(b, log_uniform(engine, 1e-2, 1e2));
    const ProfileErrors e = profile.errors();
    const double f = log_uniform(engine, 1e-20, 1e20);
    const double d = log_uniform(engine, 1e-20, 1e10);
    const FlatEndCircle of_force = profile.radius_of_force(f);
    const FlatEndCircle of_approach = profile.radius_of_approach(d);
    const auto circle = [&](const Exact& S) { return ExactCircle::of_reach(Exact(b), S); };
    const Exact sf = exact_reach([&](const Exact& S) { return profile.force(circle(S)); }, of_force.reach, Exact(f));
    const Exact sd =
        exact_reach([&](const Exact& S) { return profile.approach(circle(S)); }, of_approach.reach, Exact(d));
    radius = std::max({radius, units_of_rounding(of_force.reach, sf) / e.radius,
                       units_of_rounding(of_approach.reach, sd) / e.radius,
                       units_of_rounding(of_force, circle(sf).radius) / e.radius});
    const auto loaded = Contact::under_force(profile, f, 1);
    const auto moved = Contact::at_approach(profile, d, 1);
    exchange = std::max(
        {exchange,
         units_of_rounding(loaded.approach(), profile.approach(circle(sf))) * 0x1p-53 * loaded.approach() /
             loaded.approach_error(),
         units_of_rounding(moved.force(), profile.force(circle(sd))) * 0x1p-53 * moved.force() / moved.force_error()});
  }
  RecordProperty("radius", std::to_string(radius));
  RecordProperty("exchange", std::to_string(exchange));
  EXPECT_LE(radius, 1);
  EXPECT_LE(exchange, 1);
}

// Just touching, a - b is far below the spacing of doubles; the load still spreads as under a flat punch.
TEST(FlatEndCone, JustTouchingIsAFlatPunch) {
  const double b = 1;
  const auto contact = Contact::under_force(FlatEndCone::of(b, 1), 1e-12, 1);
  EXPECT_EQ(contact.radius(), b);
  EXPECT_NEAR(contact.approach() / (1e-12 / (2 * b)), 1, 1e-11);
  for (const double r : {0., 0.5, 0.99}) {
    const double punch = 1e-12 / (2 * M_PI * std::sqrt(1 - r * r));
    EXPECT_NEAR(contact.pressure(r) / punch, 1, 1e-9);
  }
}

// Far beyond the flat end only the tip differs.
TEST(FlatEndCone, WideContactForgetsItsFlatEnd) {
  const double a = 1;
  const auto worn = FlatEndCone::of(1e-8, 0.5);
  const auto whole = Cone::of_slope(0.5);
  EXPECT_NEAR(worn.approach(a) / whole.approach(a), 1, 1e-7);
  EXPECT_NEAR(worn.force(a) / whole.force(a), 1, 1e-7);
  for (const double r : {0.1, 0.5, 0.9}) EXPECT_NEAR(worn.pressure(r, a) / whole.pressure(r, a), 1, 1e-7);
  for (const double r : {1.001, 1.5, 9.}) EXPECT_NEAR(worn.displacement(r, a) / whole.displacement(r, a), 1, 1e-7);
}

TEST(FlatEndCone, PressureIsInfiniteAtTheEndsEdge) {
  const auto profile = FlatEndCone::of(1, 1);
  EXPECT_EQ(profile.pressure(1., 2.), std::numeric_limits<double>::infinity());
  EXPECT_EQ(profile.approach_slope(1.), std::numeric_limits<double>::infinity());
  // A logarithm: each factor of 1000 closer adds the same.
  const double far = profile.pressure(1 - 1e-6, 2.);
  const double mid = profile.pressure(1 - 1e-9, 2.);
  const double near = profile.pressure(1 - 1e-12, 2.);
  EXPECT_NEAR(near - mid, mid - far, 1e-4 * (mid - far));
}

TEST(FlatEndCone, OutOfRangeParametersAreNamed) {
  EXPECT_THAT([] { FlatEndCone::of(0, 1); }, refused("end_radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { FlatEndCone::of(1, std::nan("")); },
              refused("slope = nan is not allowed: must be positive and finite"));
  EXPECT_THAT([] { Contact::at_radius(FlatEndCone::of(2, 1), 2, 1); },
              refused("contact_radius = 2 is not allowed: must lie in (2, inf)"));
}

}  // namespace
}  // namespace patchgrip::contact
