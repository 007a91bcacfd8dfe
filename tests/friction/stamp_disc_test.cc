#include <patchgrip/friction/stamp_disc.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/kernels/round_functions.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/tests/friction/hessian.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;

constexpr double radius = 3e-3;

// Shares of a stamp f ~ r^m: w = (m + 1) s^m / a^(m + 1).
StampDisc power_stamp(double m) {
  return StampDisc::of_punches(
      radius, [m](double s) { return (m + 1) / radius * std::pow(s / radius, m); }, m);
}

double relative_difference(const Wrench& a, const Wrench& b) {
  const double force = std::hypot(a.fx - b.fx, a.fy - b.fy) / std::hypot(b.fx, b.fy);
  return std::fmax(force, std::fabs(a.m / b.m - 1));
}

std::vector<double> pole_distances() {
  std::vector<double> x{1e-12, 1e-6, 1e-3, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 1 - 1e-6, 1 - 1e-12, 1, 1 + 1e-12, 1 + 1e-6};
  for (const double far : {1.01, 1.1, 1.5, 2., 5., 1e2, 1e6, 1e12}) x.push_back(far);
  return x;
}

TEST(StampDisc, OfAParaboloidIsTheHertzDisc) {
  const auto stamp = power_stamp(2);
  const auto hertz = HertzDisc::of_radius(radius);
  EXPECT_NEAR(stamp.moments().polar, hertz.moments().polar, 1e-15 * hertz.moments().polar);
  for (const double x : pole_distances()) {
    const Twist v = twist_about(Pole{x * radius, 0}, 1);
    EXPECT_LE(relative_difference(stamp.gradient(v), hertz.gradient(v)), 16 * 0x1p-53) << x;
  }
}

// The pressure of a cone is arcosh(a / r): integrated over rings, which shares nothing with the stack of punches.
TEST(StampDisc, OfAConeAgreesWithItsPressure) {
  const auto stamp = power_stamp(1);
  const kernels::PowerFamily<long double> ring(-0.5L);
  boost::math::quadrature::tanh_sinh<long double> quadrature;
  for (const double x : pole_distances()) {
    if (x < 1e-6 || x > 1e6 || std::fabs(x - 1) < 1e-3) continue;  // the rings' own quadrature loses its digits there
    const auto mean = [&](auto function) {
      const auto weighted = [&](long double r) { return 2 * r * std::acosh(1 / r) * function(r); };
      const long double split = std::fmin(static_cast<long double>(x), 1.0L);
      return quadrature.integrate(weighted, 0.0L, split) +
             (split < 1 ? quadrature.integrate(weighted, split, 1.0L) : 0.0L);
    };
    const long double f = mean([&](long double r) {
      return x <= r ? ring.inside((r - x) / r).force * x / r : ring.outside((x - r) / x).force;
    });
    const long double m = mean([&](long double r) {
      return x <= r ? ring.inside((r - x) / r).moment * r : ring.outside((x - r) / x).moment * r * r / x;
    });
    const Wrench g = stamp.gradient(twist_about(Pole{x * radius, 0}, 1));
    EXPECT_NEAR(std::hypot(g.fx, g.fy) / static_cast<double>(f), 1, 1e-13) << x;
    EXPECT_NEAR(g.m / radius / static_cast<double>(m), 1, 1e-13) << x;
  }
}

TEST(StampDisc, OfHighOrderTendsToTheFlatPunch) {
  const auto punch = PowerDisc::of_radius(radius, 0);
  double last = 1;
  for (const double m : {10., 100., 1000.}) {
    const Twist v = twist_about(Pole{0.7 * radius, 0}, 1);
    const double difference = relative_difference(power_stamp(m).gradient(v), punch.gradient(v));
    EXPECT_LT(difference, 0.2 * last);
    last = difference;
  }
}

TEST(StampDisc, SharesThatDoNotCarryTheForceAreRefused) {
  const auto half = [] {
    StampDisc::of_punches(
        radius, [](double) { return 0.5 / radius; }, 1);
  };
  EXPECT_THAT(half, ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("share of the normal force = 0.5")));
  const auto order = [] {
    StampDisc::of_punches(
        radius, [](double) { return 1 / radius; }, 0.4);
  };
  EXPECT_THAT(order, ThrowsMessage<std::invalid_argument>("order = 0.4 is not allowed: must lie in [0.5, 1000]"));
}

}  // namespace
}  // namespace patchgrip::friction
