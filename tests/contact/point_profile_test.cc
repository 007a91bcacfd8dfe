#include <patchgrip/contact/point_profile.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/cone.h>
#include <patchgrip/contact/paraboloid.h>
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
using Contact = AxisymmetricContact<PointProfile>;
using Points = std::vector<ProfilePoint>;

static_assert(Profile<PointProfile>);

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

TEST(PointProfile, AgreesWithTheTable) {
  const auto rows = contact_rows("axisym_profile_points");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const Points points{{0, 0},
                        {row.input("r_1"), row.input("f_1")},
                        {row.input("r_2"), row.input("f_2")},
                        {row.input("r_3"), row.input("f_3")}};
    const auto contact = Contact::at_radius(PointProfile::through(points), row.input("a"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(contact.force(), row.output("F_N")), 8);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 8);
    EXPECT_LE(units_of_rounding(contact.pressure(row.input("r")), row.output("p_at_r")), 10);
    EXPECT_LE(units_of_rounding(contact.displacement(row.input("r_out")), row.output("u_z_at_r_out")), 10);
  }
}

Points drawn(std::mt19937_64& engine) {
  Points points{{0, 0}};
  double slope = uniform(engine, 0, 1) < 0.5 ? 0 : log_uniform(engine, 1e-6, 1);
  for (int k = 0; k < 5; ++k) {
    const double width = log_uniform(engine, 1e-3, 1);
    points.push_back({points.back().radius + width, points.back().height + slope * width});
    slope += log_uniform(engine, 1e-6, 1);
  }
  return points;
}

TEST(PointProfile, StatedErrorsHold) {
  std::mt19937_64 engine(420);
  double approach = 0, force = 0, pressure = 0, exchange = 0, residual = 0;
  for (int i = 0; i < cases(20); ++i) {
    const auto profile = PointProfile::through(drawn(engine));
    const ProfileErrors e = profile.errors();
    const double a = profile.max_radius() * log_uniform(engine, 1e-2, 1);
    if (!(profile.force(a) > 0)) continue;
    const Exact exact(a);
    approach = std::max(approach, units_of_rounding(profile.approach(a), profile.approach(exact)) / e.approach);
    force = std::max(force, units_of_rounding(profile.force(a), profile.force(exact)) / e.force);
    const double inside = a * uniform(engine, 0, 1);
    const Exact p = profile.pressure(Exact(inside), exact);
    pressure = std::max(pressure, units_of_rounding(profile.pressure(inside, a), p) / e.pressure);

    const double f = profile.force(a);
    const auto loaded = Contact::under_force(profile, f, 1);
    // The true approach of that force, from the exact one at a: d(delta) = dF / (2 a).
    const Exact delta = profile.approach(exact) + (Exact(f) - profile.force(exact)) / (2 * exact);
    exchange = std::max(
        exchange, units_of_rounding(loaded.approach(), delta) * 0x1p-53 * loaded.approach() / loaded.approach_error());
    residual = std::max(residual, std::abs(loaded.radius() - a) / (0x1p-53 * e.radius * a));
  }
  RecordProperty("approach", std::to_string(approach));
  RecordProperty("force", std::to_string(force));
  RecordProperty("pressure", std::to_string(pressure));
  RecordProperty("exchange", std::to_string(exchange));
  RecordProperty("radius", std::to_string(residual));
  EXPECT_LE(approach, 1);
  EXPECT_LE(force, 1);
  EXPECT_LE(pressure, 1);
  EXPECT_LE(exchange, 1);
  EXPECT_LE(residual, 1);
}

TEST(PointProfile, StraightFlankIsACone) {
  const auto profile = PointProfile::through(Points{{0, 0}, {1, 0.3}, {2, 0.6}, {3, 0.9}});
  const Cone cone = Cone::of_slope(0.3);
  for (const double a : {0.5, 1.0, 2.5}) {
    EXPECT_DOUBLE_EQ(profile.approach(a), cone.approach(a));
    EXPECT_DOUBLE_EQ(profile.force(a), cone.force(a));
    EXPECT_DOUBLE_EQ(profile.pressure(0.3, a), cone.pressure(0.3, a));
    EXPECT_DOUBLE_EQ(profile.displacement(3., a), cone.displacement(3., a));
  }
}

// A polygon through a parabola: at a given radius its force errs by the power 3/2 of the spacing.
TEST(PointProfile, DensePointsApproachTheSmoothShape) {
  const Paraboloid smooth = Paraboloid::of_radius(1);
  for (const int n : {8, 16, 32, 64}) {
    Points points;
    for (int k = 0; k <= n; ++k) points.push_back({double(k) / n, 0.5 * k * k / n / n});
    const auto polygon = PointProfile::through(points);
    const double error = std::abs(polygon.force(0.77) / smooth.force(0.77) - 1);
    EXPECT_LT(error, 0.5 * std::pow(n, -1.5));
  }
}

TEST(PointProfile, PressurePeaksAtEveryKink) {
  const auto profile = PointProfile::through(Points{{0, 0}, {1, 0.1}, {2, 0.3}});
  EXPECT_EQ(profile.pressure(1., 1.5), std::numeric_limits<double>::infinity());
  EXPECT_GT(profile.pressure(1 + 1e-9, 1.5), profile.pressure(1.1, 1.5));
  EXPECT_GT(profile.pressure(1 - 1e-9, 1.5), profile.pressure(0.9, 1.5));
}

TEST(PointProfile, LoadsAtANodeAndJustBeyondAreFound) {
  const auto profile = PointProfile::through(Points{{0, 0}, {1, 0.1}, {2, 0.4}});
  const double at_node = profile.force(1.);
  EXPECT_NEAR(profile.radius_of_force(at_node), 1, 1e-15);
  for (const double more : {1e-15, 1e-12, 1e-6, 1e-3}) {
    const auto contact = Contact::under_force(profile, at_node * (1 + more), 1);
    // The force runs like the root of a - 1: neighboring doubles enclose the radius, and approach does not suffer.
    EXPECT_LE(profile.force(std::nextafter(contact.radius(), 0.)), contact.force());
    EXPECT_GE(profile.force(std::nextafter(contact.radius(), 2.)), contact.force());
    EXPECT_NEAR(contact.approach(), profile.approach(1.) + at_node * more / 2, at_node * more * more + 1e-16);
  }
}

TEST(PointProfile, OutOfRangePointsAreNamed) {
  EXPECT_THAT(
      [] {
        PointProfile::through(Points{{0, 0}});
      },
      refused("number of points = 1 is not allowed: must lie in [2, 1e+06]"));
  EXPECT_THAT(
      [] {
        PointProfile::through(Points{{0.1, 0}, {1, 1}});
      },
      refused("r_0 = 0.1 is not allowed: must lie in [0, 0]"));
  EXPECT_THAT(
      [] {
        PointProfile::through(Points{{0, 0}, {1, 1}, {1, 2}});
      },
      refused("r_2 = 1 is not allowed: must be greater than the radius before"));
  EXPECT_THAT(
      [] {
        PointProfile::through(Points{{0, 0}, {1, 1}, {2, 1.5}});
      },
      refused("f_2 = 1.5 is not allowed: must keep the slope from falling: contact is lost at a concave kink"));
  EXPECT_THAT(
      [] {
        PointProfile::through(Points{{0, 0}, {1, 0}});
      },
      refused("f_1 = 0 is not allowed: must be positive: the stamp is flat"));
  EXPECT_THAT(
      [] {
        PointProfile::through(Points{{0, 0}, {1, std::nan("")}});
      },
      refused("f_1 = nan is not allowed: must be finite"));
  const auto profile = PointProfile::through(Points{{0, 0}, {1, 0.5}});
  EXPECT_THROW(Contact::at_radius(profile, 1.01, 1), std::invalid_argument);
  EXPECT_THROW(Contact::under_force(profile, 1.01 * profile.force(1.), 1), std::invalid_argument);
  EXPECT_THROW(Contact::at_approach(profile, 1.01 * profile.approach(1.), 1), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
