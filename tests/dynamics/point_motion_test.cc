// A point mass on a support: the belt in closed form, energies, events, what is refused.
#include <patchgrip/dynamics/point_motion.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace patchgrip::dynamics {
namespace {

using Kind = PointEvent::Kind;

PointLoad pulled(std::function<double(double)> force, double normal_force = 1, std::vector<double> jumps = {}) {
  return {std::move(force), [=](double) { return normal_force; }, std::move(jumps)};
}
const auto no_force = [](double) { return 0.; };

// With om = sqrt(k / m) and d = (F_s - F_k) / k: stick 2 d / v_0, slip (pi + 2 phi) / om, phi = atan2(v_0, om d),
// amplitude |(d, v_0 / om)| about F_k / k.
TEST(PointMotion, ABeltDrivesALimitCycle) {
  for (const double v0 : {0.05, -0.05, 0.4, 20.}) {
    const double m = 2, k = 800, Fs = 12, Fk = 7, om = std::sqrt(k / m), d = (Fs - Fk) / k, speed = std::fabs(v0);
    const double slip = (std::numbers::pi + 2 * std::atan2(speed, om * d)) / om, stick = 2 * d / speed;
    const PointMotion motion({m, k, 0, v0}, Law::coulomb(Fk), Fs);
    const auto r = motion(pulled(no_force), {0, v0}, 0, Fs / (k * speed) + 2 * (slip + stick), {1e-15, 1e-2});
    std::vector<PointEvent> events;
    std::vector<double> extremes;
    for (const PointEvent& e : r.events) {
      if (e.kind == Kind::extreme) {
        extremes.push_back(e.state.x);
      } else {
        events.push_back(e);
      }
    }
    ASSERT_GE(events.size(), 4u);
    EXPECT_EQ(events[0].kind, Kind::break_away);
    EXPECT_EQ(events[1].kind, Kind::stop);
    EXPECT_NEAR(events[0].time, Fs / (k * speed), 1e-14);
    EXPECT_NEAR(events[1].time - events[0].time, slip, 1e-12);
    EXPECT_NEAR(events[2].time - events[0].time, slip + stick, 1e-12);
    EXPECT_NEAR(std::fabs(extremes.at(0) - extremes.at(1)) / 2, std::hypot(d, speed / om), 1e-14);
    EXPECT_LE(events[1].error, 1e-10);
    // What the belt gives is what friction takes, over a cycle.
    const PointState &a = events[0].state, &b = events[2].state;
    const double work = Fk * (speed * slip + 2 * d);
    EXPECT_NEAR(b.support_work - a.support_work, work, 1e-11 * work);
    EXPECT_NEAR(b.friction_loss - a.friction_loss, work, 1e-11 * work);
  }
}

// F = r t leaves at mu F_N / r; with mu_s = mu_k then m v = r tau^2 / 2, to the left as to the right.
TEST(PointMotion, ARampStartsIt) {
  for (const double r : {4., -4.}) {
    const PointMotion motion({2}, Law::coulomb(0.3));
    const auto found = motion(pulled([=](double t) { return r * t; }, 10), {}, 0, 2, {.tolerance = 1e-14});
    ASSERT_EQ(found.events.size(), 1u);
    EXPECT_NEAR(found.events[0].time, 0.75, 1e-14);
    EXPECT_NEAR(found.state.v, r * 1.25 * 1.25 / 4, 1e-12);
    EXPECT_NEAR(found.state.x, r * std::pow(1.25, 3) / 12, 1e-12);
  }
}

TEST(PointMotion, StopsAsCoulombSays) {
  const PointMotion motion({2}, Law::coulomb(0.3));
  const auto r = motion(pulled(no_force, 20), {0, 5}, 0, 10, {.tolerance = 1e-14});
  ASSERT_EQ(r.events.size(), 1u);
  EXPECT_EQ(r.events[0].kind, Kind::stop);
  EXPECT_NEAR(r.events[0].time, 5 * 2 / 6., 1e-13);
  EXPECT_NEAR(r.state.x, 25 / 6., 1e-12);
  EXPECT_NEAR(r.state.friction_loss, 25, 1e-11);
  EXPECT_TRUE(r.sticks);
}

TEST(PointMotion, EnergyBalances) {
  const double m = 0.3, k = 50, c = 0.4, v0 = 0.2;
  const PointMotion motion({m, k, c, v0}, Law::stribeck(0.8, 0.4, 0.1).with_viscous(0.05));
  const PointLoad load = pulled([](double t) { return 3 * std::sin(5 * t); }, 4);
  double scale = 0, off = 0;
  std::vector<double> times;
  for (int i = 0; i <= 200; ++i) times.push_back(0.05 * i);
  const PointState from{0.01, 0.5};
  const double before = m * 0.25 / 2 + k * 1e-4 / 2;
  motion(load, from, 0, 10, {.tolerance = 1e-13}, times, [&](double, const PointState& s, double) {
    const double energy = m * s.v * s.v / 2 + k * s.x * s.x / 2;
    scale = std::max({scale, energy, std::fabs(s.support_work), s.friction_loss});
    off = std::max(off, std::fabs(energy - before - s.load_work - s.support_work + s.friction_loss + s.damper_loss));
    EXPECT_GE(s.friction_loss, 0);
  });
  EXPECT_GT(scale, 0.1);
  EXPECT_LE(off, 1e-11 * scale);
}

// At the limit it holds; where the load reverses while it slides it may turn without a stop.
TEST(PointMotion, HoldsAtTheLimitAndTurnsBeyondIt) {
  const PointMotion motion({1}, Law::coulomb(0.5));
  EXPECT_TRUE(motion(pulled([](double) { return 1.; }, 2), {}, 0, 100).events.empty());
  const auto r =
      motion(pulled([](double t) { return t < 1 ? 3. : -3.; }, 2, {1, 7, 9}), {}, 0, 4, {.tolerance = 1e-13});
  ASSERT_EQ(r.events.size(), 2u);
  EXPECT_EQ(r.events[0].kind, Kind::break_away);
  EXPECT_EQ(r.events[1].kind, Kind::turn);
  EXPECT_NEAR(r.events[1].time, 1.5, 1e-12);
}

TEST(PointMotion, BadInputIsRefused) {
  const Law law = Law::coulomb(0.5);
  for (const PointBody& b : {PointBody{0}, PointBody{1, -1}, PointBody{1, 0, -1}, PointBody{1, 0, 0, std::nan("")}})
    EXPECT_THROW(PointMotion(b, law), std::invalid_argument);
  EXPECT_THROW(PointMotion({1}, law, 0.4), std::invalid_argument);
  const PointMotion motion({1}, law);
  EXPECT_THROW(motion(pulled(no_force), {}, 1, 0), std::invalid_argument);
  EXPECT_THROW(motion(pulled(no_force), {std::nan("")}, 0, 1), std::invalid_argument);
  EXPECT_THROW(motion(pulled(no_force), {}, 0, 1, {.tolerance = 1}), std::invalid_argument);
  EXPECT_THROW(motion(pulled(no_force), {}, 0, 1, {.longest_step = 0}), std::invalid_argument);
  EXPECT_THROW(motion(pulled(no_force, -1), {}, 0, 1), std::invalid_argument);
  EXPECT_THROW(motion(pulled(no_force, 1, {0.5, 0.4}), {}, 0, 1), std::invalid_argument);
  EXPECT_THROW(motion(pulled([](double) { return std::nan(""); }), {}, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
