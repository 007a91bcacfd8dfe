#include <patchgrip/friction/law.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

auto refused(const std::string& message) { return ThrowsMessage<std::invalid_argument>(message); }

const std::vector<Twist> motions{{0.05, 0.1, 0.4}, {-0.2, 0.15, -0.1}, {0, 0, 1}, {1, -2, 0}, {0, 1e-9, 3}};

TEST(Coulomb, IsTheFrictionCoefficientTimesTheLoadTimesTheGradient) {
  const HertzDisc disc = HertzDisc::of_radius(0.02);
  for (const Twist& v : motions) {
    const BoundedWrench t = friction_wrench(Law::coulomb(0.4), 30, disc, v);
    const Wrench g = disc.gradient(v);
    EXPECT_DOUBLE_EQ(t.value.fx, -12 * g.fx);
    EXPECT_DOUBLE_EQ(t.value.fy, -12 * g.fy);
    EXPECT_DOUBLE_EQ(t.value.m, -12 * g.m);
  }
}

TEST(Coulomb, IsStribeckWithEqualCoefficients) {
  const Law coulomb = Law::coulomb(0.4), stribeck = Law::stribeck(0.4, 0.4, 0.1);
  const HertzDisc disc = HertzDisc::of_radius(0.02);
  for (const Twist& v : motions) {
    const BoundedWrench a = friction_wrench(coulomb, 3, disc, v), b = friction_wrench(stribeck, 3, disc, v);
    EXPECT_TRUE(a.value.fx == b.value.fx && a.value.fy == b.value.fy && a.value.m == b.value.m);
    EXPECT_TRUE(a.force_error == b.force_error && a.moment_error == b.moment_error);
  }
}

// v_m^2 = int |v_P|^2 p / F_N dA by a rule that is exact for quadratics.
TEST(MeanSquareSpeed, IsTheMeanOverThePressure) {
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  const Placed rectangle(Rectangle::of_sides(0.6, 0.2), 1.5, -0.7);
  for (const Twist& v : motions) {
    const double mean = Gauss::integrate(
                            [&](double x) {
                              return Gauss::integrate(
                                  [&](double y) {
                                    const double vx = v.vx - v.w * y, vy = v.vy + v.w * x;
                                    return vx * vx + vy * vy;
                                  },
                                  -0.8, -0.6);
                            },
                            1.2, 1.8) /
                        0.12;
    EXPECT_NEAR(mean_square_speed(rectangle.moments(), v), mean, 1e-14 * mean);
  }
}

// The print has M . s_0 where -2 M . s_0 belongs (4.48b): |M|^2 w^2 - 2 w^2 M . s_0 + w^2 s_1.
TEST(MeanSquareSpeed, HasTheCorrectedPoleTerm) {
  const PressureMoments s{0.3, -0.2, 0.05};
  const Pole M{0.7, 0.4};
  const double s1 = s.x * s.x + s.y * s.y + s.polar;
  const double w = 1.5;
  const double corrected = w * w * (M.x * M.x + M.y * M.y - 2 * (M.x * s.x + M.y * s.y) + s1);
  const double printed = w * w * (M.x * M.x + M.y * M.y + M.x * s.x + M.y * s.y + s1);
  EXPECT_NEAR(mean_square_speed(s, twist_about(M, w)), corrected, 1e-15);
  EXPECT_GT(std::fabs(printed - corrected), 0.1);
}

TEST(MeanSquareSpeed, OfARotationAboutTheCentroidIsThePolarMoment) {
  const PressureMoments s{3, -2, 0.05};
  EXPECT_NEAR(mean_square_speed(s, twist_about({3, -2}, 2)), 4 * 0.05, 1e-16);
}

TEST(Stribeck, FallsFromStaticToKineticAsExpOfTheSquare) {
  const Law law = Law::stribeck(0.9, 0.5, 0.3);
  const PressureMoments s = HertzDisc::of_radius(1).moments();
  EXPECT_EQ(coefficient(law, s, {}), 0.9);
  EXPECT_NEAR(coefficient(law, s, {0.3, 0, 0}), 0.5 + 0.4 * std::exp(-1.0), 1e-15);
  EXPECT_NEAR(coefficient(law, s, {0, 0, 0.3}), 0.5 + 0.4 * std::exp(-0.4), 1e-15);  // <r^2> = 2/5
  EXPECT_EQ(coefficient(law, s, {30, 0, 0}), 0.5);
  EXPECT_EQ(coefficient(law, s, {1e300, 0, 0}), 0.5);
}

TEST(Stribeck, MayRiseToo) {
  const Law law = Law::stribeck(0.2, 0.5, 0.3);
  EXPECT_EQ(coefficient(law, {}, {}), 0.2);
  EXPECT_NEAR(coefficient(law, {}, {0.3, 0, 0}), 0.5 - 0.3 * std::exp(-1.0), 1e-15);
}

// Every point slides with the same speed then, and has the same coefficient.
TEST(Stribeck, InTheMeanIsStribeckAtEveryPointForATranslation) {
  const Law law = Law::stribeck(0.9, 0.5, 0.3);
  for (const double speed : {0.01, 0.2, 0.7}) {
    const double local = (0.5 + 0.4 * std::exp(-speed * speed / 0.09)) * 10;
    const Wrench t = friction_wrench(law, 10, l_shape.patch(), {0, -speed, 0}).value;
    EXPECT_NEAR(t.fx, 0, 1e-15);
    EXPECT_NEAR(t.fy, local, 1e-14);
  }
}

// Stored to 20 digits: a Hertz and a uniform disc of radius 1 m, mu_s = 0.9, mu_k = 0.5, v_S = 0.3 m/s, F_N = 10 N.
TEST(Stribeck, InTheMeanHasItsReferenceValues) {
  const Law law = Law::stribeck(0.9, 0.5, 0.3);
  const Wrench a = friction_wrench(law, 10, HertzDisc::of_radius(1), {0.05, 0.1, 0.4}).value;
  EXPECT_NEAR(a.fx, -0.968780538014075396950, 1e-14);
  EXPECT_NEAR(a.fy, -1.93756107602815079390, 1e-14);
  EXPECT_NEAR(a.m, -3.65258727996516997583, 1e-14);
}

TEST(Viscous, HasItsReferenceValues) {
  const Polygon patch = Polygon::uniform({{0, 0}, {0.03, 0.004}, {0.011, 0.021}});
  const Law law = Law::viscous(0.7);
  const Wrench a = friction_wrench(law, 3, patch, {0.2, -0.1, 1.5}).value;
  EXPECT_NEAR(a.fx, -0.39375, 1e-16);
  EXPECT_NEAR(a.fy, 0.16695, 1e-16);
  EXPECT_NEAR(a.m, 0.0053767, 1e-17);
  const Wrench b = friction_wrench(law, 3, patch, {0, 0.3, -2}).value;
  EXPECT_NEAR(b.fx, -0.035, 1e-16);
  EXPECT_NEAR(b.fy, -0.5726, 1e-15);
  EXPECT_NEAR(b.m, -0.0072856, 1e-17);
}

TEST(Viscous, DissipatesTheMeanSquareSpeed) {
  const Placed patch(Ring::of_radius(0.5), 2, 1);
  for (const Twist& v : motions) {
    const double expected = -0.7 * 3 * mean_square_speed(patch.moments(), v);
    EXPECT_NEAR(power(friction_wrench(Law::viscous(0.7), 3, patch, v).value, v), expected, 1e-14 * std::fabs(expected));
  }
}

TEST(Law, WithAViscousPartIsTheSumOfBoth) {
  const Law dry = Law::stribeck(0.9, 0.5, 0.3), wet = Law::viscous(0.7), both = dry.with_viscous(0.7);
  const Polygon patch = l_shape.patch();
  for (const Twist& v : motions) {
    const Wrench d = friction_wrench(dry, 3, patch, v).value, w = friction_wrench(wet, 3, patch, v).value;
    const Wrench t = friction_wrench(both, 3, patch, v).value;
    EXPECT_NEAR(t.fx, d.fx + w.fx, 1e-15);
    EXPECT_NEAR(t.fy, d.fy + w.fy, 1e-15);
    EXPECT_NEAR(t.m, d.m + w.m, 4e-15);
  }
}

TEST(Law, AtRestThereIsNoWrench) {
  const BoundedWrench t = friction_wrench(Law::stribeck(0.9, 0.5, 0.3).with_viscous(1), 10, l_shape.patch(), {});
  EXPECT_TRUE(t.value.fx == 0 && t.value.fy == 0 && t.value.m == 0);
  EXPECT_EQ(t.force_error, 0);
  EXPECT_EQ(t.moment_error, 0);
}

TEST(Law, WithoutLoadThereIsNoWrench) {
  const BoundedWrench t = friction_wrench(Law::coulomb(1).with_viscous(1), 0, HertzDisc::of_radius(1), {1, 2, 3});
  EXPECT_TRUE(t.value.fx == 0 && t.value.fy == 0 && t.value.m == 0);
}

// All of it in 50 digits: gradient, coefficient and viscous part, patch away from the origin or not.
TEST(Law, BoundsHoldAgainstFiftyDigits) {
  const kernels::PowerFamily<Real50> family(0);
  std::mt19937_64 engine(20060103);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto log_uniform = [&](double lo, double hi) { return lo * std::pow(hi / lo, unit(engine)); };
  for (int i = 0; i < 400; ++i) {
    const double radius = log_uniform(1e-4, 1);
    const double x = i % 2 == 0 ? 0 : radius * (unit(engine) - 0.5) * 40,
                 y = i % 2 == 0 ? 0 : radius * (unit(engine) - 0.5) * 40;
    const double r = radius * log_uniform(1e-3, 1e4), angle = 2 * std::numbers::pi * unit(engine);
    const Twist v =
        twist_about({x + r * std::cos(angle), y + r * std::sin(angle)}, (i % 3 == 0 ? -1 : 1) * log_uniform(1e-2, 1e2));
    const double mu_s = 2 * unit(engine), mu_k = 2 * unit(engine), v_S = log_uniform(1e-3, 10);
    const double mu_V = i % 4 == 0 ? 0 : log_uniform(1e-3, 10), F = log_uniform(1e-3, 1e3);
    const Law law = Law::stribeck(mu_s, mu_k, v_S).with_viscous(mu_V);
    const BoundedWrench t = friction_wrench(law, F, Placed(FlatPunchDisc::of_radius(radius), x, y), v);

    const Real50 cx = v.vx - Real50(v.w) * y, cy = v.vy + Real50(v.w) * x, w = v.w,
                 polar = 2 * Real50(radius) * radius / 3;
    const Wrench50 g = round_wrench(family, radius, cx, cy, w);
    const Real50 mu = mu_k + (Real50(mu_s) - mu_k) * exp(-(cx * cx + cy * cy + w * w * polar) / (Real50(v_S) * v_S));
    const Real50 fx = -F * (mu * g.fx + mu_V * cx), fy = -F * (mu * g.fy + mu_V * cy);
    const Real50 m = -F * (mu * g.m + mu_V * w * polar) + x * fy - y * fx;
    EXPECT_LE(static_cast<double>(hypot(t.value.fx - fx, t.value.fy - fy)), t.force_error) << i;
    EXPECT_LE(static_cast<double>(abs(t.value.m - m)), t.moment_error) << i;
    // And the bounds are of use: mu <= 2, viscous part by its terms.
    const double arm = std::hypot(x, y) + radius;
    const double speed = std::hypot(v.vx, v.vy) + std::fabs(v.w) * arm;
    const double z = std::min(speed * speed / (v_S * v_S), 1e3);
    EXPECT_LE(t.force_error, 1e-14 * F * (2 * (1 + z) + mu_V * speed));
    EXPECT_LE(t.moment_error, 2e-14 * F * arm * (2 * (1 + z) + mu_V * speed));
  }
}

TEST(Law, ParametersOutsideTheirDomainAreRefused) {
  EXPECT_THAT([] { Law::coulomb(-0.1); }, refused("mu = -0.1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { Law::coulomb(nan); }, refused("mu = nan is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { Law::stribeck(-1, 0.5, 0.1); },
              refused("mu_static = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { Law::stribeck(1, infinity, 0.1); },
              refused("mu_kinetic = inf is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { Law::stribeck(1, 0.5, 0); },
              refused("stribeck_velocity = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { Law::viscous(-2); }, refused("mu_viscous = -2 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { Law::coulomb(1).with_viscous(nan); },
              refused("mu_viscous = nan is not allowed: must be non-negative and finite"));
  EXPECT_NO_THROW(Law::coulomb(0));
  EXPECT_NO_THROW(Law::stribeck(0, 0, 1e-300));
}

TEST(Law, AVelocityTooSmallToSquareIsStillALaw) {
  const Law law = Law::stribeck(0.9, 0.5, 1e-200);
  EXPECT_EQ(coefficient(law, {}, {1, 0, 0}), 0.5);
  EXPECT_EQ(coefficient(law, {}, {}), 0.9);
}

}  // namespace
}  // namespace patchgrip::friction
