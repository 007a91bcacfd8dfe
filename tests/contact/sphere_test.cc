#include <patchgrip/contact/sphere.h>

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

#include <patchgrip/contact/paraboloid.h>
#include <patchgrip/contact/power_sum.h>
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
using SphereContact = AxisymmetricContact<Sphere>;

static_assert(Profile<Sphere>);

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

TEST(Sphere, AgreesWithTheTable) {
  const auto rows = contact_rows("sphere_exact_and_series");
  ASSERT_EQ(rows.size(), 5U);
  for (const auto& row : rows) {
    const double R = row.input("R");
    const double E = row.input("E_star");
    const double q = row.input("a_over_R");
    const double a = q * R;
    // The table takes the ratio as exact, and the load near the equator is that sensitive to it.
    const double condition = 4 / (1 - q);
    const auto contact = SphereContact::at_radius(Sphere::of_radius(R), a, E);
    EXPECT_LE(units_of_rounding(contact.force(), row.output("F_N")), 8 + condition);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 8 + condition);
    EXPECT_LE(units_of_rounding(contact.pressure(0), row.output("p_at_0")), 8 + condition);
    EXPECT_LE(units_of_rounding(contact.pressure(0.5 * a), row.output("p_at_half_a")), 8 + condition);
    EXPECT_LE(units_of_rounding(contact.pressure(0.9 * a), row.output("p_at_0p9a")), 24 + condition);
    for (const int n : {1, 2, 3, 4, 10}) {
      const std::string name = "series" + std::to_string(n);
      const auto series = AxisymmetricContact<PowerSum>::at_radius(PowerSum::sphere_series(R, n), a, E);
      EXPECT_LE(units_of_rounding(series.force(), row.output(name + "_F_N")), 16);
      EXPECT_LE(units_of_rounding(series.approach(), row.output(name + "_delta")), 16);
      EXPECT_LE(units_of_rounding(series.pressure(0.5 * a), row.output(name + "_p_at_half_a")), 16);
    }
  }
}

TEST(Sphere, UnderAForceAgreesWithTheTable) {
  const auto rows = contact_rows("sphere_exact_inverse");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const auto contact =
        SphereContact::under_force(Sphere::of_radius(row.input("R")), row.input("F_N"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(std::tanh(contact.circle().s), row.output("a_over_R")), 4);
    EXPECT_LE(units_of_rounding(contact.circle().one_minus_ratio(), row.output("one_minus_a_over_R")), 200);
    EXPECT_LE(units_of_rounding(contact.approach(), row.output("delta")), 6);
    EXPECT_LE(units_of_rounding(contact.stiffness(), row.output("stiffness")), 5);
  }
}

TEST(Sphere, AtAnApproachAgreesWithTheTable) {
  const auto rows = contact_rows("sphere_exact_from_approach");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const auto contact =
        SphereContact::at_approach(Sphere::of_radius(row.input("R")), row.input("delta"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(std::tanh(contact.circle().s), row.output("a_over_R")), 4);
    EXPECT_LE(units_of_rounding(contact.circle().one_minus_ratio(), row.output("one_minus_a_over_R")), 40);
    EXPECT_LE(units_of_rounding(contact.force(), row.output("F_N")), 8);
  }
}

double draw_ratio(std::mt19937_64& engine, int i) {
  if (i % 3 == 0) return log_uniform(engine, 1e-9, 0.5);
  if (i % 3 == 1) return uniform(engine, 0.01, 0.99);
  return 1 - log_uniform(engine, 1e-13, 0.5);
}

TEST(Sphere, StatedErrorsHold) {
  std::mt19937_64 engine(414);
  double approach = 0, force = 0, pressure = 0, displacement = 0, slope = 0;
  for (int i = 0; i < cases(540); ++i) {
    const double R = log_uniform(engine, 1e-9, 1e6);
    const double a = R * draw_ratio(engine, i);
    const Sphere sphere = Sphere::of_radius(R);
    const ProfileErrors e = sphere.errors();
    const Exact exact(a);
    approach = std::max(approach, units_of_rounding(sphere.approach(a), sphere.approach(exact)) / e.approach);
    slope = std::max(slope, units_of_rounding(sphere.approach_slope(a), sphere.approach_slope(exact)) / e.approach);
    force = std::max(force, units_of_rounding(sphere.force(a), sphere.force(exact)) / e.force);
    const double inside = i % 2 == 0 ? a * uniform(engine, 0, 1) : a * (1 - log_uniform(engine, 1e-15, 1));
    if (i % 5 == 0) {
      const Exact p = sphere.pressure(Exact(inside), exact);
      pressure = std::max(pressure, units_of_rounding(sphere.pressure(inside, a), p) / e.pressure);
    }
    const double outside = a * (1 + (i % 2 == 0 ? log_uniform(engine, 1e-15, 1e6) : uniform(engine, 0, 1)));
    if (i % 7 == 0 && outside > a) {
      const Exact u = sphere.displacement(Exact(outside), exact);
      displacement = std::max(displacement, units_of_rounding(sphere.displacement(outside, a), u) / e.displacement);
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

TEST(Sphere, DisplacementIsItsIntegral) {
  const Sphere sphere = Sphere::of_radius(1);
  const auto rate = [&](const Exact& x) -> Exact { return sphere.approach_slope(x); };
  for (const double a : {0.5, 0.5000001, 0.99}) {
    for (const double r : {a * (1 + 1e-12), 1.3 * a, 30 * a}) {
      const Exact integral = patchgrip::testing::displacement_integral(rate, r, a, 0);
      EXPECT_LE(abs(sphere.displacement(Exact(r), Exact(a)) / integral - 1), 1e-30) << a << ' ' << r;
    }
  }
}

TEST(Sphere, HoldsItsErrorsNextToTheRimTheEquatorAndFarAway) {
  const Sphere sphere = Sphere::of_radius(1);
  const ProfileErrors e = sphere.errors();
  for (const double a : {1e-12, 0.5, 0.5000001, 0.7071069, 0.75, 0.7500001, 0.99, 1 - 0x1p-53}) {
    EXPECT_LE(units_of_rounding(sphere.force(a), sphere.force(Exact(a))), e.force) << a;
    std::vector<double> radii = patchgrip::testing::radii_around(a);
    for (const double r : {1 - 1e-9, 1 - 0x1p-53, 1., 1 + 0x1p-52, 1 + 1e-9}) {
      if (r > a) radii.push_back(r);
    }
    for (const double r : radii) {
      const Exact u = sphere.displacement(Exact(r), Exact(a));
      EXPECT_LE(units_of_rounding(sphere.displacement(r, a), u), e.displacement) << a << ' ' << r;
    }
  }
}

// By s, also where a is 1 to rounding.
TEST(Sphere, DisplacementOfACircleHoldsItsError) {
  const Sphere sphere = Sphere::of_radius(1);
  for (const double s : {1e-9, 0.3, 0.49, 0.51, 1., 5., 18., 20., 30.}) {
    const Exact a = tanh(Exact(s));
    const double rim = static_cast<double>(a);
    for (const double r : {rim * (1 + 1e-12), 1.3 * rim, 1.42 * rim, 1., 1 + 0x1p-52, 1 + 1e-9, 1e6}) {
      if (Exact(r) <= a) continue;
      EXPECT_LE(units_of_rounding(sphere.displacement(r, SphereCircle{1, s}), sphere.displacement(Exact(r), a)),
                sphere.errors().displacement)
          << s << ' ' << r;
    }
  }
}

// s of a load, in fifty digits, by Newton from the answer in double.
Exact exact_s(const Exact& start, const Exact& target, bool of_force) {
  Exact s = start;
  for (int i = 0; i < 4; ++i) {
    const Exact q = tanh(s);
    const Exact slope = q + s * (1 - q * q);
    if (of_force) {
      s -= ((1 + q * q) * s - q - target) / (2 * q * slope);
    } else {
      s -= (s * q - target) / slope;
    }
  }
  return s;
}

TEST(Sphere, StatedErrorsOfTheInversionsHold) {
  std::mt19937_64 engine(415);
  double radius = 0, exchange = 0;
  for (int i = 0; i < cases(600); ++i) {
    const double R = log_uniform(engine, 1e-3, 1e3);
    const Sphere sphere = Sphere::of_radius(R);
    const ProfileErrors e = sphere.errors();
    const double f = R * R * log_uniform(engine, 1e-20, 1e2);
    const double d = R * log_uniform(engine, 1e-16, 1e2);
    const SphereCircle of_force = sphere.radius_of_force(f);
    const SphereCircle of_approach = sphere.radius_of_approach(d);
    const Exact sf = exact_s(of_force.s, Exact(f) / R / R, true);
    const Exact sd = exact_s(of_approach.s, Exact(d) / R, false);
    radius =
        std::max({radius, units_of_rounding(of_force.s, sf) / e.radius, units_of_rounding(of_approach.s, sd) / e.radius,
                  units_of_rounding(of_force, R * tanh(sf)) / e.radius,
                  units_of_rounding(of_approach, R * tanh(sd)) / e.radius});
    const Exact q = tanh(sd);
    const auto loaded = SphereContact::under_force(sphere, f, 1);
    const auto moved = SphereContact::at_approach(sphere, d, 1);
    exchange = std::max({exchange,
                         units_of_rounding(loaded.approach(), R * sf * tanh(sf)) * 0x1p-53 * loaded.approach() /
                             loaded.approach_error(),
                         units_of_rounding(moved.force(), Exact(R) * R * ((1 + q * q) * sd - q)) * 0x1p-53 *
                             moved.force() / moved.force_error()});
  }
  RecordProperty("radius", std::to_string(radius));
  RecordProperty("exchange", std::to_string(exchange));
  EXPECT_LE(radius, 1);
  EXPECT_LE(exchange, 1);
}

// The pressure known by s agrees with the one known by a, where doubles a are fine enough.
RC_GTEST_PROP(Sphere, CircleAndRadiusAgree, ()) {
  const double q = *rc::gen::map(rc::gen::inRange(1, 9000), [](int i) { return 1e-4 * i; });
  const double rho = *rc::gen::map(rc::gen::inRange(0, 900), [](int i) { return 1e-3 * i; });
  const Sphere sphere = Sphere::of_radius(1);
  const SphereCircle circle = sphere.circle(q);
  RC_ASSERT(std::abs(sphere.pressure(rho * q, circle) / sphere.pressure(rho * q, q) - 1) < 1e-14);
  RC_ASSERT(std::abs(sphere.force(circle) / sphere.force(q) - 1) < 1e-14);
  RC_ASSERT(std::abs(sphere.approach_slope(circle) / sphere.approach_slope(q) - 1) < 1e-14);
  RC_ASSERT(std::abs(sphere.displacement(q * (1.1 + rho), circle) / sphere.displacement(q * (1.1 + rho), q) - 1) <
            1e-14);
}

// F/F_Hertz = 1 + (2/5) q^2 + (9/35) q^4 + ... at equal radius.
TEST(Sphere, SmallCirclesAreThoseOfTheParaboloid) {
  const Sphere sphere = Sphere::of_radius(1);
  const Paraboloid paraboloid = Paraboloid::of_radius(1);
  for (const double q : {1e-9, 1e-4, 1e-2, 0.1}) {
    const double excess = sphere.force(q) / paraboloid.force(q) - 1;
    EXPECT_NEAR(excess, 0.4 * q * q + 9. / 35 * std::pow(q, 4), 2 * std::pow(q, 6) + 1e-15);
  }
}

// Seed 4.1.1: at a/R = 1/2 at least two terms are needed; the series falls short at every order.
TEST(Sphere, SeriesApproachesTheSphereFromBelow) {
  const Sphere sphere = Sphere::of_radius(1);
  double before = 0;
  const double shortfall[] = {0.107, 0.018, 0.0033, 0.00067};
  for (int n = 1; n <= 4; ++n) {
    const double force = PowerSum::sphere_series(1, n).force(0.5);
    EXPECT_GT(force, before);
    EXPECT_NEAR(1 - force / sphere.force(0.5), shortfall[n - 1], 0.03 * shortfall[n - 1]);
    before = force;
  }
  EXPECT_NEAR(PowerSum::sphere_series(1, 100).force(0.5) / sphere.force(0.5), 1, 1e-15);
}

TEST(Sphere, PressedToItsEquatorStaysFinite) {
  const auto contact = SphereContact::under_force(Sphere::of_radius(1), 300, 1);
  EXPECT_EQ(contact.radius(), 1);
  EXPECT_GT(contact.circle().one_minus_ratio(), 0);
  for (const double r : {0., 0.5, 0.999, 1.}) {
    EXPECT_TRUE(std::isfinite(contact.pressure(r)));
    EXPECT_TRUE(std::isfinite(contact.displacement(r)));
  }
  EXPECT_EQ(Sphere::of_radius(1).height(1.5), std::numeric_limits<double>::infinity());
}

TEST(Sphere, OutOfRangeParametersAreNamed) {
  EXPECT_THAT([] { Sphere::of_radius(0); }, refused("radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { SphereContact::at_radius(Sphere::of_radius(1), 1, 1); },
              refused("contact_radius = 1 is not allowed: must lie in (0, 1)"));
  EXPECT_THAT([] { SphereContact::at_radius(Sphere::of_radius(1), 1.1, 1); },
              refused("contact_radius = 1.1 is not allowed: must lie in [0, 1]"));
}

}  // namespace
}  // namespace patchgrip::contact
