// Break-away, slip and stop of a body on a rigid patch, against closed forms and known runs.
#include <patchgrip/dynamics/rigid_motion.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::dynamics {
namespace {

using friction::HertzDisc;
using friction::Law;
using Kind = SlipEvent::Kind;

PlanarLoad pushed(std::function<Vector3(double)> force, double normal_force = 10, std::vector<double> jumps = {}) {
  return {std::move(force), [=](double) { return normal_force; }, std::move(jumps)};
}

PlanarState moving(double vx, double vy, double w) {
  PlanarState s;
  s.twist = {vx, vy, w};
  return s;
}

struct Slide {
  PlanarState state;
  double time, time_error;
  bool stopped;
  friction::Twist last;
};

// Without a load, from a motion at t = 0 to rest.
template <class P>
Slide slide(const P& patch, double mass, double inertia, const Law& law, double normal_force, const PlanarState& from,
            double tolerance = 1e-12, const Vector3& load = Vector3::Zero(), double longest = 100) {
  const RigidMotion motion(patch, mass, inertia, law);
  const RigidMotionResult r = motion(pushed([=](double) { return load; }, normal_force), from, 0, longest, {tolerance});
  if (r.events.empty()) return {r.state, longest, 0, false, {}};
  EXPECT_EQ(r.events[0].kind, Kind::stop);
  return {r.state, r.events[0].time, r.events[0].error, true, r.events[0].slip};
}

// R = 0.05 m, 1 kg, J = m R^2 / 2, mu = 0.5, g = 9.81 m/s^2.
template <class P>
void expect_stop(const P& disc, double time, double distance, double turn) {
  const Slide s = slide(disc, 1, 0.00125, Law::coulomb(0.5), 9.81, moving(1, 0, 20), 1e-13);
  EXPECT_NEAR(s.time, time, 2e-13);
  EXPECT_NEAR(s.state.place[0], distance, 2e-13);
  EXPECT_NEAR(s.state.place[2], turn, 2e-11);
  EXPECT_LE(s.time_error, 1e-10);
  const Slide rough = slide(disc, 1, 0.00125, Law::coulomb(0.5), 9.81, moving(1, 0, 20), 1e-8);
  EXPECT_LE(std::fabs(rough.time - time), rough.time_error);
}

TEST(RigidMotion, APuckComesToRestWhereItIsKnownTo) {
  expect_stop(friction::UniformDisc::of_radius(0.05), .27325143366306, .12994846567449, 2.95243022942);
  expect_stop(HertzDisc::of_radius(0.05), .28808448600715, .12928855096844, 3.27323081330);
}

// tau = mu g t / (a omega_0) at the stop, x0 = v0 / (a omega_0), q = m a^2 / J (reference table).
TEST(RigidMotion, ScaledStopTimes) {
  const auto tau = [](const auto& disc, double q, double x0) {
    return slide(disc, 1, 1 / q, Law::coulomb(1), 1, moving(x0, 0, 1), 1e-13).time;
  };
  EXPECT_NEAR(tau(HertzDisc::of_radius(1), 2.5, 2), 2.203889813833, 2e-12);
  EXPECT_NEAR(tau(friction::UniformDisc::of_radius(1), 2, 0.1), 0.7607786802246, 2e-12);
}

// x = v / (a |w|) tends to the root of f(x) = q x m(x).
TEST(RigidMotion, ThePoleOfTheStopIsThatOfCoastingDown) {
  const auto limit = [](const auto& disc, double q, double x0) {
    const Slide s = slide(disc, 1, 1 / q, Law::coulomb(1), 1, moving(x0, 0, 1));
    return std::hypot(s.last.vx, s.last.vy) / std::fabs(s.last.w);
  };
  for (const double x0 : {0.3, 3.}) {
    EXPECT_NEAR(limit(friction::UniformDisc::of_radius(1), 2, x0), 0.65300178920559763899, 1e-8);
    EXPECT_NEAR(limit(HertzDisc::of_radius(1), 3, x0), 0.7233024093136838630929, 1e-8);
    EXPECT_NEAR(limit(friction::FlatPunchDisc::of_radius(1), 2, x0), 1, 1e-8);
  }
}

TEST(RigidMotion, PureMotionsStopAsCoulombSays) {
  const auto disc = HertzDisc::of_radius(0.1);
  const Slide s = slide(disc, 2, 0.01, Law::coulomb(0.3), 20, moving(3, 4, 0));
  EXPECT_NEAR(s.time, 5 * 2 / 6., 1e-11);
  EXPECT_NEAR(s.state.place[0], 3. / 5 * 25 / 6, 1e-10);
  EXPECT_NEAR(s.state.place[2], 0, 1e-15);
  const Slide spin = slide(disc, 2, 0.01, Law::coulomb(0.3), 20, moving(0, 0, -7));
  EXPECT_NEAR(spin.time, 7 * 0.01 / (6 * 3 * std::numbers::pi / 16 * 0.1), 1e-11);
}

// A patch that turns with its body: from two sides the same, turned.
TEST(RigidMotion, DoesNotDependOnTheAxesOfSpace) {
  const auto patch = friction::Rectangle::of_sides(0.1, 0.03);
  const Slide a = slide(patch, 1, 0.001, Law::coulomb(0.4), 10, moving(0.5, 0, 8));
  PlanarState from = moving(0, 0.5, 8);
  from.place[2] = std::numbers::pi / 2;
  const Slide b = slide(patch, 1, 0.001, Law::coulomb(0.4), 10, from);
  EXPECT_NEAR(a.time, b.time, 1e-10);
  EXPECT_NEAR(a.state.place[0], b.state.place[1], 1e-10);
  EXPECT_NEAR(a.state.place[1], -b.state.place[0], 1e-10);
}

TEST(RigidMotion, StribeckStopsSooner) {
  const auto disc = HertzDisc::of_radius(0.1);
  const Slide coulomb = slide(disc, 1, 0.01, Law::coulomb(0.3), 10, moving(1, 0, 5));
  const Slide stribeck = slide(disc, 1, 0.01, Law::stribeck(0.6, 0.3, 0.1), 10, moving(1, 0, 5));
  EXPECT_TRUE(stribeck.stopped);
  EXPECT_LT(stribeck.time, coulomb.time);
}

TEST(RigidMotion, ALoadThatFrictionCannotStopGoesOn) {
  const Slide s =
      slide(HertzDisc::of_radius(0.1), 1, 0.01, Law::coulomb(0.3), 10, moving(0.1, 0, 0), 1e-12, {4, 0, 0}, 2);
  EXPECT_FALSE(s.stopped);
  EXPECT_NEAR(s.state.twist[0], 2.1, 1e-10);
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

// Pressed by 10 N (1 - t / 2 s), a Hertz disc of 0.1 m whose radius follows as the cube root of the force.
PlanarLoad letting_go(std::function<Vector3(double)> force, std::vector<double> jumps = {}) {
  PlanarLoad load{std::move(force), [](double t) { return 10 * std::max(0., 1 - t / 2); }, std::move(jumps)};
  load.jumps.push_back(2);
  load.size = [](double t) { return std::cbrt(1 - t / 2); };
  return load;
}

constexpr double full_moment = 0.3 * 10 * 3 * std::numbers::pi / 16 * 0.1;  // [N m] at t = 0

// J w' = -M_0 (1 - t / 2)^(4/3), until nothing presses.
TEST(RigidMotion, APatchThatShrinksBrakesLess) {
  const RigidMotion motion(HertzDisc::of_radius(0.1), 2, 0.01, Law::coulomb(0.3));
  const auto spin = [](double t) { return 30 - full_moment / 0.01 * 6 / 7 * (1 - std::pow(1 - t / 2, 7. / 3)); };
  const auto none = [](double) { return Vector3(Vector3::Zero()); };
  for (const double end : {0.5, 1., 2., 3.}) {
    const RigidMotionResult r = motion(letting_go(none), moving(0, 0, 30), 0, end, {.tolerance = 1e-13});
    EXPECT_NEAR(r.state.twist[2], spin(std::min(end, 2.)), 1e-10) << end;
    EXPECT_NEAR(r.state.dissipated, 0.01 / 2 * (900 - std::pow(spin(std::min(end, 2.)), 2)), 1e-10) << end;
  }
}

// A moment passes the limit M_0 (1 - t / 2)^(4/3) as the patch shrinks; another is beyond it from t = 1 s on.
TEST(RigidMotion, APatchThatShrinksLetsAMomentGo) {
  const RigidMotion motion(HertzDisc::of_radius(0.1), 2, 0.01, Law::coulomb(0.3));
  const double moment = 0.4 * full_moment, leaves = 2 * (1 - std::pow(0.4, 0.75));
  const auto left = [](double t) { return std::pow(1 - t / 2, 7. / 3) * 6 / 7; };
  const auto spin = [&](double from) { return (moment * (2 - from) - full_moment * left(from)) / 0.01; };
  const RigidMotionResult steady = motion(letting_go([=](double) { return Vector3(0, 0, moment); }), {}, 0, 2);
  ASSERT_EQ(steady.events.size(), 1u);
  EXPECT_NEAR(steady.events[0].time, leaves, 1e-13);
  EXPECT_NEAR(steady.events[0].slip.w * full_moment * 0.4, 0.3 * 10 * std::pow(0.4, 0.75), 1e-10);  // D = 1 then
  EXPECT_NEAR(steady.state.twist[2], spin(leaves), 1e-5 * spin(leaves));
  const auto late = [=](double t) { return Vector3(0, 0, t >= 1 ? moment : 0); };
  const RigidMotionResult jump = motion(letting_go(late, {1}), {}, 0, 2);
  ASSERT_EQ(jump.events.size(), 1u);
  EXPECT_EQ(jump.events[0].time, 1);
  EXPECT_NEAR(jump.state.twist[2], spin(1), 1e-9 * spin(1));
}

// Nothing acts on it until 1 s, then mu F_N.
TEST(RigidMotion, ABodyThatNothingPressesMovesOn) {
  const RigidMotion motion(HertzDisc::of_radius(0.1), 2, 0.01, Law::coulomb(0.3));
  PlanarLoad load = pushed([](double) { return Vector3(0, 0, 0); }, 0, {1});
  load.normal_force = [](double t) { return t < 1 ? 0 : 20; };
  const RigidMotionResult r = motion(load, moving(3, 0, 0), 0, 3);
  ASSERT_EQ(r.events.size(), 1u);
  EXPECT_NEAR(r.events[0].time, 2, 1e-11);
  EXPECT_NEAR(r.state.place[0], 3 + 1.5, 1e-10);
}

// m v' = f - mu F_N from 1 s on, however little that is, pressed or not: the start is stretched over 28 powers of e.
TEST(RigidMotion, AJumpStartsTheLeastAcceleration) {
  for (const double held : {0., 4.}) {
    for (double a = 1e-9; a < 2; a *= 10) {
      for (const double end : {1.5, 2., 3., 30.}) {
        const RigidMotion motion(friction::UniformDisc::of_radius(0.01), 2, 4e-4, Law::coulomb(0.4));
        const auto force = [=](double t) { return Vector3(0, t < 1 ? 0 : held + 2 * a, 0); };
        const RigidMotionResult r = motion(pushed(force, held / 0.4, {1}), {}, 0, end);
        ASSERT_EQ(r.events.size(), 1u) << a;
        EXPECT_EQ(r.events[0].time, 1);
        const double t = end - 1, off = 1e-9 * a + 0x1p-50 * held;  // what is left of the force has its rounding
        EXPECT_NEAR(r.state.twist[1], a * t, off * t) << held << ", " << a << " to " << end;
        EXPECT_NEAR(r.state.place[1], a * t * t / 2, off * t * t / 2 + 1e-12);
      }
    }
  }
}

// m v' = f - mu F_N (1 - t / 2) from t* = 2 (1 - f / mu F_N) on: a start
// in what is left of the force, from all of it down to what no time can tell from nothing.
TEST(RigidMotion, AForceThatComesToNothingLetsTheLeastLoadGo) {
  const friction::UniformDisc disc = friction::UniformDisc::of_radius(0.01);
  const RigidMotion motion(disc, 1, 4e-4, Law::coulomb(0.4));
  for (const double sign : {1., -1.}) {
    for (double f = 3; f > 1e-18; f /= 3) {
      PlanarLoad load = pushed([=](double) { return Vector3(sign * f, 0, 0); }, 0, {0, 2});
      load.normal_force = [](double t) { return 10 * std::max(0., 1 - t / 2); };
      load.size = [](double t) { return std::cbrt(1 - t / 2); };
      const RigidMotionResult r = motion(load, {}, 0, 3);
      ASSERT_EQ(r.events.size(), 1u) << f;
      const double leaves = 2 * (1 - f / 4), left = 2 - leaves;
      // Later by what is left if a start of 0.5 % of it is no time at all beside 2 s.
      EXPECT_NEAR(r.events[0].time, leaves, left < 200 * 0x1p-52 ? 200 * 0x1p-52 : 1e-14) << f;
      EXPECT_NEAR(r.events[0].slip.vx, sign, 1e-9) << f;
      // v' = f (t - t*) / left up to 2 s, f from there on
      EXPECT_NEAR(sign * r.state.twist[0], f * (left / 2 + 1), 1e-7 * f) << f;
    }
  }
}

// Just after a jump, where a look back would see another load.
TEST(RigidMotion, LeavesJustAfterACorner) {
  const RigidMotion motion(friction::UniformDisc::of_radius(0.01), 1, 4e-4, Law::coulomb(0.4));
  for (double after = 1e-12; after < 1; after *= 10) {
    const auto force = [=](double t) { return Vector3(t < 1 ? -3 : 4 - after + (t - 1), 0, 0); };
    const RigidMotionResult r = motion(pushed(force, 10, {1}), {}, 0, 2.5);
    ASSERT_EQ(r.events.size(), 1u) << after;
    EXPECT_NEAR(r.events[0].time, 1 + after, 1e-14);
    const double t = 1.5 - after;
    EXPECT_NEAR(r.state.twist[0], t * t / 2, 1e-9) << after;
  }
}

// M v' = f t from 1 s on, with nothing to hold it: nothing presses, or nothing rubs. Along M^-1 f, not the gauge's slip.
TEST(RigidMotion, ARampMovesAtOnceWhatNothingHolds) {
  const Vector3 mass(2, 2, 4e-4), f(1, -0.5, 3e-4);
  for (const auto& [law, pressed] : {std::pair{Law::coulomb(0.4), 0.}, {Law::coulomb(0), 10.}}) {
    const RigidMotion motion(friction::UniformDisc::of_radius(0.01), mass[0], mass[2], law);
    for (const double fast : {1e-9, 1., 1e3}) {
      const auto force = [&](double t) { return Vector3(fast * std::max(0., t - 1) * f); };
      const RigidMotionResult r = motion(pushed(force, pressed, {1}), {}, 0, 3);
      ASSERT_EQ(r.events.size(), 1u) << fast;
      EXPECT_EQ(r.events[0].kind, Kind::break_away);
      EXPECT_EQ(r.events[0].time, 1);
      for (Eigen::Index i = 0; i < 3; ++i) {
        EXPECT_NEAR(r.state.twist[i], fast * 2 * f[i] / mass[i], 1e-9 * fast) << fast;
        EXPECT_NEAR(r.state.place[i], fast * 8. / 6 * f[i] / mass[i], 1e-9 * fast) << fast;
      }
      EXPECT_NEAR(r.state.dissipated, 0, 1e-9 * r.state.work);
    }
  }
}

// m v' = t N - mu_V F_N v: v = (t - 1 + exp(-t)) m/s.
TEST(RigidMotion, ViscousFrictionAloneDoesNotHold) {
  const RigidMotion motion(friction::UniformDisc::of_radius(0.01), 1, 5e-5, Law::coulomb(0).with_viscous(0.1));
  for (const double end : {1e-3, 0.1, 2.}) {
    const RigidMotionResult r = motion(pushed([](double t) { return Vector3(0, t, 0); }), {}, 0, end);
    ASSERT_EQ(r.events.size(), 1u);
    EXPECT_EQ(r.events[0].time, 0);
    EXPECT_NEAR(r.state.place[1], end * end / 2 - end - std::expm1(-end), 1e-7) << end;
    EXPECT_LE(std::fabs(r.state.place[1] - (end * end / 2 - end - std::expm1(-end))), r.place_error[1] + 1e-12) << end;
  }
}

// Load and limit both from nothing: m v' = (8 - 4) t N.
TEST(RigidMotion, ALoadThatOutgrowsTheLimitMovesAtOnce) {
  const RigidMotion motion(friction::UniformDisc::of_radius(0.01), 2, 4e-4, Law::coulomb(0.4));
  PlanarLoad load = pushed([](double t) { return Vector3(8 * t, 0, 0); });
  load.normal_force = [](double t) { return 10 * t; };
  const RigidMotionResult r = motion(load, {}, 0, 3);
  ASSERT_EQ(r.events.size(), 1u);
  EXPECT_EQ(r.events[0].time, 0);
  EXPECT_NEAR(r.state.twist[0], 9, 1e-9);
  EXPECT_NEAR(r.state.place[0], 9, 1e-9);
}

// However slowly it passes the limit of 4 N, down to where its last bit counts: m v' = 4 N e t / 10 s.
TEST(RigidMotion, TheSlowestLoadStartsItInTime) {
  const RigidMotion motion(friction::UniformDisc::of_radius(0.05), 1, 1.25e-3, Law::coulomb(0.4));
  for (double e = 10; e > 1e-10; e /= 100) {
    const RigidMotionResult r =
        motion(pushed([=](double t) { return Vector3(4 * (1 + e * t / 10), 0, 0); }), {}, 0, 10);
    ASSERT_EQ(r.events.size(), 1u) << e;
    const double exact = 4 * e * 100 / 6, bit = 4 * 0x1p-53 * 50;
    EXPECT_NEAR(r.state.place[0], exact, 1e-9 * exact + 4 * bit) << e;
  }
}

// Force and moment that pass the limit by the share 0.004 at most, on two patches: along the limit as by slip itself,
// which has to follow from a start of 2e-4 on.
TEST(RigidMotion, ALoadThatHardlyPassesTheLimitIsFollowedAlongIt) {
  const auto expect_alike = [](const auto& patch, const auto& surface) {
    const RigidMotion motion(patch, 1, 1.25e-3, Law::coulomb(0.4));
    const Vector3 direction = Vector3(1, 0.3, 0.02) * 4 / surface.gauge({1, 0.3, 0.02}).value;
    const PlanarLoad load = pushed([&](double t) { return Vector3((1 + 1e-3 * (t - 1)) * direction); });
    const RigidMotionResult along = motion(load, {}, 0, 5), slip = motion(load, {}, 0, 5, {.start = 2e-4});
    ASSERT_EQ(along.events.size(), 1u);
    EXPECT_NEAR(along.events[0].time, 1, 1e-9);
    for (Eigen::Index i = 0; i < 3; ++i)
      EXPECT_NEAR(along.state.place[i], slip.state.place[i], 4e-3 * std::fabs(slip.state.place[i])) << i;
    EXPECT_NEAR(along.state.work, slip.state.work, 4e-3 * slip.state.work);
  };
  const auto disc = friction::UniformDisc::of_radius(0.05);
  expect_alike(disc, friction::RoundLimitSurface(disc));
  const auto rectangle = friction::Rectangle::of_sides(0.1, 0.03);
  expect_alike(rectangle, friction::LimitSurface(rectangle));
}

// From the very limit on, where rounding decides whether it is passed at once.
TEST(RigidMotion, ALoadLeavesFromTheLimitItself) {
  const auto disc = friction::UniformDisc::of_radius(0.05);
  const RigidMotion motion(disc, 1, 1e-3, Law::coulomb(0.4));
  for (int i = 0; i < 6; ++i) {
    const Vector3 direction(1, 0.3 * i - 0.5, 0.003 * i);
    const double g = friction::RoundLimitSurface(disc).gauge({direction[0], direction[1], direction[2]}).value;
    const RigidMotionResult r =
        motion(pushed([&](double t) { return Vector3((1 + 1e-5 * t) * 4 / g * direction); }), {}, 0, 1);
    ASSERT_EQ(r.events.size(), 1u) << i;
    EXPECT_NEAR(r.events[0].time, 0, 1e-8) << i;
    EXPECT_NEAR(r.state.work - r.state.dissipated,
                r.state.twist.dot(Vector3(1, 1, 1e-3).cwiseProduct(r.state.twist)) / 2, 1e-18)
        << i;
    EXPECT_GT(r.state.twist.norm(), 1e-5) << i;
  }
}

// 8 N over 10 s pass the limit of 4 N at 5 s: x = 0.8 (t - 5 s)^3 / 6, from the first sample on.
TEST(RigidMotion, SamplesSeeTheStartItself) {
  const RigidMotion motion(friction::UniformDisc::of_radius(0.05), 1, 1.25e-3, Law::coulomb(0.4));
  const auto force = [](double t) { return Vector3(0.8 * t, 0, 0); };
  const std::vector<double> times{4.99, 5, 5.0001, 5.001, 5.005, 5.01, 5.02, 5.03, 5.1};
  std::vector<double> seen;
  motion(pushed(force), {}, 0, 6, {}, times, [&](double t, const PlanarState& s) {
    seen.push_back(t);
    const double left = std::max(0., t - 5), x = 0.8 * left * left * left / 6, v = 0.4 * left * left;
    EXPECT_NEAR(s.place[0], x, 1e-9 * x + 1e-15 * left) << t;
    EXPECT_NEAR(s.twist[0], v, 1e-9 * v + 1e-15) << t;
    EXPECT_NEAR(s.work, 4 * x + 0.8 * left * v * left / 4, 1e-9 * s.work) << t;  // int 0.8 t v dt
    EXPECT_NEAR(s.work - s.dissipated, v * v / 2, 1e-14) << t;
  });
  EXPECT_EQ(seen, times);
}

TEST(RigidMotion, RefusesAPatchWithoutSize) {
  const RigidMotion motion(HertzDisc::of_radius(0.1), 2, 0.01, Law::coulomb(0.3));
  PlanarLoad load = pushed([](double) { return Vector3(1, 0, 0); });
  load.size = [](double) { return 0; };
  EXPECT_THROW(motion(load, {}, 0, 1), std::invalid_argument);
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

// Also at the start, at a jump, at the stop, and at the end of a motion that goes on; energies there.
TEST(RigidMotion, EverySampleIsMetOnce) {
  const RigidMotion motion(HertzDisc::of_radius(0.2), 1, 1, Law::stribeck(1, 0.5, 0.05));
  const auto force = [](double t) { return Vector3(0.49, 0, t >= 5 && t < 15 ? .11924 : 0); };
  for (const double end : {10., 15., 100.}) {
    const std::vector<double> times{0, 2, 5, 6, 10, 15, 15.5, 44.0032889204, 100};
    std::vector<double> due, seen;
    for (const double t : times) {
      if (t <= end) due.push_back(t);
    }
    motion(pushed(force, 1, {5, 15}), {}, 0, end, {}, due, [&](double t, const PlanarState& s) {
      seen.push_back(t);
      const double kinetic = s.twist.squaredNorm() / 2;
      EXPECT_NEAR(kinetic, s.work - s.dissipated, 1e-11) << t;
      EXPECT_NEAR(s.work, 0.49 * s.place[0] + .11924 * s.place[2], t <= 15 ? 1e-10 : 1) << t;
    });
    EXPECT_EQ(seen, due);
  }
}

TEST(RigidMotion, ASampleAtTheStartSeesTheStart) {
  const RigidMotion motion(HertzDisc::of_radius(0.05), 1, 0.00125, Law::coulomb(0.5));
  std::vector<double> speeds;
  motion(pushed([](double) { return Vector3(Vector3::Zero()); }), moving(1, 0, 20), 0, 0.1, {}, {0, 0.05, 0.1},
         [&](double, const PlanarState& s) { speeds.push_back(s.twist[0]); });
  ASSERT_EQ(speeds.size(), 3u);
  EXPECT_EQ(speeds[0], 1);
  EXPECT_GT(speeds[1], speeds[2]);
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
  PlanarState lost;
  lost.place[1] = std::nan("");
  EXPECT_THROW(motion(load, lost, 0, 1), std::invalid_argument);
  EXPECT_THROW(motion(load, {}, 0, 1, {}, {0.5, 0.4}), std::invalid_argument);
  const auto none = [](double) { return Vector3(Vector3::Zero()); };
  EXPECT_THROW(motion(pushed(none, 10, {0.5, 0.4}), {}, 0, 1), std::invalid_argument);
  EXPECT_THROW(motion(pushed(none, -10), {}, 0, 1), std::invalid_argument);
  const auto broken = [](double t) { return Vector3(t > 0.5 ? std::nan("") : 0, 0, 0); };
  EXPECT_THROW(motion(pushed(broken), {}, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
