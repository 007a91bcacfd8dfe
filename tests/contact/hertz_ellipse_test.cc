#include <patchgrip/contact/hertz_ellipse.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>

#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/material.h>
#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::units_of_rounding;

// A row's radii as the decimals say them: R_small = ratio R_large is rounded once.
RelativeRadii radii_of(const patchgrip::testing::ContactRow& row) {
  return RelativeRadii::of(row.input("ratio") * row.input("R_large"), row.input("R_large"));
}

TEST(HertzEllipse, AgreesWithTheTableAtAGivenApproach) {
  const auto rows = contact_rows("hertz_ellipse");
  ASSERT_EQ(rows.size(), 5U);
  for (const auto& row : rows) {
    const auto h = HertzEllipse::at_approach(row.input("delta"), radii_of(row), row.input("E_star"));
    EXPECT_LE(units_of_rounding(h.a, row.output("a")), 3);
    EXPECT_LE(units_of_rounding(h.b, row.output("b")), 3);
    EXPECT_LE(units_of_rounding(h.peak_pressure, row.output("p0")), 3);
    EXPECT_LE(units_of_rounding(h.normal_force, row.output("F_N")), 3);
    EXPECT_LE(units_of_rounding(h.eccentricity, row.output("e")), 3);
  }
}

void agrees_under_load(const HertzEllipse& h, const patchgrip::testing::ContactRow& row) {
  EXPECT_LE(units_of_rounding(h.a, row.output("a")), 3);
  EXPECT_LE(units_of_rounding(h.b, row.output("b")), 3);
  EXPECT_LE(units_of_rounding(h.one_minus_b_a, row.output("one_minus_b_over_a")), 3);
  EXPECT_LE(units_of_rounding(h.eccentricity, row.output("e")), 3);
  EXPECT_LE(units_of_rounding(h.peak_pressure, row.output("p0")), 3);
  EXPECT_LE(units_of_rounding(h.approach, row.output("delta")), 3);
  EXPECT_LE(units_of_rounding(h.stiffness, row.output("stiffness")), 3);
}

TEST(HertzEllipse, AgreesWithTheTableUnderLoad) {
  const auto rows = contact_rows("hertz_ellipse_from_load");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    agrees_under_load(HertzEllipse::under_force(row.input("F_N"), radii_of(row), row.input("E_star")), row);
  }
}

TEST(HertzEllipse, AgreesWithTheTableNearTheCircle) {
  const auto rows = contact_rows("hertz_ellipse_near_circular");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto radii = RelativeRadii::of_one_minus_ratio(row.input("one_minus_ratio"), row.input("R_large"));
    agrees_under_load(HertzEllipse::under_force(row.input("F_N"), radii, row.input("E_star")), row);
  }
}

TEST(HertzEllipse, AgreesWithTheTableOfTwoBodies) {
  const auto rows = contact_rows("hertz_pair");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const double modulus = contact_modulus(Material::elastic(row.input("E_p"), row.input("nu_p")),
                                           Material::elastic(row.input("E_m"), row.input("nu_m")));
    const auto radii = RelativeRadii::of_bodies({row.input("R1p"), row.input("R2p")},
                                                {row.input("R1m"), row.input("R2m")}, row.input("alpha"));
    const auto h = HertzEllipse::under_force(row.input("F_N"), radii, modulus);
    EXPECT_LE(units_of_rounding(h.a, row.output("a")), 4);
    EXPECT_LE(units_of_rounding(h.b, row.output("b")), 4);
    EXPECT_LE(units_of_rounding(h.peak_pressure, row.output("p0")), 4);
    EXPECT_LE(units_of_rounding(h.approach, row.output("delta")), 4);
    EXPECT_LE(units_of_rounding(radii.angle_a, row.output("angle_a_from_R1p")), 8);
  }
}

TEST(HertzEllipse, EveryMemberHoldsItsBound) {
  std::mt19937_64 engine(20060130);
  const Exact pi = boost::math::constants::pi<Exact>();
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const bool near_circle = i % 2 == 1;
    const double part = log_uniform(engine, i % 4 == 0 ? 1e-8 : 1e-16, 1);
    const double large = log_uniform(engine, 1e-9, 1e9);
    const auto radii = near_circle ? RelativeRadii::of_one_minus_ratio(part / 2, large)
                                   : RelativeRadii::of(std::min(part * large, large), large);
    const double modulus = log_uniform(engine, 1, 1e12);
    const bool by_force = i % 3 != 0;
    const double control = by_force ? log_uniform(engine, 1e-12, 1e12) : log_uniform(engine, 1e-15, 1);
    const auto h = by_force ? HertzEllipse::under_force(control, radii, modulus)
                            : HertzEllipse::at_approach(control, radii, modulus);

    const auto shape = near_circle ? EllipseShape<Exact>::of_one_minus_ratio(Exact(part) / 2)
                                   : EllipseShape<Exact>::of_ratio(Exact(radii.small) / large);
    const Exact R(large), E(modulus), K = shape.integrals.K, D = shape.integrals.D;
    const Exact F = by_force ? Exact(control) : 2 * pi * E * control * sqrt(2 * R * control * D / K) / (3 * K);
    const Exact a = cbrt(3 * F * R * D / (pi * E));
    const Exact b = shape.k * a;
    const Exact p0 = 3 * F / (2 * pi * a * b);
    const Exact delta = p0 * b * K / E;
    worst = std::max({worst, units_of_rounding(h.normal_force, F), units_of_rounding(h.approach, delta),
                      units_of_rounding(h.a, a), units_of_rounding(h.b, b),
                      units_of_rounding(h.one_minus_b_a, shape.one_minus_k),
                      units_of_rounding(h.eccentricity, shape.eccentricity), units_of_rounding(h.peak_pressure, p0),
                      units_of_rounding(h.stiffness, 3 * F / (2 * delta))});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, HertzEllipse::error_units);
}

rc::Gen<double> magnitude(int decades) {
  return rc::gen::map(rc::gen::inRange(-decades * 1000, decades * 1000), [](int i) { return std::pow(10, 1e-3 * i); });
}

RelativeRadii any_radii() {
  const double large = *magnitude(3);
  return RelativeRadii::of(large * std::pow(10, -1e-3 * *rc::gen::inRange(0, 8000)), large);
}

RC_GTEST_PROP(HertzEllipse, ForceAndApproachAreInverse, ()) {
  const auto radii = any_radii();
  const double modulus = *magnitude(9), force = *magnitude(6);
  const auto h = HertzEllipse::under_force(force, radii, modulus);
  const auto back = HertzEllipse::at_approach(h.approach, radii, modulus);
  RC_ASSERT(std::abs(back.normal_force / force - 1) < 1e-15);
  RC_ASSERT(std::abs(back.a / h.a - 1) < 1e-15);
  RC_ASSERT(std::abs(back.peak_pressure / h.peak_pressure - 1) < 1e-15);
}

RC_GTEST_PROP(HertzEllipse, ScalesWithTheCubeRootOfTheForce, ()) {
  const auto radii = any_radii();
  const double modulus = *magnitude(9), force = *magnitude(6);
  const auto h = HertzEllipse::under_force(force, radii, modulus);
  const auto eightfold = HertzEllipse::under_force(8 * force, radii, modulus);
  RC_ASSERT(eightfold.a == 2 * h.a);
  RC_ASSERT(eightfold.b == 2 * h.b);
  RC_ASSERT(eightfold.approach == 4 * h.approach);
  RC_ASSERT(eightfold.peak_pressure == 2 * h.peak_pressure);
  RC_ASSERT(eightfold.stiffness == 2 * h.stiffness);
}

RC_GTEST_PROP(HertzEllipse, ForceRisesWithTheApproachAtItsStiffness, ()) {
  const auto radii = any_radii();
  const double modulus = *magnitude(9), depth = *magnitude(3), step = 1e-4;
  const auto h = HertzEllipse::at_approach(depth, radii, modulus);
  const double more = HertzEllipse::at_approach(depth * (1 + step), radii, modulus).normal_force;
  const double less = HertzEllipse::at_approach(depth * (1 - step), radii, modulus).normal_force;
  RC_ASSERT(less < h.normal_force && h.normal_force < more);
  RC_ASSERT(std::abs((more - less) / (2 * step * depth) / h.stiffness - 1) < 1e-8);
}

RC_GTEST_PROP(HertzEllipse, PressureCarriesTheForce, ()) {
  const auto h = HertzEllipse::under_force(*magnitude(6), any_radii(), *magnitude(9));
  RC_ASSERT(std::abs(h.elliptic_pressure().normal_force() / h.normal_force - 1) < 1e-15);
}

// Inside the zone the surface takes the shape of the gap: u_z = delta - x^2/(2 R_large) - y^2/(2 R_small).
RC_GTEST_PROP(HertzEllipse, SurfaceFillsTheGap, ()) {
  const auto radii = any_radii();
  const double modulus = *magnitude(9);
  const auto h = HertzEllipse::under_force(*magnitude(6), radii, modulus);
  const double reach = 0.01 * *rc::gen::inRange(0, 100), turn = 0.01 * *rc::gen::inRange(0, 628);
  const double x = h.a * reach * std::cos(turn), y = h.b * reach * std::sin(turn);
  const double gap = x * x / (2 * radii.large) + y * y / (2 * radii.small);
  RC_ASSERT(std::abs(h.elliptic_pressure().displacement(x, y, modulus) - (h.approach - gap)) < 4e-15 * h.approach);
}

RC_GTEST_PROP(HertzEllipse, IsTheCircleForEqualRadii, ()) {
  const double R = *magnitude(3), modulus = *magnitude(9), force = *magnitude(6);
  const auto h = HertzEllipse::under_force(force, RelativeRadii::of(R, R), modulus);
  const auto circle = HertzCircle::under_force(force, R, modulus);
  RC_ASSERT(h.a == h.b);
  RC_ASSERT(std::abs(h.a / circle.radius - 1) < 3e-16);
  RC_ASSERT(std::abs(h.approach / circle.approach - 1) < 3e-16);
  RC_ASSERT(std::abs(h.peak_pressure / circle.peak_pressure - 1) < 3e-16);
  RC_ASSERT(h.eccentricity == 0);
}

// A slender zone presses like a cylinder of the same peak line load 2 F'(0) = pi b p_0: b = 2 R_small p_0 / E*.
TEST(HertzEllipse, TendsToTheLineContactOfACylinder) {
  for (const double ratio : {1e-6, 1e-10, 1e-16}) {
    const auto h = HertzEllipse::under_force(1, RelativeRadii::of(0.01, 0.01 / ratio), 1e9);
    const double k = h.b / h.a;
    EXPECT_NEAR(h.b / (2 * 0.01 * h.peak_pressure / 1e9), 1, 5 * k * k * std::log(4 / k) + 1e-15);
  }
}

TEST(HertzEllipse, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  const auto radii = RelativeRadii::of(1, 2);
  EXPECT_THAT([&] { HertzEllipse::under_force(0, radii, 1); },
              refused("normal_force = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([&] { HertzEllipse::at_approach(-1, radii, 1); },
              refused("approach = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT([&] { HertzEllipse::under_force(1, radii, std::nan("")); },
              refused("contact_modulus = nan is not allowed: must be positive and finite"));
  EXPECT_THAT([&] { HertzEllipse::under_force(1, RelativeRadii::of(1e-31, 1), 1); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("radius_ratio")));
  EXPECT_THROW(HertzEllipse::under_force(1e308, radii, 1e-308), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
