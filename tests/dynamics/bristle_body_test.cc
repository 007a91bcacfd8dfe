// A body on a round patch: known motions, no creep, no energy from nowhere.
#include <patchgrip/dynamics/bristle_body.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <patchgrip/dynamics/rigid_motion.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::dynamics {
namespace {

using testing::cases;
using testing::log_uniform;
using testing::uniform;

constexpr double infinity = std::numeric_limits<double>::infinity();
const auto no_load = [](double) { return Vector3(Vector3::Zero()); };

struct Stop {
  double time, distance, turn;
};

// A puck of radius 0.05 m, 1 kg, J = m R^2 / 2, v = 1 m/s, w = 20 rad/s, mu = 0.5, g = 9.81 m/s^2: where it comes to
// rest, and when, on a rigid patch from the last step that ends half a step or more before.
template <class P>
Stop puck(const P& disc, double k, double h, Method method) {
  const double R = 0.05, L = 0.5 * 9.81;
  const BristleBody body(disc, {1, R * R / 2, {k, k * R * R / 2}});
  const RigidMotion rest(disc, 1, R * R / 2, friction::Law::coulomb(0.5));
  PlanarState s, last;
  s.twist = {1, 0, 20};
  double at = 0;
  for (double t = 0; t < 0.4; t += h) {
    const StepResult r = body.step(s, t, h, method, no_load, [&](double, const Vector3&) { return L; });
    s = r.state;
    if (!r.slips) break;
    const double D = disc.dissipation({s.twist[0], s.twist[1], s.twist[2]});
    if (2 * body.kinetic_energy(s) > h / 2 * L * D) last = s, at = t + h;
  }
  const RigidMotionResult stop =
      rest({[](double) { return Vector3(Vector3::Zero()); }, [](double) { return 9.81; }}, last, at, 1);
  return {stop.events.at(0).time, s.place[0], s.place[2]};
}

TEST(BristleBody, APuckComesToRestWhereItIsKnownTo) {
  const Stop u = puck(friction::UniformDisc::of_radius(0.05), 1e8, 2e-3, Method::sdirk2);
  EXPECT_NEAR(u.time, .27325143366306, 1e-6);
  EXPECT_NEAR(u.distance, .12994846567449, 1e-6);
  EXPECT_NEAR(u.turn, 2.95243022942, 2e-5);
  const Stop h = puck(friction::HertzDisc::of_radius(0.05), 1e8, 2e-3, Method::sdirk2);
  EXPECT_NEAR(h.time, .28808448600715, 1e-6);
  EXPECT_NEAR(h.distance, .12928855096844, 1e-6);
  EXPECT_NEAR(h.turn, 3.27323081330, 2e-5);
}

TEST(BristleBody, ConvergesWithItsOrder) {
  const auto disc = friction::UniformDisc::of_radius(0.05);
  const auto place = [&](Method method, double h) {
    const BristleBody body(disc, {1, 0.00125, {1e4, 12.5}});
    // Sliding for long, the bristles bent.
    PlanarState s;
    s.twist = {1, 0, 20};
    const friction::Wrench g = disc.gradient({1, 0, 20});
    s.anchor = -4.905 * Vector3(g.fx / 1e4, g.fy / 1e4, g.m / 12.5);
    const int steps = static_cast<int>(std::lround(0.1 / h));
    for (int i = 0; i < steps; ++i)
      s = body.step(s, i * h, h, method, no_load, [](double, const Vector3&) { return 4.905; }).state;
    return s.place[0];
  };
  for (const auto& [method, order] : {std::pair{Method::implicit_euler, 1.}, {Method::sdirk2, 2.}}) {
    const double a = place(method, 4e-4), b = place(method, 2e-4), c = place(method, 1e-4);
    EXPECT_NEAR(std::log2(std::fabs((a - b) / (b - c))), order, 0.25);
  }
}

// 95 % of the limit for a thousand steps of any length: the anchor stays to the bit, and the place to 1e-12 m.
TEST(BristleBody, WhatIsHeldDoesNotCreep) {
  const auto disc = friction::HertzDisc::of_radius(0.01);
  const double L = 3, k = 1e5;
  Vector3 f(0.4, 0.3, 0.002);
  f *= 0.95 * L / friction::RoundLimitSurface(disc).gauge({f[0], f[1], f[2]}).value;
  const BristleBody body(disc, {1, 1e-4, {k, k * 1e-4}, 20, 0.002});
  for (const Method method : {Method::implicit_euler, Method::sdirk2}) {
    for (double h = 1e-6; h < 0.2; h *= 10) {
      PlanarState s;
      s.place = f.cwiseQuotient(Vector3(k, k, k * 1e-4));
      const PlanarState start = s;
      s.twist = {1e-9, 0, 0};
      for (int i = 0; i < 1000; ++i) {
        const StepResult r = body.step(
            s, i * h, h, method, [&](double) { return f; }, [&](double, const Vector3&) { return L; });
        ASSERT_FALSE(r.slips);
        s = r.state;
      }
      EXPECT_EQ(s.anchor, start.anchor);
      EXPECT_LE((s.place - start.place).norm(), 1e-10);
    }
  }
}

// The normal force jumps over decades and to zero, from stage to stage.
template <class P>
void expect_energy_from_the_load_alone(const P& patch, int count) {
  std::mt19937_64 engine(1);
  for (const Method method : {Method::implicit_euler, Method::sdirk2}) {
    for (const bool rigid : {false, true}) {
      BristleBodyParameters p{0.3, 2e-5};
      if (!rigid) p = {0.3, 2e-5, {2e4, 3}, 5, 1e-3};
      const BristleBody body(patch, p);
      PlanarState s;
      double scale = 0, balance = 0;
      for (int i = 0; i < cases(count); ++i) {
        const double h = log_uniform(engine, 1e-6, 1e-1);
        const Vector3 f(uniform(engine, -2, 2), uniform(engine, -2, 2), uniform(engine, -.02, .02));
        const auto limit = [&](double, const Vector3&) {
          return uniform(engine, 0, 1) < 0.1 ? 0 : log_uniform(engine, 1e-2, 10);
        };
        const StepResult r = body.step(
            s, 0, h, method, [&](double) { return f; }, limit);
        const double before = body.kinetic_energy(s) + body.stored_energy(s);
        const double after = body.kinetic_energy(r.state) + body.stored_energy(r.state);
        const StepEnergy& e = r.energy;
        scale = std::max({scale, before, after, std::fabs(e.work)});
        balance = std::max(balance, std::fabs(before + e.work - after - e.slip - e.damping - e.numerical));
        ASSERT_GE(e.slip, 0);
        ASSERT_GE(e.damping, 0);
        ASSERT_GE(e.numerical, 0);
        s = r.state;
        if (s.twist.norm() > 10 || s.place.norm() > 1) s = {};
      }
      EXPECT_LE(balance, 1e-11 * scale);
    }
  }
}

TEST(BristleBody, EnergyComesFromTheLoadAlone) {
  expect_energy_from_the_load_alone(friction::HertzDisc::of_radius(0.01), 25000);
  expect_energy_from_the_load_alone(friction::Rectangle::of_sides(0.03, 0.01), 1000);
  expect_energy_from_the_load_alone(friction::Placed(friction::UniformDisc::of_radius(0.01), 0.02, -0.01), 1000);
}

// A rectangle that slides and spins, against the rigid motion: the bristles hold it back by their stretch.
TEST(BristleBody, APatchThatTurnsWithTheBodyStopsWhereTheRigidOneDoes) {
  const auto patch = friction::Rectangle::of_sides(0.1, 0.03);
  PlanarState s;
  s.twist = {0.5, 0.1, 8};
  const RigidMotionResult rigid = RigidMotion(patch, 1, 0.001, friction::Law::coulomb(0.4))(
      {[](double) { return Vector3(Vector3::Zero()); }, [](double) { return 10.; }}, s, 0, 1);
  const BristleBody body(patch, {1, 0.001, {1e8, 1e5}});
  const double h = 5e-4;
  for (double t = 0; t < 0.2; t += h)
    s = body.step(s, t, h, Method::sdirk2, no_load, [](double, const Vector3&) { return 4.; }).state;
  EXPECT_NEAR(s.place[0], rigid.state.place[0], 2e-6);
  EXPECT_NEAR(s.place[1], rigid.state.place[1], 2e-6);
  EXPECT_NEAR(s.place[2], rigid.state.place[2], 1e-4);
}

// The disc of figures 4.30 and 4.31 by return mapping, dampers inside of the limit: another law than the elastoplastic
// one, with the same stiffness and damping.
TEST(BristleBody, TheDiscOfTheFiguresComesToRest) {
  const auto disc = friction::HertzDisc::of_radius(0.2);
  const BristleBody body(disc, {1, 1, {1000, 40}, 20, 0.8});
  const friction::Law law = friction::Law::stribeck(1, 0.5, 0.05);
  const auto limit = [&](double, const Vector3& v) {
    return friction::coefficient(law, disc.moments(), {v[0], v[1], v[2]});
  };
  const auto load = [](double t) { return Vector3(0.49, 0, t > 5 && t < 15 ? 0.1167 : 0); };
  PlanarState s;
  s.place[0] = 0.49 / 1000;
  const double h = 5e-4;
  double stop = 0;
  for (int i = 0; i < 120000; ++i) {
    const StepResult r = body.step(s, i * h, h, Method::sdirk2, load, limit);
    const auto speed = [](const PlanarState& x) { return std::hypot(x.twist[0], x.twist[1], 0.2 * x.twist[2]); };
    const double before = speed(s) - 1e-3, after = speed(r.state) - 1e-3;
    if ((before > 0) != (after > 0)) stop = h * (i + before / (before - after));
    s = r.state;
  }
  EXPECT_NEAR(stop, 44.17093, 1e-5);
  EXPECT_NEAR(s.place[0] - 0.49 / 1000, 3.2469294, 1e-6);
  EXPECT_NEAR(s.place[2], 8.6383397, 2e-6);
}

TEST(BristleBody, BadInputIsRefused) {
  const auto disc = friction::HertzDisc::of_radius(0.01);
  using Parameters = BristleBodyParameters;
  for (const Parameters& p :
       {Parameters{0, 1}, Parameters{1, 0}, Parameters{1, 1, {-1, 1}}, Parameters{1, 1, {1, infinity}},
        Parameters{1, 1, {1, 1}, -1}, Parameters{1, 1, {infinity, infinity}, 1}, Parameters{std::nan(""), 1}}) {
    EXPECT_THROW(BristleBody(disc, p), std::invalid_argument);
  }
  const BristleBody body(disc, {1, 1e-4, {1e4, 1}});
  for (const double h : {0., -1e-3, std::nan("")}) {
    EXPECT_THROW(body.step({}, 0, h, Method::sdirk2, no_load, [](double, const Vector3&) { return 1.; }),
                 std::invalid_argument);
  }
}

// A contact that grows and shrinks with its load, F_N^(1/3), over decades and to nothing: friction never drives.
template <class P>
void never_creates_energy_while_it_grows(const P& patch) {
  std::mt19937_64 engine(7);
  const BristleBody body(patch, {1, 1e-3, {1e5, 50}, 20, 0.01});
  PlanarState s;
  s.twist = {1, -1, 20};
  double t = 0, scale = body.kinetic_energy(s);
  const double start = scale;
  for (int i = 0; i < cases(20000); ++i) {
    const double h = log_uniform(engine, 1e-6, 1e-1);
    const Vector3 f(uniform(engine, -10, 10), uniform(engine, -10, 10), uniform(engine, -0.1, 0.1));
    const auto limit = [&](double, const Vector3&) {
      const double F = uniform(engine, 0, 1) < 0.1 ? 0 : log_uniform(engine, 1e-3, 1e2);
      return Admissible(0.5 * F, std::cbrt(F / 10));
    };
    const StepResult r = body.step(
        s, t, h, i % 2 == 0 ? Method::sdirk2 : Method::implicit_euler, [&](double) { return f; }, limit);
    ASSERT_GE(r.energy.slip, 0) << i;
    ASSERT_GE(r.energy.damping, 0) << i;
    ASSERT_GE(r.energy.numerical, 0) << i;
    s = r.state;
    t += h;
    scale = std::max({scale, std::fabs(s.work), s.dissipated});
    const double balance = start + s.work - s.dissipated - body.kinetic_energy(s) - body.stored_energy(s);
    ASSERT_LE(std::fabs(balance), 1e-9 * scale) << i;
  }
}

TEST(BristleBody, NeverCreatesEnergyWhileItsPatchGrows) {
  never_creates_energy_while_it_grows(friction::HertzDisc::of_radius(0.01));
  never_creates_energy_while_it_grows(friction::HertzEllipse::of_semi_axes(0.01, 0.005));
}

TEST(BristleBody, ASizeIsThatOfThePatch) {
  const BristleBody given(friction::HertzDisc::of_radius(0.01), {1, 1e-3, {1e5, 50}});
  const BristleBody larger(friction::HertzDisc::of_radius(0.02), {1, 1e-3, {1e5, 50}});
  PlanarState s;
  s.twist = {1, -1, 20};
  const auto with = [](double size) { return [size](double, const Vector3&) { return Admissible(5, size); }; };
  const StepResult a = given.step(s, 0, 1e-2, Method::sdirk2, no_load, with(2));
  const StepResult b = larger.step(s, 0, 1e-2, Method::sdirk2, no_load, with(1));
  EXPECT_LE((a.state.twist - b.state.twist).norm(), 1e-13 * s.twist.norm());
  EXPECT_NEAR(a.energy.slip, b.energy.slip, 1e-13);
  EXPECT_THROW(given.step(s, 0, 1e-2, Method::sdirk2, no_load, with(0)), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
