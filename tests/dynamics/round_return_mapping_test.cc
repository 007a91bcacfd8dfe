// The return mapping of round patches against 50 digits, in every regime; and what holds of every closest point.
#include <patchgrip/dynamics/round_return_mapping.h>

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>
#include <patchgrip/tests/dynamics/round_return_reference.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::dynamics {
namespace {

using friction::Wrench;
using testing::cases;
using testing::log_uniform;
using testing::uniform;

// What a random trial is about.
struct Regime {
  const char* name;
  double least_overshoot, largest_overshoot;  // g(s*) / L - 1
  double largest_ratio;                       // of rho, and 1 over it
  double nearly_pure = 1;                     // least share of the smaller of force and moment
};

constexpr Regime regimes[] = {
    {"generic", 1e-2, 10, 10},        {"nearly pure", 1e-2, 10, 10, 1e-12}, {"small overshoot", 1e-12, 1e-3, 10},
    {"large overshoot", 10, 1e9, 10}, {"stiffness ratio", 1e-3, 1e2, 1e6},  {"everything", 1e-9, 1e9, 1e6, 1e-9}};

struct Trial {
  Wrench wrench;
  double limit;
  RoundStiffness K;
};

template <class P>
Trial draw(std::mt19937_64& engine, const friction::RoundLimitSurface<P>& surface, const Regime& regime) {
  const double a = surface.patch().radius(), direction = uniform(engine, -3.2, 3.2);
  const double share = uniform(engine, 0, std::numbers::pi / 2);
  double F = std::cos(share), M = a * std::sin(share);
  if (regime.nearly_pure < 1) {
    (uniform(engine, -1, 1) < 0 ? F : M) *= log_uniform(engine, regime.nearly_pure, 1);
  }
  const Wrench t{F * std::cos(direction), F * std::sin(direction), uniform(engine, -1, 1) < 0 ? -M : M};
  const double limit = log_uniform(engine, 1e-3, 1e3), k = log_uniform(engine, 1e2, 1e7);
  const double overshoot = log_uniform(engine, regime.least_overshoot, regime.largest_overshoot);
  const double size = limit * (1 + overshoot) / surface.gauge(t).value;
  const double rho = log_uniform(engine, 1 / regime.largest_ratio, regime.largest_ratio);
  return {{size * t.fx, size * t.fy, size * t.m}, limit, {k, k * a * a / rho}};
}

template <class P>
void expect_exact(const P& disc, double n, unsigned seed) {
  const RoundReturnReference reference(n);
  const RoundReturnMapping<P> mapping(disc);
  const friction::RoundLimitSurface surface(disc);
  std::mt19937_64 engine(seed);
  const double a = disc.radius();
  for (const Regime& regime : regimes) {
    double evaluations = 0;
    const int count = cases(60);
    for (int i = 0; i < count; ++i) {
      const Trial t = draw(engine, surface, regime);
      const Returned r = mapping(t.wrench, t.limit, t.K);
      SCOPED_TRACE(::testing::Message() << regime.name << " " << t.wrench.fx << ' ' << t.wrench.fy << ' ' << t.wrench.m
                                        << " L " << t.limit << " K " << t.K.k << ' ' << t.K.k_r);
      evaluations += r.evaluations;
      ASSERT_LE(r.evaluations, 20);
      const double V = std::hypot(r.slip.vx, r.slip.vy);
      const auto exact = reference.closest(a, t.wrench, t.limit, t.K, r.slips ? V / (a * std::fabs(r.slip.w)) : 1);
      ASSERT_EQ(r.slips, exact.has_value());
      if (!exact) continue;
      const Wrench& s = r.wrench.value;
      const auto off = [](double found, const Real50& x) { return static_cast<double>(abs(found - x)); };
      EXPECT_LE(off(std::hypot(s.fx, s.fy), exact->force), r.wrench.force_error);
      EXPECT_LE(off(std::fabs(s.m), exact->moment), r.wrench.moment_error);
      const double root = std::sqrt(t.K.k * a * a / t.K.k_r);
      EXPECT_LE(r.wrench.force_error, 1e-14 * t.limit * std::max(1., root));
      EXPECT_LE(r.wrench.moment_error, 1e-14 * t.limit * a * std::max(1., 1 / root));
      // What slips is an overshoot that the rounding of the trial changes by as much.
      const double size = (V * t.K.k + std::fabs(r.slip.w) * t.K.k_r / a);
      EXPECT_LE(off(V, exact->V) * t.K.k, 1e-14 * (size + 10 * t.limit));
      EXPECT_LE(off(std::fabs(r.slip.w), exact->w) * t.K.k_r / a, 1e-14 * (size + 10 * t.limit));
      // Never against the friction, however small.
      EXPECT_GE(s.fx * r.slip.vx + s.fy * r.slip.vy + s.m * r.slip.w, 0);
    }
    EXPECT_LE(evaluations / count, 8) << regime.name;
  }
}

TEST(RoundReturnMapping, AgreesWithFiftyDigits) {
  expect_exact(friction::HertzDisc::of_radius(0.004), 1, 1);
  expect_exact(friction::FlatPunchDisc::of_radius(3), 0, 2);
  expect_exact(friction::UniformDisc::of_radius(0.1), 0.5, 3);
  expect_exact(friction::PowerDisc::of_radius(0.02, 2.5), 2.5, 5);
}

TEST(RoundReturnMapping, AgreesWithFiftyDigitsWhereThePressureIsInfiniteAtTheRim) {
  expect_exact(friction::Ring::of_radius(1), -0.5, 4);
  expect_exact(friction::PowerDisc::of_radius(0.02, -0.3), -0.3, 6);
}

TEST(RoundReturnMapping, TakesOneOrTwoEvaluationsOfAHertzDisc) {
  const friction::HertzDisc disc = friction::HertzDisc::of_radius(0.004);
  const RoundReturnMapping mapping(disc);
  const friction::RoundLimitSurface surface(disc);
  std::mt19937_64 engine(8);
  const auto evaluations = [&](const Regime& regime) {
    double sum = 0;
    const int count = cases(5000);
    for (int i = 0; i < count; ++i) {
      const Trial t = draw(engine, surface, regime);
      sum += mapping(t.wrench, t.limit, t.K).evaluations;
    }
    return sum / count;
  };
  EXPECT_LE(evaluations({"half beyond the limit", 0.4, 0.6, 10}), 1.5);
  EXPECT_LE(evaluations({"ten times the limit", 9, 11, 10}), 1.1);
  EXPECT_LE(evaluations(regimes[5]), 1.6);
}

// Limits and trials whose squares or inverses overflow are as any others.
TEST(RoundReturnMapping, AScaleChangesNothing) {
  const RoundReturnMapping mapping(friction::HertzDisc::of_radius(0.01));
  const RoundStiffness K{1e4, 2};
  const Returned one = mapping({3, -4, 0.02}, 2, K);
  ASSERT_TRUE(one.slips);
  for (const double k : {0x1p-1060, 0x1p-1000, 0x1p-800, 0x1p-400, 0x1p400, 0x1p800, 0x1p1000}) {
    const Returned r = mapping({k * 3, k * -4, k * 0.02}, k * 2, K);
    ASSERT_TRUE(r.slips) << k;
    const double unit = std::max(1e-15, 0x1p-1073 / k);
    EXPECT_NEAR(r.wrench.value.fx / k, one.wrench.value.fx, 4 * unit) << k;
    EXPECT_NEAR(r.wrench.value.fy / k, one.wrench.value.fy, 4 * unit) << k;
    EXPECT_NEAR(r.wrench.value.m / k, one.wrench.value.m, 4 * unit) << k;
    EXPECT_NEAR(r.slip.vx / k, one.slip.vx, 4 * unit) << k;
    EXPECT_NEAR(r.slip.w / k, one.slip.w, 4 * unit) << k;
  }
}

// It sticks exactly where the gauge says so.
template <class P>
void expect_stick_by_gauge(const P& disc) {
  const RoundReturnMapping<P> mapping(disc);
  const friction::RoundLimitSurface surface(disc);
  std::mt19937_64 engine(7);
  for (int i = 0; i < cases(2000); ++i) {
    Trial t = draw(engine, surface, regimes[0]);
    const double g = surface.gauge(t.wrench).value;
    const double side = uniform(engine, -1, 1) < 0 ? -1 : 1;
    t.limit = g * (1 + side * log_uniform(engine, 1e-13, 0.9));
    const Returned r = mapping(t.wrench, t.limit, t.K);
    ASSERT_EQ(r.slips, t.limit < g);
    if (r.slips) continue;
    EXPECT_EQ(r.slip.vx, 0);
    EXPECT_EQ(r.slip.vy, 0);
    EXPECT_EQ(r.slip.w, 0);
    EXPECT_EQ(r.wrench.value.fx, t.wrench.fx);
    EXPECT_EQ(r.wrench.value.fy, t.wrench.fy);
    EXPECT_EQ(r.wrench.value.m, t.wrench.m);
  }
}

TEST(RoundReturnMapping, SticksWhereTheGaugeSaysSo) {
  expect_stick_by_gauge(friction::HertzDisc::of_radius(0.004));
  expect_stick_by_gauge(friction::UniformDisc::of_radius(2));
  expect_stick_by_gauge(friction::Ring::of_radius(0.1));
  expect_stick_by_gauge(friction::XydasKaoDisc::of_radius(0.01, 0.7));
}

TEST(RoundReturnMapping, PureForceAndPureSpin) {
  const RoundReturnMapping mapping(friction::HertzDisc::of_radius(0.01));
  const RoundStiffness K{1e4, 2};
  const Returned slide = mapping({3, -4, 0}, 2, K);
  EXPECT_DOUBLE_EQ(slide.wrench.value.fx, 1.2);
  EXPECT_DOUBLE_EQ(slide.wrench.value.fy, -1.6);
  EXPECT_EQ(slide.wrench.value.m, 0);
  EXPECT_DOUBLE_EQ(slide.slip.vx, 1.8e-4);
  EXPECT_DOUBLE_EQ(slide.slip.vy, -2.4e-4);
  EXPECT_EQ(slide.slip.w, 0);
  const double limit = 2 * 3 * std::numbers::pi / 16 * 0.01;
  const Returned spin = mapping({0, 0, -0.1}, 2, K);
  EXPECT_DOUBLE_EQ(spin.wrench.value.m, -limit);
  EXPECT_DOUBLE_EQ(spin.slip.w, -(0.1 - limit) / 2);
  EXPECT_EQ(spin.slip.vx, 0);
}

TEST(RoundReturnMapping, NoFrictionLetsAllOfItSlip) {
  const RoundReturnMapping mapping(friction::HertzDisc::of_radius(0.01));
  const Returned r = mapping({3, -4, 0.1}, 0, {1e4, 2});
  EXPECT_TRUE(r.slips);
  EXPECT_EQ(r.wrench.value.fx, 0);
  EXPECT_EQ(r.wrench.value.m, 0);
  EXPECT_DOUBLE_EQ(r.slip.vx, 3e-4);
  EXPECT_DOUBLE_EQ(r.slip.w, 0.05);
}

TEST(RoundReturnMapping, WhatIsNotFiniteIsNotANumber) {
  const RoundReturnMapping mapping(friction::HertzDisc::of_radius(0.01));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const Wrench& t : {Wrench{nan, 0, 0}, Wrench{0, 0, nan}, Wrench{infinity, 0, 0}, Wrench{0, 1, -infinity}}) {
    const Returned r = mapping(t, 1, {1e4, 2});
    EXPECT_TRUE(std::isnan(r.wrench.value.fx));
    EXPECT_EQ(r.wrench.force_error, infinity);
  }
  for (const double limit : {nan, infinity, -1.}) {
    EXPECT_TRUE(std::isnan(mapping({1e-3, 0, 0}, limit, {1e4, 2}).wrench.value.fx)) << limit;
  }
}

}  // namespace
}  // namespace patchgrip::dynamics
