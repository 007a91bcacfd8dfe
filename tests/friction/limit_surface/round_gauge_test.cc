// The gauge of round patches against 50 digits, against the gauge of any patch, and at its limits.
#include <patchgrip/friction/limit_surface/round_gauge.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>
#include <patchgrip/tests/friction/limit_surface/loads.h>
#include <patchgrip/tests/friction/limit_surface/round_gauge_reference.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction {
namespace {

using ::patchgrip::testing::cases;
using ::patchgrip::testing::units_of_rounding;

template <class P>
void expect_exact(const P& disc, double n, unsigned seed) {
  const RoundGaugeReference reference(n);
  const RoundLimitSurface surface(disc);
  std::mt19937_64 engine(seed);
  const PressureMoments moments = disc.moments();
  for (int i = 0; i < cases(150); ++i) {
    const Wrench t = draw_load(engine, moments);
    const Gauge g = surface.gauge(t);
    const RoundGaugeReference::Result exact = reference.gauge(t, disc.radius());
    ASSERT_EQ(g.status, GaugeStatus::converged);
    ASSERT_LE(units_of_rounding(g.value, exact.value), 8) << t.fx << ' ' << t.fy << ' ' << t.m;
    ASSERT_LE(g.lower, exact.value);
    ASSERT_GE(g.upper, exact.value);
    ASSERT_LE(g.upper - g.lower, 1e-14 * g.value);
    if (g.twist.w != 0) {
      const double x = std::hypot(g.twist.vx, g.twist.vy) / std::fabs(disc.radius() * g.twist.w);
      ASSERT_LE(std::fabs(static_cast<double>((x - exact.x) / exact.x)), 2e-14);
    }
  }
}

TEST(RoundGauge, AgreesWithFiftyDigits) {
  expect_exact(HertzDisc::of_radius(0.004), 1, 1);
  expect_exact(FlatPunchDisc::of_radius(3), 0, 2);
  expect_exact(UniformDisc::of_radius(0.1), 0.5, 3);
  expect_exact(Ring::of_radius(1), -0.5, 4);
  expect_exact(PowerDisc::of_radius(0.02, 2.5), 2.5, 5);
  expect_exact(PowerDisc::of_radius(0.02, -0.3), -0.3, 6);
}

template <class P>
void expect_same_as_any_patch(const P& patch, unsigned seed) {
  const RoundLimitSurface round(patch);
  const LimitSurface any(patch);
  std::mt19937_64 engine(seed);
  for (int i = 0; i < cases(1000); ++i) {
    const Wrench t = draw_load(engine, patch.moments());
    const Gauge g = round.gauge(t), other = any.gauge(t);
    ASSERT_EQ(g.status, GaugeStatus::converged);
    ASSERT_LE(g.lower, other.upper);
    ASSERT_GE(g.upper, other.lower);
    ASSERT_NEAR(power(t, g.twist), g.value, 2e-14 * g.value);
    ASSERT_NEAR(patch.dissipation(g.twist), 1, 2e-14);
  }
}

TEST(RoundGauge, AgreesWithTheGaugeOfAnyPatch) {
  expect_same_as_any_patch(XydasKaoDisc::of_radius(0.01, 0.7), 1);
  expect_same_as_any_patch(Placed(HertzDisc::of_radius(0.01), 0.01, -0.02), 2);
  expect_same_as_any_patch(Placed(Placed(Ring::of_radius(1), 0.5, 0.5), 0, -2), 3);
}

TEST(RoundGauge, LineLoadWithThePoleOnItIsSolved) {
  // f = m / a = 2 / pi with the pole on the ring.
  const Gauge g = RoundLimitSurface(Ring::of_radius(2)).gauge({0.6, 0.8, -2});
  EXPECT_NEAR(g.value, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(g.twist.vx / g.twist.w, -0.6 * 2, 1e-14);
  EXPECT_NEAR(g.twist.vy / g.twist.w, -0.8 * 2, 1e-14);
}

TEST(RoundGauge, PureForceAndPureMoment) {
  const RoundLimitSurface surface(HertzDisc::of_radius(0.5));
  const Gauge force = surface.gauge({-3, 4, 0});
  EXPECT_EQ(force.value, 5);
  EXPECT_EQ(force.twist.w, 0);
  EXPECT_DOUBLE_EQ(force.twist.vx, -0.6);
  const Gauge moment = surface.gauge({0, 0, -2});
  EXPECT_NEAR(moment.value, 2 / (3 * std::numbers::pi / 16 * 0.5), 1e-14);
  EXPECT_EQ(moment.twist.vx, 0);
  EXPECT_LT(moment.twist.w, 0);
}

TEST(RoundGauge, HoldsOverTheWholeRangeOfDoubles) {
  const RoundLimitSurface surface(HertzDisc::of_radius(1));
  for (const double size : {1e-320, 1e-300, 1e300}) {
    const double tolerance = size < 1e-310 ? 1e-2 : 1e-14;
    EXPECT_NEAR(surface.gauge({0.3 * size, 0.4 * size, 0.2 * size}).value / size, 0.64118525286497914271, tolerance);
  }
}

TEST(RoundGauge, NoLoadAndBadLoads) {
  const RoundLimitSurface surface(Ring::of_radius(1));
  EXPECT_EQ(surface.gauge({}).value, 0);
  EXPECT_TRUE(std::isnan(surface.gauge({0, std::numeric_limits<double>::infinity(), 1}).value));
}

TEST(RoundGauge, PlacedNoLoadAndBadLoads) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const RoundLimitSurface surface(Placed(HertzDisc::of_radius(1), 2, -3));
  EXPECT_EQ(surface.gauge({}).upper, 0);
  for (const Wrench& bad : {Wrench{nan, 0, 1}, Wrench{0, infinity, 1}, Wrench{1, 0, -infinity}}) {
    const Gauge g = surface.gauge(bad);
    EXPECT_EQ(g.status, GaugeStatus::not_finite);
    EXPECT_TRUE(std::isnan(g.value) && std::isnan(g.lower) && std::isnan(g.upper) && std::isnan(g.twist.w));
  }
}

// The moment about the centre, x fy, overflows where the load does not.
TEST(RoundGauge, PlacedHoldsOverTheWholeRangeOfDoubles) {
  const RoundLimitSurface surface(Placed(HertzDisc::of_radius(1), 300, -700));
  const Gauge one = surface.gauge({0.3, 0.4, 0.2});
  for (const int e : {-1000, -500, 500, 1010}) {
    const Gauge g = surface.gauge({std::scalbn(0.3, e), std::scalbn(0.4, e), std::scalbn(0.2, e)});
    EXPECT_EQ(g.status, GaugeStatus::converged);
    EXPECT_EQ(std::scalbn(g.value, -e), one.value);
    EXPECT_EQ(std::scalbn(g.lower, -e), one.lower);
    EXPECT_EQ(g.twist.w, one.twist.w);
  }
  const Gauge too_large = surface.gauge({1e308, 1.7e308, 1e308});
  EXPECT_TRUE(std::isinf(too_large.value) && std::isinf(too_large.upper) && std::isfinite(too_large.lower));
}

}  // namespace
}  // namespace patchgrip::friction
