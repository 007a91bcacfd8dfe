// Pade forms of the friction of round patches: what they meet, how far they are off, and what they are not.
#include <patchgrip/friction/limit_surface/pade_wrench.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {
namespace {

constexpr double pi = std::numbers::pi;

template <class Test>
void for_every_disc(const Test& test) {
  test(HertzDisc::of_radius(0.0037));
  test(UniformDisc::of_radius(3));
  test(FlatPunchDisc::of_radius(1));
  test(Ring::of_radius(20));
}

Twist random_twist(std::mt19937_64& engine, double radius) {
  const double phi = testing::uniform(engine, -pi, pi), x = testing::log_uniform(engine, 1e-6, 1e6);
  const double w = testing::uniform(engine, -1, 1);
  return {x * radius * w * std::cos(phi), x * radius * w * std::sin(phi), w};
}

TEST(PadeWrench, OfAHertzDiscIsThatOfZhuravlev) {
  const double a = 0.01, V = 0.3, w = -20, W = a * 20;
  const Wrench t = PadeWrench::first_order(HertzDisc::of_radius(a)).gradient({0.6 * V, 0.8 * V, w});
  EXPECT_NEAR(std::hypot(t.fx, t.fy), V / (V + 8 / (3 * pi) * W), 1e-14);
  EXPECT_NEAR(t.fy / t.fx, 0.8 / 0.6, 1e-14);
  EXPECT_NEAR(t.m, -3 * pi / 16 * a * W / (W + 15 * pi / 16 * V), 1e-15);
}

TEST(PadeWrench, LargestErrorsAreThoseOfItsHeader) {
  const auto expect = [](const PadeWrench& form, double M0, double force, double moment) {
    EXPECT_NEAR(form.force_error(), force, 2e-5);
    EXPECT_NEAR(form.moment_error() / M0, moment, 2e-5);
  };
  expect(PadeWrench::first_order(HertzDisc::of_radius(1)), 3 * pi / 16, 0.34371, 0.39162);
  expect(PadeWrench::second_order(HertzDisc::of_radius(1)), 3 * pi / 16, 0.16411, 0.19949);
  expect(PadeWrench::first_order(UniformDisc::of_radius(1)), 2. / 3, 0.35833, 0.40051);
  expect(PadeWrench::second_order(UniformDisc::of_radius(1)), 2. / 3, 0.18423, 0.21823);
}

TEST(PadeWrench, ErrsByNoMoreThanItSaysAndByAsMuch) {
  for_every_disc([](const auto& disc) {
    for (const auto& form : {PadeWrench::first_order(disc), PadeWrench::second_order(disc)}) {
      std::mt19937_64 engine(2);
      double force = 0, moment = 0;
      for (int i = 0; i < testing::cases(20000); ++i) {
        const Twist v = random_twist(engine, disc.radius());
        const Wrench t = form.gradient(v), exact = disc.gradient(v);
        force = std::max(force, std::hypot(t.fx - exact.fx, t.fy - exact.fy));
        moment = std::max(moment, std::fabs(t.m - exact.m));
      }
      EXPECT_LE(force, form.force_error());
      EXPECT_GE(force, form.force_error() - 1e-3);
      EXPECT_LE(moment, form.moment_error());
      EXPECT_GE(moment, form.moment_error() - 1e-3 * disc.radius());
    }
  });
}

// d = V / W or W / V: values and slopes at 0, the curvatures of second order too. The ring's f is not smooth, but at 0.
TEST(PadeWrench, MeetsTheExactWrenchWhereOneSpeedVanishes) {
  for_every_disc([](const auto& disc) {
    const double a = disc.radius(), d = 1e-4, M0 = disc.gradient({0, 0, 1}).m;
    const auto first = PadeWrench::first_order(disc), second = PadeWrench::second_order(disc);
    const Twist slow{d, 0, 1 / a}, fast{1, 0, d / a};
    const Wrench s = disc.gradient(slow), f = disc.gradient(fast);
    EXPECT_NEAR(first.gradient(slow).fx, s.fx, 2 * d * d);
    EXPECT_NEAR(second.gradient(slow).fx, s.fx, 4 * d * d * d);
    EXPECT_NEAR(first.gradient({0, 0, 1}).m, M0, 1e-15 * a);
    EXPECT_NEAR(second.gradient(slow).m, s.m, 4 * d * d * d * a);
    EXPECT_NEAR(first.gradient(fast).m, f.m, 2 * d * d * a);
    EXPECT_NEAR(second.gradient(fast).m, f.m, 4 * d * d * a);
    EXPECT_NEAR(second.gradient(fast).fx, f.fx, 5 * d * d);
    EXPECT_EQ(first.gradient({0, -2, 0}).fy, -1);
    EXPECT_GT(f.fx - first.gradient(fast).fx, 0.8 * d);  // the kink of first order
  });
}

TEST(PadeWrench, IsNoGradientOfADissipation) {
  for_every_disc([](const auto& disc) {
    const double a = disc.radius();
    for (const auto& form : {PadeWrench::first_order(disc), PadeWrench::second_order(disc)}) {
      // dfx/dw and dm/dvx at V = 2 W, equal where there is a potential.
      const double h = 1e-4;
      const double force = form.gradient({2, 0, (1 + h) / a}).fx - form.gradient({2, 0, (1 - h) / a}).fx;
      const double moment = (form.gradient({2 + h, 0, 1 / a}).m - form.gradient({2 - h, 0, 1 / a}).m) / a;
      EXPECT_GT(std::fabs(force - moment), 0.02 * std::fabs(force));
    }
  });
}

struct Range {
  double least = std::numeric_limits<double>::infinity(), largest = 0;
};

// Power in units of the exact dissipation, over all poles.
template <class Disc>
Range powers(const PadeWrench& form, const Disc& disc) {
  Range range;
  for (int i = 0; i <= 10000; ++i) {
    const double x = i / 10000.;
    const Twist v{x, 0, (1 - x) / disc.radius()};
    const double ratio = form.dissipation(v) / disc.dissipation(v);
    range = {std::min(range.least, ratio), std::max(range.largest, ratio)};
  }
  return range;
}

TEST(PadeWrench, DissipatesTooLittleAndSecondOrderAlsoTooMuch) {
  const HertzDisc disc = HertzDisc::of_radius(0.01);
  const Range first = powers(PadeWrench::first_order(disc), disc);
  EXPECT_NEAR(first.least, 0.5789, 1e-4);
  EXPECT_LE(first.largest, 1 + 1e-15);
  const Range second = powers(PadeWrench::second_order(disc), disc);
  EXPECT_NEAR(second.least, 0.9451, 1e-4);
  EXPECT_NEAR(second.largest, 1.0007, 1e-4);
}

// More than any wrench of Coulomb friction: outside the limit surface.
TEST(PadeWrench, OfSecondOrderLeavesTheLimitSurface) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  const LimitSurface surface(disc);
  const auto form = PadeWrench::second_order(disc);
  double largest = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = i / 1000.;
    largest = std::max(largest, surface.gauge(form.gradient({x, 0, 1 - x})).lower);
  }
  EXPECT_NEAR(largest, 1.0008, 1e-4);
}

TEST(PadeWrench, OpposesMotionWhateverItsSizeAndTheDiscs) {
  std::mt19937_64 engine(4);
  const auto unit = PadeWrench::second_order(HertzDisc::of_radius(1));
  const auto small = PadeWrench::second_order(HertzDisc::of_radius(1e-3));
  EXPECT_NEAR(small.moment_error(), 1e-3 * unit.moment_error(), 1e-8);
  for (int i = 0; i < testing::cases(1000); ++i) {
    const Twist v = random_twist(engine, 1);
    const Wrench t = unit.gradient(v), back = unit.gradient({-7 * v.vx, -7 * v.vy, -7 * v.w});
    EXPECT_GT(power(t, v), 0);
    EXPECT_NEAR(t.fx, -back.fx, 1e-15);
    EXPECT_NEAR(t.m, -back.m, 1e-15);
    EXPECT_NEAR(small.gradient({1e-3 * v.vx, 1e-3 * v.vy, v.w}).m, 1e-3 * t.m, 1e-18);
  }
  EXPECT_EQ(unit.gradient({}).fx, 0);
  EXPECT_EQ(unit.gradient({}).m, 0);
  EXPECT_EQ(unit.area_radius(), 1);
  EXPECT_NEAR(unit.moments().polar, 0.4, 1e-15);
}

}  // namespace
}  // namespace patchgrip::friction
