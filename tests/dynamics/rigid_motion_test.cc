// Break-away, slip and stop of a body on a rigid patch, against closed forms and known runs.
#include <patchgrip/dynamics/rigid_motion.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/rectangle.h>

namespace patchgrip::dynamics {
namespace {

using friction::HertzDisc;
using friction::Law;
using Kind = SlipEvent::Kind;

PlanarLoad pushed(std::function<Vector3(double)> force, double normal_force = 10, std::vector<double> jumps = {}) {
  return {std::move(force), [=](double) { return normal_force; }, std::move(jumps)};
}

// The disc of figures 4.30 and 4.31 without bristles: 0.49 N throughout, a moment from 5 s to 15 s.
RigidMotionResult disc(double moment) {
  const RigidMotion motion(HertzDisc::of_radius(0.2), 1, 1, Law::stribeck(1, 0.5, 0.05));
  const auto force = [=](double t) { return Vector3(0.49, 0, t >= 5 && t < 15 ? moment : 0); };
  return motion(pushed(force, 1, {5, 15}), {}, 0, 100, {.tolerance = 1e-13});
}

TEST(RigidMotion, TheDiscOfTheFiguresStopsWhereItIsKnownTo) {
  for (const auto& [moment, stop] : {std::pair{.1167, 24.835538557}, {.11924, 44.0032889204}}) {
    const RigidMotionResult r = disc(moment);
    ASSERT_EQ(r.events.size(), 2u);
    EXPECT_EQ(r.events[0].kind, Kind::break_away);
    EXPECT_EQ(r.events[0].time, 5);
    EXPECT_EQ(r.events[1].kind, Kind::stop);
    EXPECT_NEAR(r.events[1].time, stop, 1e-9);
    EXPECT_LE(r.events[1].error, 1e-7);
    EXPECT_TRUE(r.state.twist.isZero(0));
  }
}

TEST(RigidMotion, StatesAreKnownAtSamples) {
  const RigidMotion motion(HertzDisc::of_radius(0.2), 1, 1, Law::stribeck(1, 0.5, 0.05));
  const auto force = [](double t) { return Vector3(0.49, 0, t >= 5 && t < 15 ? .11924 : 0); };
  std::vector<double> seen;
  PlanarState at_15;
  motion(pushed(force, 1, {5, 15}), {}, 0, 100, {}, {1, 5, 15 - 1e-12, 50}, [&](double t, const PlanarState& s) {
    seen.push_back(t);
    if (t > 14 && t < 16) at_15 = s;
    EXPECT_EQ(s.twist.isZero(0), t < 6 || t > 40) << t;
  });
  EXPECT_EQ(seen, (std::vector<double>{1, 5, 15 - 1e-12, 50}));
  EXPECT_NEAR(at_15.twist[0], .089604838, 1e-8);
  EXPECT_NEAR(at_15.twist[2], .42749842, 1e-7);
}

// Under a ramp: F = r t leaves at mu F_N / r, and with mu_s = mu_k  m v = r (t - t_b)^2 / 2.
TEST(RigidMotion, ARampStartsThePointMassOfTheTextbook) {
  const RigidMotion motion(HertzDisc::of_radius(0.1), 2, 0.01, Law::coulomb(0.3));
  const RigidMotionResult r = motion(pushed([](double t) { return Vector3(0, 4 * t, 0); }), {}, 0, 2);
  ASSERT_EQ(r.events.size(), 1u);
  EXPECT_NEAR(r.events[0].time, 0.75, 1e-14);
  EXPECT_NEAR(r.events[0].slip.vy, 1, 1e-12);
  EXPECT_NEAR(r.state.twist[1], 4 * 1.25 * 1.25 / 4, 1e-9);
  EXPECT_NEAR(r.state.place[1], 4 * std::pow(1.25, 3) / 12, 1e-9);
}

// Force and moment together: leaves where the gauge is met, about its pole.
TEST(RigidMotion, ARampOfForceAndMomentLeavesAboutThePoleOfTheGauge) {
  const HertzDisc patch = HertzDisc::of_radius(0.1);
  const Vector3 direction(1, 0.5, 0.06);
  const friction::Gauge g = friction::RoundLimitSurface(patch).gauge({1, 0.5, 0.06});
  const RigidMotion motion(patch, 2, 0.01, Law::coulomb(0.3));
  const RigidMotionResult r = motion(pushed([&](double t) { return Vector3(t * t * direction); }), {}, 0, 2);
  ASSERT_EQ(r.events.size(), 1u);
  EXPECT_NEAR(r.events[0].time, std::sqrt(3 / g.value), 1e-12);
  EXPECT_NEAR(r.events[0].slip.vx, g.twist.vx, 1e-9);
  EXPECT_NEAR(r.events[0].slip.w, g.twist.w, 1e-8);
  EXPECT_LE(r.place_error.norm(), 1e-5);
}

TEST(RigidMotion, AnOscillatingLoadSticksAndSlipsInTurn) {
  const RigidMotion motion(HertzDisc::of_radius(0.1), 0.02, 1e-4, Law::coulomb(0.3));
  const auto force = [](double t) { return Vector3(4 * std::sin(2 * std::numbers::pi * t), 0, 0); };
  const RigidMotionResult r = motion(pushed(force), {}, 0, 3);
  ASSERT_EQ(r.events.size(), 12u);
  for (std::size_t i = 0; i < r.events.size(); ++i) {
    EXPECT_EQ(r.events[i].kind, i % 2 == 0 ? Kind::break_away : Kind::stop);
    if (i % 2 == 1) continue;
    const double expected = std::asin(0.75) / (2 * std::numbers::pi) + static_cast<double>(i) / 4;
    EXPECT_NEAR(r.events[i].time, expected, 1e-12);
  }
  // Half a period later the same the other way: back where it was.
  EXPECT_NEAR(r.state.place[0], 0, 1e-9);
  EXPECT_EQ(r.state.place[1], 0);
}

TEST(RigidMotion, WhatIsHeldStaysToTheBit) {
  const RigidMotion motion(friction::Rectangle::of_sides(0.1, 0.02), 1, 0.01, Law::stribeck(0.5, 0.3, 0.1));
  PlanarState from;
  from.place = {0.1, 0.2, 0.3};
  const RigidMotionResult r =
      motion(pushed([](double t) { return Vector3(2 * std::sin(t), 1, 0.02); }), from, 0, 1000, {.longest_step = 0.1});
  EXPECT_TRUE(r.events.empty());
  EXPECT_EQ(r.state.place, from.place);
}

TEST(RigidMotion, BadInputIsRefused) {
  const auto patch = HertzDisc::of_radius(0.1);
  EXPECT_THROW(RigidMotion(patch, 0, 1, Law::coulomb(0.3)), std::invalid_argument);
  const RigidMotion motion(patch, 1, 1, Law::coulomb(0.3));
  const PlanarLoad load = pushed([](double) { return Vector3(Vector3::Zero()); });
  EXPECT_THROW(motion(load, {}, 1, 0), std::invalid_argument);
  EXPECT_THROW(motion(load, {}, 0, 1, {.tolerance = 1}), std::invalid_argument);
  EXPECT_THROW(motion(load, {}, 0, 1, {.longest_step = 0}), std::invalid_argument);
  EXPECT_THROW(motion(load, {}, 0, 1, {.start = 1}), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
