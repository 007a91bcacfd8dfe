#include <patchgrip/friction/power_disc.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

auto refused(const std::string& message) { return ThrowsMessage<std::invalid_argument>(message); }
auto of(double radius, double n) {
  return [=] { PowerDisc::of_radius(radius, n); };
}

// Both are good to 8 units: they can't differ by more than 16.
template <class P>
void expect_same(const P& named, double n) {
  const PowerDisc power = PowerDisc::of_radius(named.radius(), n);
  EXPECT_DOUBLE_EQ(power.moments().polar, named.moments().polar);
  for (const double x : {0.0, 1e-9, 0.3, 0.5, 0.99, 1.0, 1 + 1e-12, 1.7, 1e6}) {
    const Twist v = twist_about({named.radius() * x * 0.6, named.radius() * x * 0.8}, 1);
    const Wrench a = named.gradient(v);
    const Wrench b = power.gradient(v);
    EXPECT_NEAR(a.fx, b.fx, 16 * 0x1p-53 * std::hypot(a.fx, a.fy)) << x;
    EXPECT_NEAR(a.fy, b.fy, 16 * 0x1p-53 * std::hypot(a.fx, a.fy)) << x;
    EXPECT_NEAR(a.m, b.m, 16 * 0x1p-53 * a.m) << x;
  }
}

TEST(PowerDisc, OfExponentZeroIsTheFlatPunch) { expect_same(FlatPunchDisc::of_radius(0.3), 0); }
TEST(PowerDisc, OfExponentOneHalfIsUniform) { expect_same(UniformDisc::of_radius(0.3), 0.5); }
TEST(PowerDisc, OfExponentOneIsHertz) { expect_same(HertzDisc::of_radius(0.3), 1); }

TEST(PowerDisc, TendsToTheRingAtTheLowerEnd) {
  const Ring ring = Ring::of_radius(1);
  for (const double excess : {1e-2, 1e-4, 1e-6}) {
    const PowerDisc disc = PowerDisc::of_radius(1, -0.5 + excess);
    for (const double x : {0.4, 0.97, 1.6}) {
      const Twist v = twist_about({0, x}, 1);
      EXPECT_NEAR(disc.gradient(v).fx, ring.gradient(v).fx, 2 * excess) << x;
      EXPECT_NEAR(disc.gradient(v).m, ring.gradient(v).m, 2 * excess) << x;
    }
  }
}

// A larger exponent gathers the load at the centre: at every pole the moment falls, and outside the force grows.
TEST(PowerDisc, LosesMomentAsItsPressureGathers) {
  double previous = infinity;
  for (const double n : {-0.49, -0.2, 0.0, 0.25, 1.0, 2.0, 7.3, 20.0}) {
    const double m = PowerDisc::of_radius(1, n).gradient({0.3, 0, 1}).m;
    EXPECT_LT(m, previous);
    previous = m;
  }
}

TEST(PowerDisc, PolarMomentIsThatOfItsPressure) {
  // <r^2> = (n + 1/2) int_0^1 s (1 - s)^(n - 1/2) ds = 1 / (n + 3/2)
  for (const double n : {-0.49, 0.25, 3.0, 20.0}) {
    const PressureMoments s = PowerDisc::of_radius(2, n).moments();
    EXPECT_EQ(s.x, 0);
    EXPECT_EQ(s.y, 0);
    EXPECT_DOUBLE_EQ(s.polar, 4 / (n + 1.5));
  }
}

TEST(PowerDisc, TellsItsRadiusAndExponent) {
  const PowerDisc disc = PowerDisc::of_radius(0.7, 1.25);
  EXPECT_EQ(disc.radius(), 0.7);
  EXPECT_EQ(disc.area_radius(), 0.7);
  EXPECT_EQ(disc.exponent(), 1.25);
}

TEST(PowerDisc, ExponentsThatNoForceCarriesAreRefused) {
  EXPECT_THAT(of(1, -0.5), refused("exponent = -0.5 is not allowed: must lie in (-0.5, 20]"));
  EXPECT_THAT(of(1, -1), refused("exponent = -1 is not allowed: must lie in (-0.5, 20]"));
  EXPECT_THAT(of(1, 20.5), refused("exponent = 20.5 is not allowed: must lie in (-0.5, 20]"));
  EXPECT_THAT(of(1, nan), refused("exponent = nan is not allowed: must lie in (-0.5, 20]"));
  EXPECT_THAT(of(1, infinity), refused("exponent = inf is not allowed: must lie in (-0.5, 20]"));
}

TEST(PowerDisc, RadiiThatAreNotPositiveAndFiniteAreRefused) {
  EXPECT_THAT(of(0, 1), refused("radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(of(nan, 1)(), std::invalid_argument);
  EXPECT_THROW(of(infinity, 1)(), std::invalid_argument);
}

TEST(PowerDisc, TheEndsOfTheDomainAreAllowed) {
  EXPECT_NO_THROW(of(1, 20)());
  EXPECT_NO_THROW(of(1, std::nextafter(-0.5, 0))());
}

}  // namespace
}  // namespace patchgrip::friction
