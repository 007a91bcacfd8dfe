// The gauges of a Hertz disc against 50 digits: one to rounding, two cheap ones with their largest errors.
#include <patchgrip/friction/limit_surface/hertz_gauge.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/fast_hertz_gauge.h>
#include <patchgrip/friction/limit_surface/seed_gauge.h>
#include <patchgrip/tests/friction/limit_surface/loads.h>
#include <patchgrip/tests/friction/limit_surface/round_gauge_reference.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction {
namespace {

using ::patchgrip::testing::cases;
using ::patchgrip::testing::log_uniform;
using ::patchgrip::testing::uniform;
using ::patchgrip::testing::units_of_rounding;

constexpr double a = 0.0037;

// Half of them within 1e-15 to 1 of the load that puts the pole on the rim, F = 4 M / a.
Wrench draw(std::mt19937_64& engine) {
  if (uniform(engine, 0, 1) < 0.5) return draw_load(engine, HertzDisc::of_radius(a).moments());
  const double M = log_uniform(engine, 1e-3, 1e3) * a;
  const double side = uniform(engine, -1, 1) < 0 ? -1 : 1;
  const double F = 4 * M / a * (1 + side * log_uniform(engine, 1e-15, 1));
  const double direction = uniform(engine, -3, 3);
  return {F * std::cos(direction), F * std::sin(direction), uniform(engine, -1, 1) < 0 ? -M : M};
}

TEST(HertzGauge, IsExactToRounding) {
  const HertzGauge gauge = HertzGauge::of_radius(a);
  const RoundGaugeReference reference(1);
  const HertzDisc disc = HertzDisc::of_radius(a);
  std::mt19937_64 engine(1);
  for (int i = 0; i < cases(1000); ++i) {
    const Wrench t = draw(engine);
    const RoundGaugeReference::Result exact = reference.gauge(t, a);
    ASSERT_LE(units_of_rounding(gauge.value(t), exact.value), 8) << t.fx << ' ' << t.fy << ' ' << t.m;
    const Gauge g = gauge.gauge(t);
    ASSERT_LE(g.lower, exact.value);
    ASSERT_GE(g.upper, exact.value);
    const double x = std::hypot(g.twist.vx, g.twist.vy) / std::fabs(a * g.twist.w);
    ASSERT_LE(std::fabs(static_cast<double>((x - exact.x) / exact.x)), 1e-14) << t.fx << ' ' << t.fy << ' ' << t.m;
    ASSERT_NEAR(power(t, g.twist), g.value, 4e-15 * g.value);
    ASSERT_NEAR(disc.dissipation(g.twist), 1, 4e-15);
  }
}

// f^2 = (pi^2 / 48)(1 - q)(2 + q)^2 with q^2 = 8 m / pi - 1/2 down to the rim, m = 9 pi / 128.
TEST(HertzGauge, LimitCurveWithThePoleInsideIsAlgebraic) {
  const HertzGauge gauge = HertzGauge::of_radius(1);
  constexpr double pi = std::numbers::pi;
  for (int i = 0; i <= 100; ++i) {
    const double q = 0.25 + 0.75 * i / 100;
    const double f = pi / std::sqrt(48) * std::sqrt(1 - q) * (2 + q);
    const double m = pi / 8 * (q * q + 0.5);
    EXPECT_NEAR(gauge.value({0.6 * f, -0.8 * f, m}), 1, 1e-15);
  }
}

// The seed prints 256 m^2 / (9 pi^2) = (1 - f^2)(1 - f^2 / 4)^2 for all of it.
TEST(HertzGauge, SeedsLimitCurveIsAFit) {
  const HertzGauge gauge = HertzGauge::of_radius(1);
  double worst = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double f = i / 1000.0;
    const double m = 3 * std::numbers::pi / 16 * std::sqrt(1 - f * f) * (1 - f * f / 4);
    worst = std::max(worst, std::fabs(gauge.value({f, 0, m}) - 1));
  }
  EXPECT_GT(worst, 2.5e-3);
  EXPECT_LT(worst, 3.0e-3);
}

struct Sides {
  double excess = -1, deficit = -1;
};

template <class Cheap>
Sides scan(const Cheap& cheap, double radius) {
  const HertzGauge exact = HertzGauge::of_radius(radius);
  Sides sides;
  const auto look_at = [&](const Wrench& t) {
    const double error = cheap.value(t) / exact.value(t) - 1;
    sides = {std::max(sides.excess, error), std::max(sides.deficit, -error)};
  };
  const int steps = cases(40000);
  for (int i = 0; i <= steps; ++i) {
    const double angle = std::numbers::pi / 2 * i / steps;
    look_at({std::cos(angle), 0, radius * std::sin(angle)});
  }
  std::mt19937_64 engine(7);
  for (int i = 0; i < steps; ++i) look_at(draw_load(engine, {0, 0, 0.4 * radius * radius}));
  return sides;
}

constexpr double rounding = 16 * 0x1p-53;  // of both and of their quotient

TEST(FastHertzGauge, IsNeverTooSmallAndTooLargeByItsExcessAtMost) {
  const Sides sides = scan(FastHertzGauge::of_radius(a), a);
  EXPECT_LE(sides.excess, FastHertzGauge::largest_excess() + rounding);
  EXPECT_GE(sides.excess, 0.9 * FastHertzGauge::largest_excess());
  EXPECT_LE(sides.deficit, FastHertzGauge::largest_deficit() + rounding);
}

TEST(SeedGauge, ErrsOnBothSidesByAsMuchAsItSays) {
  const Sides sides = scan(SeedGauge::of_radius(a), a);
  EXPECT_LE(sides.excess, SeedGauge::largest_excess());
  EXPECT_GE(sides.excess, 0.97 * SeedGauge::largest_excess());
  EXPECT_LE(sides.deficit, SeedGauge::largest_deficit());
  EXPECT_GE(sides.deficit, 0.97 * SeedGauge::largest_deficit());
}

// Both brackets hold the true gauge, and the slip is the gradient of the value.
template <class Cheap>
void expect_model(const Cheap& cheap, double slip_error) {
  const HertzGauge exact = HertzGauge::of_radius(a);
  std::mt19937_64 engine(8);
  for (int i = 0; i < cases(2000); ++i) {
    const Wrench t = draw(engine), other = draw(engine);
    const Gauge g = cheap.gauge(t), truth = exact.gauge(t);
    EXPECT_NEAR(g.value, cheap.value(t), 4e-16 * g.value);
    ASSERT_LE(g.lower, truth.upper);
    ASSERT_GE(g.upper, truth.lower);
    ASSERT_LE(g.upper - g.lower, 1.01 * (cheap.largest_excess() + cheap.largest_deficit()) * g.value + 1e-15 * g.value);
    ASSERT_NEAR(power(t, g.twist), g.value, 2e-9 * g.value);
    const double h = 1e-6 * g.value / cheap.value(other);
    const auto along = [&](double k) {
      return cheap.value({t.fx + k * other.fx, t.fy + k * other.fy, t.m + k * other.m});
    };
    ASSERT_NEAR(power(other, g.twist) * h, (along(h) - along(-h)) / 2, slip_error * g.value);
  }
}

TEST(SeedGauge, BracketsTheGaugeAndSlipsAlongItsGradient) { expect_model(SeedGauge::of_radius(a), 1e-11); }

TEST(FastHertzGauge, BracketsTheGaugeAndSlipsAsTheExactOne) { expect_model(FastHertzGauge::of_radius(a), 1e-8); }

TEST(HertzGauge, HoldsOverTheWholeRangeOfDoubles) {
  const HertzGauge gauge = HertzGauge::of_radius(1);
  for (const double size : {1e-320, 1e-300, 1e-140, 1e140, 1e300}) {
    const Gauge g = gauge.gauge({0.3 * size, 0.4 * size, 0.2 * size});
    EXPECT_NEAR(g.value / size, 0.64118525286497914271, size < 1e-310 ? 1e-2 : 1e-15);
    EXPECT_NEAR(g.twist.vx / g.twist.w, 0.4686161848400172, size < 1e-310 ? 1e-2 : 1e-14);
    EXPECT_NEAR(FastHertzGauge::of_radius(1).value({0.3 * size, 0.4 * size, 0.2 * size}), g.value, 2e-9 * g.value);
    const Gauge seed = SeedGauge::of_radius(1).gauge({0.3 * size, 0.4 * size, 0.2 * size});
    EXPECT_LE(seed.lower, g.upper);
    EXPECT_GE(seed.upper, g.lower);
  }
}

TEST(HertzGauge, LimitsZeroAndBadLoads) {
  const HertzGauge gauge = HertzGauge::of_radius(2);
  EXPECT_NEAR(gauge.value({3, 4, 0}), 5, 1e-15);
  EXPECT_EQ(gauge.slip({3, 4, 0}).twist.w, 0);
  EXPECT_NEAR(gauge.value({0, 0, -3}), 3 / (3 * std::numbers::pi / 8), 1e-15);
  EXPECT_EQ(gauge.slip({0, 0, -3}).twist.vx, 0);
  EXPECT_EQ(gauge.value({}), 0);
  EXPECT_EQ(gauge.gauge({}).upper, 0);
  EXPECT_EQ(SeedGauge::of_radius(1).value({}), 0);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(gauge.value({bad, 0, 1})));
    EXPECT_TRUE(std::isnan(gauge.value({1, 0, bad})));
    EXPECT_EQ(gauge.gauge({0, bad, 0}).status, GaugeStatus::not_finite);
    EXPECT_TRUE(std::isnan(SeedGauge::of_radius(1).value({bad, 0, 0})));
    EXPECT_TRUE(std::isnan(FastHertzGauge::of_radius(1).value({bad, 0, 0})));
  }
}

TEST(HertzGauge, RadiusIsRefusedUnlessPositiveAndFinite) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(HertzGauge::of_radius(bad), std::invalid_argument);
    EXPECT_THROW(FastHertzGauge::of_radius(bad), std::invalid_argument);
    EXPECT_THROW(SeedGauge::of_radius(bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace patchgrip::friction
