// Two stacked bodies: momentum, energy, stick without creep, and slides that are known.
#include <patchgrip/dynamics/stacked_bodies.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::dynamics {
namespace {

using friction::HertzDisc;
using friction::Rectangle;
using friction::UniformDisc;
using testing::cases;
using testing::log_uniform;
using testing::uniform;

constexpr double m1 = 2, m2 = 1, J1 = 0.01, J2 = 0.002, g = 9.81;

BristleBodyParameters body(double mass, double inertia, double k, double d = 0) {
  return {mass, inertia, {k, k * 1e-3}, d, d * 1e-3};
}

const auto no_load = [](double) { return Vector6(Vector6::Zero()); };
const auto limits = [](double mu_a, double mu_b) {
  return [=](int which, double, const Vector3&) { return which == 0 ? mu_a * (m1 + m2) * g : mu_b * m2 * g; };
};

// The upper body slides along the lower one, which slides, too: constant decelerations until both move alike, then
// together to rest.
TEST(StackedBodies, SlideAsTheTextbookSays) {
  const double mu_a = 0.1, mu_b = 0.5, v0 = 3;
  const StackedBodies stack(HertzDisc::of_radius(0.05), UniformDisc::of_radius(0.03), body(m1, J1, 1e8, 100),
                            body(m2, J2, 1e8, 100));
  StackState s;
  s.twist[3] = v0;
  const double h = 1e-3;
  // Body 1: (mu_b m2 - mu_a (m1 + m2)) g / m1 forwards; body 2: mu_b g backwards.
  const double a1 = (mu_b * m2 - mu_a * (m1 + m2)) * g / m1, a2 = mu_b * g, meet = v0 / (a1 + a2), v = a1 * meet;
  const double x1 = a1 * meet * meet / 2 + v * v / (2 * mu_a * g);
  const double x2 = v0 * meet - a2 * meet * meet / 2 + v * v / (2 * mu_a * g);
  bool together = false;
  for (int i = 0; i < 1500; ++i) {
    const double t = i * h;
    const auto r = stack.step(s, t, h, Method::sdirk2, no_load, limits(mu_a, mu_b));
    s = r.state;
    if (t > meet + 0.01) together = together || (!r.slips[1] && r.slips[0]);
  }
  EXPECT_TRUE(together);
  EXPECT_NEAR(s.place[0], x1, 1e-5);
  EXPECT_NEAR(s.place[3], x2, 1e-5);
  EXPECT_NEAR(s.twist.norm(), 0, 1e-6);
}

// What leaves one body enters the other: without friction of the ground momentum stays to rounding, angular momentum
// with the square of the step.
TEST(StackedBodies, ActionIsReaction) {
  const StackedBodies stack(HertzDisc::of_radius(0.05), Rectangle::of_sides(0.05, 0.02), body(m1, J1, 1e5, 10),
                            body(m2, J2, 1e5, 10));
  const auto run = [&](double h) {
    StackState s;
    s.place << 0, 0, 0.3, 0.02, -0.01, 0.1;
    s.twist << 0.1, -0.2, 5, 1, 0.5, -10;
    const auto momentum = [&](const StackState& x) {
      return Vector3(m1 * x.twist[0] + m2 * x.twist[3], m1 * x.twist[1] + m2 * x.twist[4],
                     J1 * x.twist[2] + J2 * x.twist[5] + m1 * (x.place[0] * x.twist[1] - x.place[1] * x.twist[0]) +
                         m2 * (x.place[3] * x.twist[4] - x.place[4] * x.twist[3]));
    };
    const Vector3 before = momentum(s);
    for (int i = 0; i < std::lround(0.2 / h); ++i)
      s = stack.step(s, i * h, h, Method::sdirk2, no_load, limits(0, 0.4)).state;
    return Vector3((momentum(s) - before).cwiseAbs());
  };
  const Vector3 coarse = run(2e-3), fine = run(5e-4);
  EXPECT_LE(std::max({coarse[0], coarse[1], fine[0], fine[1]}), 1e-13);
  EXPECT_LE(coarse[2], 1e-3);
  EXPECT_LE(fine[2], coarse[2] / 8);
}

// Limits that jump over decades and to 0, any step, any load: friction never drives, energy balances.
TEST(StackedBodies, NeverCreateEnergy) {
  std::mt19937_64 engine(1);
  const StackedBodies stack(HertzDisc::of_radius(0.05), Rectangle::of_sides(0.05, 0.02), body(m1, J1, 1e5, 10),
                            body(m2, J2, 1e4, 1));
  StackState s;
  s.twist << 1, 0, 20, -1, 2, 5;
  double t = 0, scale = stack.kinetic_energy(s);
  const double start = scale;
  for (int i = 0; i < cases(4000); ++i) {
    const double h = log_uniform(engine, 1e-5, 1e-2);
    Vector6 f;
    for (double& x : f) x = uniform(engine, -20, 20);
    f[2] *= 0.05, f[5] *= 0.05;
    std::array<double, 2> L;
    for (double& x : L) x = uniform(engine, 0, 1) < 0.1 ? 0 : log_uniform(engine, 0.05, 50);
    const auto r = stack.step(
        s, t, h, i % 2 == 0 ? Method::sdirk2 : Method::implicit_euler, [&](double) { return f; },
        [&](int which, double, const Vector3&) { return L[static_cast<std::size_t>(which)]; });
    ASSERT_GE(r.energy.slip, -1e-14 * scale) << i;
    ASSERT_GE(r.energy.damping, 0);
    ASSERT_GE(r.energy.numerical, 0);
    s = r.state;
    t += h;
    scale = std::max({scale, std::fabs(s.work), s.dissipated});
    const double balance = start + s.work - s.dissipated - stack.kinetic_energy(s) - stack.stored_energy(s);
    ASSERT_LE(std::fabs(balance), 1e-9 * scale) << i;
  }
}

// Held at 95 % of both limits: the anchors stay to the bit, and nothing moves off.
TEST(StackedBodies, WhatIsHeldDoesNotCreep) {
  const StackedBodies stack(HertzDisc::of_radius(0.05), UniformDisc::of_radius(0.03), body(m1, J1, 1e5, 10),
                            body(m2, J2, 1e5, 10));
  const double mu_a = 0.3, mu_b = 0.5, on_2 = 0.95 * mu_b * m2 * g, on_1 = 0.95 * mu_a * (m1 + m2) * g - on_2;
  const auto load = [&](double) {
    Vector6 f = Vector6::Zero();
    f[0] = on_1, f[3] = on_2;
    return f;
  };
  for (const double h : {1e-5, 1e-3, 1e-1}) {
    StackState s;
    s.anchor[0] = -(on_1 + on_2) / 1e5;
    s.anchor[3] = -on_2 / 1e5;
    const Vector6 anchor = s.anchor;
    for (int i = 0; i < 2000; ++i) {
      const auto r = stack.step(s, i * h, h, Method::sdirk2, load, limits(mu_a, mu_b));
      ASSERT_FALSE(r.slips[0] || r.slips[1]);
      s = r.state;
    }
    EXPECT_EQ(s.anchor, anchor) << h;
    EXPECT_LE(s.place.norm(), 1e-17) << h;
  }
}

// A heavy upper body needs more sweeps, and settles.
TEST(StackedBodies, SettleAlsoWithAHeavyUpperBody) {
  int most = 0;
  for (const double ratio : {0.1, 10., 100.}) {
    const StackedBodies stack(HertzDisc::of_radius(0.05), UniformDisc::of_radius(0.03), body(1, 1e-3, 1e9),
                              body(ratio, ratio * 1e-3, 1e9));
    StackState s;
    s.twist << 0, 0, 0, 1, 0, 20;
    const auto r = stack.step(s, 0, 1e-2, Method::sdirk2, no_load,
                              [&](int which, double, const Vector3&) { return (which == 0 ? 0.2 : 0.5) * ratio * g; });
    EXPECT_TRUE(r.state.twist.allFinite());
    EXPECT_GE(r.sweeps, most);
    most = r.sweeps;
  }
}

TEST(StackedBodies, BadInputIsRefused) {
  const auto make = [](const BristleBodyParameters& p) {
    return StackedBodies(HertzDisc::of_radius(0.05), UniformDisc::of_radius(0.03), p, body(1, 1, 1e5));
  };
  EXPECT_THROW(make(body(0, 1, 1e5)), std::invalid_argument);
  EXPECT_THROW(make(body(1, 1, INFINITY)), std::invalid_argument);
  EXPECT_THROW(make(body(1, 1, 1e5)).step({}, 0, 0, Method::sdirk2, no_load, limits(1, 1)), std::invalid_argument);
  const auto no_number = [](int, double, const Vector3&) { return NAN; };
  EXPECT_THROW(make(body(1, 1, 1e5)).step({}, 0, 1e-3, Method::sdirk2, no_load, no_number), std::runtime_error);
}

}  // namespace
}  // namespace patchgrip::dynamics
