#include <patchgrip/contact/elliptic_pressure.h>

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
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

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

TEST(EllipticPressure, DisplacementAgreesWithTheTable) {
  const auto rows = contact_rows("hertz_ellipse_field");
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) {
    const auto pressure = EllipticPressure::of(row.input("a"), row.input("b"), row.input("p0"));
    const double u = pressure.displacement(row.input("x"), row.input("y"), row.input("E_star"));
    EXPECT_LE(units_of_rounding(u, row.output("u_z_at_xy")), 3);
  }
}

Exact exact_level(const EllipticPressure& e, double x, double y) {
  const Exact along = Exact(x) / e.a, across = Exact(y) / e.b;
  return 1 - along * along - across * across;
}

Exact exact_displacement(const EllipticPressure& e, double x, double y, double modulus) {
  const Exact a2 = Exact(e.a) * e.a, b2 = Exact(e.b) * e.b, x2 = Exact(x) * x, y2 = Exact(y) * y;
  const Exact P = a2 + b2 - x2 - y2, Q = a2 * b2 * exact_level(e, x, y);
  const Exact w = Q >= 0 ? Exact(0) : (P > 0 ? -2 * Q / (P + sqrt(P * P - 4 * Q)) : (sqrt(P * P - 4 * Q) - P) / 2);
  const Exact A = a2 + w, B = b2 + w;
  const Exact integral = boost::math::ellint_rf(w, B, A) - x2 / 3 * boost::math::ellint_rd(B, w, A) -
                         y2 / 3 * boost::math::ellint_rd(A, w, B);
  return Exact(e.peak_pressure) * e.a * e.b / modulus * integral;
}

// Points inside, on the rim, near it and far away, of round and slender zones.
struct Draw {
  std::mt19937_64 engine{20060140};

  EllipticPressure zone(double slenderest) {
    const double a = log_uniform(engine, 1e-9, 1e3);
    return EllipticPressure::of(a, std::min(a, a * log_uniform(engine, slenderest, 1)),
                                log_uniform(engine, 1e-3, 1e12));
  }
  std::pair<double, double> point(const EllipticPressure& e, int i) {
    const double turn = uniform(engine, 0, 6.3);
    const double reach = i % 4 == 0   ? uniform(engine, 0, 1)
                         : i % 4 == 1 ? 1 + (i % 8 < 4 ? 1 : -1) * log_uniform(engine, 1e-14, 0.1)
                         : i % 4 == 2 ? log_uniform(engine, 1, 1e3)
                                      : log_uniform(engine, 1e-6, 1e6);
    if (i % 3 == 0) return {reach * e.a * std::cos(turn), reach * e.a * std::sin(turn)};  // a circle around it
    return {reach * e.a * std::cos(turn), reach * e.b * std::sin(turn)};
  }
};

TEST(EllipticPressure, HoldsItsBound) {
  Draw draw;
  double worst_displacement = 0, worst_pressure = 0, worst_force = 0;
  const Exact pi = boost::math::constants::pi<Exact>();
  for (int i = 0; i < cases(500); ++i) {
    const auto e = draw.zone(i % 2 == 0 ? 1e-3 : 1e-16);
    const auto [x, y] = draw.point(e, i);
    const double modulus = log_uniform(draw.engine, 1, 1e12);
    worst_displacement = std::max(
        worst_displacement, units_of_rounding(e.displacement(x, y, modulus), exact_displacement(e, x, y, modulus)));
    const Exact level = exact_level(e, x, y);
    worst_pressure = std::max(
        worst_pressure, units_of_rounding(e.pressure(x, y), level > 0 ? e.peak_pressure * sqrt(level) : Exact(0)));
    worst_force =
        std::max(worst_force, units_of_rounding(e.normal_force(), 2 * pi * Exact(e.a) * e.b * e.peak_pressure / 3));
  }
  RecordProperty("worst_units_displacement", std::to_string(worst_displacement));
  RecordProperty("worst_units_pressure", std::to_string(worst_pressure));
  EXPECT_LE(worst_displacement, 1.1);
  EXPECT_LE(worst_pressure, 1.1);
  EXPECT_LE(worst_force, 1.1);
}

// The point load superposed: u_z = (1 / pi E*) int p / distance, polar around the point, by quadrature.
TEST(EllipticPressure, IsThePotentialOfThePressure) {
  const auto e = EllipticPressure::of(0.003, 0.001, 2e5);
  boost::math::quadrature::tanh_sinh<double> over_angle, along_ray;
  for (const auto& [x, y] : {std::pair{0.001, 0.0004}, std::pair{0.0, 0.0}, std::pair{-0.002, 0.0005}}) {
    const double px = x, py = y;
    const auto ray = [&](double turn) {
      // The level along the ray is 1 - (A s^2 + 2 B s + C): its root ends the ray.
      const double c = std::cos(turn) / e.a, s = std::sin(turn) / e.b;
      const double A = c * c + s * s, B = c * px / e.a + s * py / e.b;
      const double C = px * px / (e.a * e.a) + py * py / (e.b * e.b);
      const double end = (std::sqrt(B * B + A * (1 - C)) - B) / A;
      return along_ray.integrate([&](double r) { return std::sqrt(std::max(0., 1 - C - r * (2 * B + A * r))); }, 0.,
                                 end);
    };
    const double potential = over_angle.integrate(ray, 0., 2 * std::numbers::pi);
    EXPECT_NEAR(e.displacement(x, y, 1e6) / (e.peak_pressure * potential / (std::numbers::pi * 1e6)), 1, 1e-9);
  }
}

RC_GTEST_PROP(EllipticPressure, FarAwayIsAPointLoad, ()) {
  const double slender = std::pow(10, -1e-2 * *rc::gen::inRange(0, 1600));
  const auto e = EllipticPressure::of(0.01, 0.01 * slender, 1e6);
  const double turn = 1e-2 * *rc::gen::inRange(0, 628);
  for (const double reach : {1e2, 1e4, 1e9}) {
    const double r = reach * e.a;
    const double point = e.normal_force() / (std::numbers::pi * 2e6 * r);
    RC_ASSERT(std::abs(e.displacement(r * std::cos(turn), r * std::sin(turn), 2e6) / point - 1) <
              0.3 / (reach * reach) + 1e-14);
  }
}

// Value and slope are continuous at the rim, the curvature is not: beyond it falls like the root of the distance, in
// units of the radius b^2/a of the sharp end.
RC_GTEST_PROP(EllipticPressure, SurfaceIsSmoothThroughTheRim, ()) {
  const auto e = EllipticPressure::of(0.01, 0.01 * std::pow(10, -1e-2 * *rc::gen::inRange(0, 150)), 1e6);
  const double turn = 1e-2 * *rc::gen::inRange(0, 628);
  const double x = e.a * std::cos(turn), y = e.b * std::sin(turn);
  const double step = 1e-5;
  const auto at = [&](double reach) { return e.displacement(reach * x, reach * y, 1e6); };
  RC_ASSERT(std::abs(at(1 + step) - 2 * at(1) + at(1 - step)) < 3 * std::pow(step, 1.5) * e.a / e.b * at(0));
  RC_ASSERT(at(1 + step) < at(1) && at(1) < at(1 - step));
}

RC_GTEST_PROP(EllipticPressure, IsSymmetricAndLinearInThePressure, ()) {
  const auto e = EllipticPressure::of(0.01, 0.004, 1e6);
  const auto twice = EllipticPressure::of(0.01, 0.004, 2e6);
  const double x = 1e-4 * *rc::gen::inRange(0, 300), y = 1e-4 * *rc::gen::inRange(0, 300);
  const double u = e.displacement(x, y, 1e6);
  RC_ASSERT(e.displacement(-x, y, 1e6) == u);
  RC_ASSERT(e.displacement(x, -y, 1e6) == u);
  RC_ASSERT(twice.displacement(x, y, 1e6) == 2 * u);
  RC_ASSERT(twice.pressure(x, y) == 2 * e.pressure(x, y));
}

TEST(EllipticPressure, VanishesOutside) {
  const auto e = EllipticPressure::of(2, 1, 5);
  EXPECT_EQ(e.pressure(0, 0), 5);
  EXPECT_EQ(e.pressure(2, 0), 0);
  EXPECT_EQ(e.pressure(0, -1), 0);
  EXPECT_EQ(e.pressure(1e300, -1e300), 0);
  EXPECT_EQ(e.displacement(1e308, 1e308, 1e20), 0);  // below the smallest double
}

TEST(EllipticPressure, OutOfRangeParametersAreNamed) {
  const auto refused = [](const std::string& message) {
    return ::testing::ThrowsMessage<std::invalid_argument>(message);
  };
  EXPECT_THAT([] { EllipticPressure::of(1, 2, 1); }, refused("b = 2 is not allowed: must lie in [1e-16, 1]"));
  EXPECT_THAT([] { EllipticPressure::of(0, 0, 1); }, refused("a = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { EllipticPressure::of(1, 1, -1); },
              refused("peak_pressure = -1 is not allowed: must be positive and finite"));
  const auto e = EllipticPressure::of(1, 1, 1);
  EXPECT_THAT([&] { e.pressure(std::nan(""), 0); }, refused("x = nan is not allowed: must be finite"));
  EXPECT_THAT([&] { e.displacement(0, std::numeric_limits<double>::infinity(), 1); },
              refused("y = inf is not allowed: must be finite"));
  EXPECT_THAT([&] { e.displacement(0, 0, 0); },
              refused("contact_modulus = 0 is not allowed: must be positive and finite"));
}

}  // namespace
}  // namespace patchgrip::contact
