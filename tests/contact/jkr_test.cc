#include <patchgrip/contact/adhesion/jkr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <patchgrip/contact/hertz_circle.h>
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

constexpr double pi = std::numbers::pi;

// The decimals of the table are rounded before they are used: differences of two terms are compared to the larger.
double of_scale(double value, const Exact& exact, double scale) {
  return static_cast<double>(abs(value - exact)) / (scale * 0x1p-53);
}

TEST(Jkr, AgreesWithTheTable) {
  const auto rows = contact_rows("jkr");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const Jkr jkr(AdhesiveSphere::of(row.input("R"), row.input("E_star"), 2 * row.input("gamma")));
    const auto at = jkr.at_radius(row.input("a"));
    const double hertz = 4 * row.input("E_star") * std::pow(row.input("a"), 3) / (3 * row.input("R"));
    EXPECT_LE(of_scale(at.normal_force, row.output("F_N_of_a"), hertz), 8);
    EXPECT_LE(of_scale(at.approach, row.output("delta_of_a"), std::pow(row.input("a"), 2) / row.input("R")), 8);
    EXPECT_LE(units_of_rounding(jkr.pressure(row.input("a"), row.input("r")), row.output("p_at_r")), 16);
    EXPECT_LE(units_of_rounding(jkr.load_pull_off().normal_force, row.output("F_pulloff")), 3);
    EXPECT_LE(units_of_rounding(jkr.load_pull_off().contact_radius, row.output("a_pulloff")), 3);
    EXPECT_LE(units_of_rounding(jkr.load_pull_off().approach, row.output("delta_pulloff")), 8);
    EXPECT_LE(units_of_rounding(jkr.no_load().contact_radius, row.output("a_zero_load")), 3);
    EXPECT_LE(units_of_rounding(jkr.no_load().approach, row.output("delta_zero_load")), 8);
    const auto loaded = jkr.under_force(row.input("F"));
    EXPECT_LE(units_of_rounding(loaded.contact_radius, row.output("a_of_F")), 4);
    EXPECT_LE(units_of_rounding(loaded.approach, row.output("delta_of_F")), 40);  // a twentieth of its terms
  }
}

TEST(Jkr, BranchesAgreeWithTheTable) {
  const auto rows = contact_rows("jkr_branches");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const Jkr jkr(AdhesiveSphere::of(row.input("R"), row.input("E_star"), row.input("w")));
    const auto stable = jkr.under_force(row.input("F")), unstable = jkr.unstable_under_force(row.input("F"));
    EXPECT_LE(units_of_rounding(stable.contact_radius, row.output("a_stable")), 4);
    EXPECT_LE(units_of_rounding(stable.approach, row.output("delta_stable")), 60);
    EXPECT_LE(units_of_rounding(stable.stiffness, row.output("stiffness_stable")), 8);
    EXPECT_LE(units_of_rounding(unstable.contact_radius, row.output("a_unstable")), 4);
    EXPECT_LE(units_of_rounding(unstable.approach, row.output("delta_unstable")), 8);
    EXPECT_LE(units_of_rounding(jkr.load_pull_off().normal_force, row.output("F_pulloff_load")), 3);
    const auto torn = jkr.displacement_pull_off();
    EXPECT_LE(units_of_rounding(torn.normal_force, row.output("F_pulloff_disp")), 3);
    EXPECT_LE(units_of_rounding(torn.contact_radius, row.output("a_pulloff_disp")), 3);
    EXPECT_LE(units_of_rounding(torn.approach, row.output("delta_pulloff_disp")), 3);
  }
}

TEST(Jkr, LoadsAgreeWithTheTable) {
  const auto rows = contact_rows("jkr_load");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const Jkr jkr(AdhesiveSphere::of(row.input("R"), row.input("E_star"), row.input("w")));
    const auto loaded = jkr.under_force(row.input("F"));
    EXPECT_LE(units_of_rounding(loaded.contact_radius, row.output("a_K")), 4);
    EXPECT_LE(units_of_rounding(loaded.approach, row.output("delta")), 8);
  }
}

struct Draw {
  std::mt19937_64 engine{20060210};
  AdhesiveSphere sphere() {
    return AdhesiveSphere::of(log_uniform(engine, 1e-9, 1e3), log_uniform(engine, 1e3, 1e12),
                              log_uniform(engine, 1e-4, 1e2));
  }
};

struct ExactSphere {
  explicit ExactSphere(const AdhesiveSphere& s) : R(s.relative_radius), E(s.contact_modulus), w(s.work_of_adhesion) {}
  Exact R, E, w;
  const Exact pi = boost::math::constants::pi<Exact>();
  Exact hertz(const Exact& a) const { return 4 * E * a * a * a / (3 * R); }
  Exact force(const Exact& a) const { return hertz(a) - sqrt(8 * pi * w * E * a * a * a); }
  Exact approach(const Exact& a) const { return a * a / R - sqrt(2 * pi * a * w / E); }
  // a given load, by the plain quadratic
  Exact radius(const Exact& F, int sign) const {
    const Exact s = F + 3 * pi * w * R, q = sqrt(abs(3 * pi * w * R * (2 * F + 3 * pi * w * R)));
    return cbrt(3 * R / (4 * E) * (s + sign * q));
  }
};

TEST(Jkr, RadiusHoldsItsBoundAtEveryLoad) {
  Draw draw;
  double worst = 0, worst_approach = 0;
  for (int i = 0; i < cases(800); ++i) {
    const auto s = draw.sphere();
    const ExactSphere exact(s);
    const double unit = pi * s.work_of_adhesion * s.relative_radius;
    const double force = i % 4 == 0   ? unit * log_uniform(draw.engine, 1e-12, 1e12)
                         : i % 4 == 1 ? -unit * log_uniform(draw.engine, 1e-12, 1.5)
                         : i % 4 == 2 ? -1.5 * unit * (1 - log_uniform(draw.engine, 1e-15, 1))
                                      : log_uniform(draw.engine, 1e-12, 1e12);
    const auto stable = Jkr(s).under_force(force);
    const Exact a = exact.radius(force, 1);
    worst = std::max(worst, units_of_rounding(stable.contact_radius, a));
    worst_approach = std::max(
        worst_approach, of_scale(stable.approach, exact.approach(a), static_cast<double>(Exact(a * a / exact.R))));
    if (force < 0) {
      const Exact lesser = exact.radius(force, -1);
      if (force / unit < -1e-9)  // fifty digits of s - q are not enough below
        worst = std::max(worst, units_of_rounding(Jkr(s).unstable_under_force(force).contact_radius, lesser));
    }
  }
  RecordProperty("worst_units", std::to_string(worst));
  RecordProperty("worst_units_approach", std::to_string(worst_approach));
  EXPECT_LE(worst, 1.1);
  EXPECT_LE(worst_approach, 3);
}

TEST(Jkr, StateAtARadiusHoldsItsBound) {
  Draw draw;
  double worst = 0;
  for (int i = 0; i < cases(800); ++i) {
    const auto s = draw.sphere();
    const ExactSphere exact(s);
    const Jkr jkr(s);
    const double a = jkr.no_load().contact_radius * log_uniform(draw.engine, 1e-4, 1e4);
    const auto at = jkr.at_radius(a);
    const auto of_terms = [&](double value, const Exact& one, const Exact& other) {
      return static_cast<double>(abs(value - (one - other)) / std::max(one, other)) * 0x1p53;
    };
    const Exact b(a), E = exact.E, R = exact.R, w = exact.w, pi_ = exact.pi;
    worst = std::max({worst, of_terms(at.normal_force, exact.hertz(b), sqrt(8 * pi_ * w * E * b * b * b)),
                      of_terms(at.approach, b * b / R, sqrt(2 * pi_ * b * w / E))});
    const double r = a * (i % 2 == 0 ? uniform(draw.engine, 0, 1) : 1 - log_uniform(draw.engine, 1e-12, 1));
    const Exact depth = sqrt(b * b - Exact(r) * r);
    worst = std::max(
        worst, of_terms(jkr.pressure(a, r), 2 * E / (pi_ * R) * depth, E / pi_ * sqrt(2 * pi_ * b * w / E) / depth));
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.1);
}

TEST(Jkr, RadiusAtAnApproachHoldsItsBound) {
  Draw draw;
  double worst = 0, worst_force = 0, worst_stiffness = 0;
  for (int i = 0; i < cases(500); ++i) {
    const auto s = draw.sphere();
    const ExactSphere exact(s);
    const Exact L = cbrt(exact.pi * exact.w * exact.R * exact.R / exact.E);
    const Exact unit = L * L / exact.R;
    const double depth = i % 3 == 0   ? static_cast<double>(unit) * log_uniform(draw.engine, 1e-12, 1e12)
                         : i % 3 == 1 ? static_cast<double>(unit) * uniform(draw.engine, -0.75, 1)
                                      : static_cast<double>(unit) * (-0.75 + log_uniform(draw.engine, 1e-13, 1));
    const auto at = Jkr(s).at_approach(depth);
    // Newton in fifty digits, from the result.
    Exact t = sqrt(Exact(2 * at.contact_radius / L)) - 1;
    const Exact g = 3 + 4 * Exact(depth) / unit;
    for (int k = 0; k < 3; ++k) t -= (t * t * (6 + 4 * t + t * t) - g) / (12 * t + 12 * t * t + 4 * t * t * t);
    const Exact a = L * (1 + t) * (1 + t) / 2;
    const double allowed = 1.1 + 0x1p-8 / static_cast<double>(t);
    worst = std::max(worst, units_of_rounding(at.contact_radius, a) / allowed);
    const Exact tension = sqrt(8 * exact.pi * exact.w * exact.E * a * a * a);
    worst_force = std::max(
        worst_force, of_scale(at.normal_force, exact.force(a), static_cast<double>(std::max(exact.hertz(a), tension))) /
                         (2 + 3 * allowed));
    const Exact y = 4 / ((1 + t) * (1 + t) * (1 + t));
    const Exact slope = 2 * exact.E * a * (4 - 3 * y) / (4 - y);
    const double scale = static_cast<double>(std::max(abs(slope), Exact(6 * exact.E * a * y / (4 - y))));
    const double excess = static_cast<double>(t);
    worst_stiffness = std::max(
        worst_stiffness, of_scale(at.stiffness, slope, scale) / (2 + 0x1p-8 / excess + 0x1p-9 / (excess * excess)));
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
  RecordProperty("worst_of_bound_force", std::to_string(worst_force));
  RecordProperty("worst_of_bound_stiffness", std::to_string(worst_stiffness));
  EXPECT_LE(worst, 1);
  EXPECT_LE(worst_force, 1);
  EXPECT_LE(worst_stiffness, 1);
}

rc::Gen<double> magnitude(int decades) {
  return rc::gen::map(rc::gen::inRange(-decades * 1000, decades * 1000), [](int i) { return std::pow(10, 1e-3 * i); });
}

RC_GTEST_PROP(Jkr, EnergyReleaseRateIsTheWorkOfAdhesion, ()) {
  const auto s = AdhesiveSphere::of(*magnitude(3), 1e6 * *magnitude(3), *magnitude(3));
  const Jkr jkr(s);
  const double a = jkr.no_load().contact_radius * std::pow(10, 1e-3 * *rc::gen::inRange(-2000, 2000));
  const double opening = jkr.at_radius(a).approach - a * a / s.relative_radius;
  const double rate = s.contact_modulus / (2 * pi * a) * opening * opening;
  RC_ASSERT(std::abs(rate / s.work_of_adhesion - 1) < 1e-9);
}

RC_GTEST_PROP(Jkr, PressureCarriesTheForce, ()) {
  const auto s = AdhesiveSphere::of(*magnitude(3), 1e6 * *magnitude(3), *magnitude(3));
  const Jkr jkr(s);
  const double a = jkr.no_load().contact_radius * std::pow(10, 1e-3 * *rc::gen::inRange(-500, 1000));
  boost::math::quadrature::tanh_sinh<double> integrate;
  // r = a sin u: the pressure times cos u is finite.
  const double carried = integrate.integrate(
      [&](double u) {
        const double r = a * std::sin(u);
        return r < a ? jkr.pressure(a, r) * r * a * std::cos(u) : 0;
      },
      0., pi / 2);
  const double hertz = 4 * s.contact_modulus * a * a * a / (3 * s.relative_radius);
  RC_ASSERT(std::abs(2 * pi * carried - jkr.at_radius(a).normal_force) <
            1e-7 * (hertz + std::abs(jkr.at_radius(a).normal_force)));
}

RC_GTEST_PROP(Jkr, StiffnessIsTheSlopeOfTheForce, ()) {
  const Jkr jkr(AdhesiveSphere::of(0.01, 65798, 0.096));
  const double least = jkr.displacement_pull_off().approach;
  const double depth = least * (1 - 1e-3 * *rc::gen::inRange(20, 4000));
  const double step = 1e-5 * std::abs(depth - least);
  const double slope =
      (jkr.at_approach(depth + step).normal_force - jkr.at_approach(depth - step).normal_force) / (2 * step);
  const double scale = 2 * 65798 * jkr.at_approach(depth).contact_radius;
  RC_ASSERT(std::abs(slope - jkr.at_approach(depth).stiffness) < 1e-5 * (scale + std::abs(slope)));
}

RC_GTEST_PROP(Jkr, ControlsByForceAndByApproachMeet, ()) {
  const Jkr jkr(AdhesiveSphere::of(0.01, 65798, 0.096));
  const double force = jkr.load_pull_off().normal_force * (1 - 1e-3 * *rc::gen::inRange(1, 9000));
  const auto loaded = jkr.under_force(force);
  const auto held = jkr.at_approach(loaded.approach);
  RC_ASSERT(std::abs(held.contact_radius / loaded.contact_radius - 1) < 1e-13);
  RC_ASSERT(loaded.stiffness > 0);
  if (force < 0) {
    RC_ASSERT(jkr.unstable_under_force(force).contact_radius < loaded.contact_radius);
    RC_ASSERT(std::abs(jkr.at_radius(jkr.unstable_under_force(force).contact_radius).normal_force - force) <
              1e-15 * -jkr.load_pull_off().normal_force);
  }
}

RC_GTEST_PROP(Jkr, TendsToHertzUnderHeavyLoad, ()) {
  const auto s = AdhesiveSphere::of(*magnitude(3), 1e6 * *magnitude(3), *magnitude(3));
  const double ratio = 1e8 * *magnitude(3);
  const double force = ratio * pi * s.work_of_adhesion * s.relative_radius;
  const auto circle = HertzCircle::under_force(force, s.relative_radius, s.contact_modulus);
  const auto jkr = Jkr(s).under_force(force);
  RC_ASSERT(jkr.contact_radius >= circle.radius);
  RC_ASSERT(jkr.contact_radius / circle.radius - 1 < 1 / std::sqrt(ratio));
}

TEST(Jkr, PullOffIsWhereTheBranchesMeet) {
  const Jkr jkr(AdhesiveSphere::of(0.01, 65798, 0.096));
  const auto pull_off = jkr.load_pull_off();
  EXPECT_DOUBLE_EQ(jkr.under_force(pull_off.normal_force).contact_radius, pull_off.contact_radius);
  EXPECT_DOUBLE_EQ(jkr.unstable_under_force(pull_off.normal_force).contact_radius, pull_off.contact_radius);
  EXPECT_EQ(pull_off.stiffness, 0);
  EXPECT_NEAR(jkr.at_radius(pull_off.contact_radius).stiffness, 0, 1e-10);
  EXPECT_NEAR(pull_off.contact_radius / jkr.no_load().contact_radius, 0.629961, 5e-7);
  const auto torn = jkr.displacement_pull_off();
  EXPECT_DOUBLE_EQ(jkr.at_approach(torn.approach).contact_radius, torn.contact_radius);
  EXPECT_EQ(torn.stiffness, std::numeric_limits<double>::infinity());
}

TEST(Jkr, JumpsInAtFirstTouch) {
  const Jkr jkr(AdhesiveSphere::of(0.01, 65798, 0.096));
  const auto jump = jkr.jump_in();
  EXPECT_EQ(jump.approach, 0);
  EXPECT_DOUBLE_EQ(jkr.at_approach(0).contact_radius, jump.contact_radius);
  EXPECT_DOUBLE_EQ(jkr.at_approach(0).normal_force, jump.normal_force);
}

// Seed example 4.6: a rubber ball of 1 cm on glass.
TEST(Jkr, SeedsExampleOfRubberOnGlass) {
  const Jkr jkr(AdhesiveSphere::of(0.01, 50e3 / (1 - 0.49 * 0.49), 2 * 0.048));
  EXPECT_NEAR(jkr.load_pull_off().normal_force, -0.45 * 0.01, 5e-5);
  EXPECT_NEAR(jkr.no_load().contact_radius, 1.3e-3, 5e-5);
  EXPECT_NEAR(jkr.load_pull_off().contact_radius, 0.8e-3, 5e-5);
}

TEST(Jkr, StatesThatDoNotExistAreRefused) {
  const Jkr jkr(AdhesiveSphere::of(0.01, 65798, 0.096));
  const double limit = jkr.load_pull_off().normal_force;
  EXPECT_THROW(jkr.under_force(std::nextafter(limit, -1)), std::invalid_argument);
  EXPECT_THROW(jkr.under_force(std::nan("")), std::invalid_argument);
  EXPECT_THROW(jkr.under_force(std::numeric_limits<double>::infinity()), std::invalid_argument);
  EXPECT_THROW(jkr.unstable_under_force(0), std::invalid_argument);
  EXPECT_THROW(jkr.unstable_under_force(2 * limit), std::invalid_argument);
  EXPECT_THROW(jkr.at_approach(jkr.displacement_pull_off().approach * (1 + 1e-15)), std::invalid_argument);
  EXPECT_THROW(jkr.at_radius(0), std::invalid_argument);
  EXPECT_THAT([&] { jkr.pressure(1, 1); },
              ::testing::ThrowsMessage<std::invalid_argument>("r = 1 is not allowed: must lie in [0, 1)"));
  EXPECT_THAT([] { AdhesiveSphere::of(0.01, 65798, 0); },
              ::testing::ThrowsMessage<std::invalid_argument>("work_of_adhesion = 0 is not allowed: must be positive "
                                                              "and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
