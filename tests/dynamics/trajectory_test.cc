// Motions of a point against the table: bristles, the belt in closed form, Karnopp; events and what is refused.
#include <patchgrip/dynamics/trajectory.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/dynamics/point_bristle.h>
#include <patchgrip/tests/dynamics/dynamics_table.h>

namespace patchgrip::dynamics {
namespace {

using State = Trajectory<3>::State;  // x, v, kappa

// m v' = R of the elastoplastic bristle.
struct Block {
  Law law;
  PointBristle bristle;
  double mass, normal_force;

  void operator()(double, const State& y, State& rates) const {
    const double rate = elastoplastic_rate(bristle, law, normal_force, y[2], y[1]);
    rates = {y[1], bristle_force(bristle, law, normal_force, y[2], rate, y[1]) / mass, rate};
  }
};

Block block_of(const nlohmann::json& p) {
  return {Law::stribeck(number(p["muH"]), number(p["muG"]), number(p["vS"])),
          {number(p["c0"]), number(p["c1"]), 0, number(p["k1f"])},
          number(p["m"]),
          number(p["FN"])};
}

void expect_first_stop(const nlohmann::json& entry, double tolerance) {
  const auto& p = entry["parameters"];
  Trajectory<3> motion(block_of(p), {0, number(p["v0"]), 0}, 0, {.tolerance = 1e-13});
  motion.watch([](double, const State& y) { return y[1]; });
  ASSERT_TRUE(motion.run(number(p["T"]), [](double, const State&, std::size_t) { return true; }));
  EXPECT_NEAR(motion.time(), number(entry["first_v_zero_s"]), tolerance);
  EXPECT_NEAR(motion.state()[0], number(entry["x_at_first_v_zero_m"]), tolerance);
}

void expect_state(const nlohmann::json& p, double t, const nlohmann::json& expected, double tolerance) {
  Trajectory<3> motion(block_of(p), {0, number(p["v0"]), 0}, 0, {.tolerance = 1e-13});
  motion.run(t);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(motion.state()[i], number(expected[i]), tolerance) << i << " at " << t;
}

// x' = 1, y' = 1e-12 e^x: nothing is seen to limit the first step but that it overflows.
TEST(Trajectory, TakesAStepThatOverflowsAgain) {
  Trajectory<2> motion(
      [](double, const auto& y, auto& rates) {
        rates = {1, 1e-12 * std::exp(y[0])};
      },
      {0, 0}, 0, {.tolerance = 1e-12, .first_step = 1e3});
  ASSERT_FALSE(motion.run(30));
  EXPECT_NEAR(motion.state()[0], 30, 1e-12);
  EXPECT_NEAR(motion.state()[1], 1e-12 * std::expm1(30), 1e-9);
}

TEST(Trajectory, TellsTheTimeThatItIsGiven) {
  Trajectory<1> motion([](double t, const auto&, auto& rates) { rates = {t < 2 ? 1 : std::nan("")}; }, {0}, 0);
  motion.tell([](double t, const auto&) { return 1000 + t; });
  try {
    motion.run(4);
    FAIL() << "followed";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("beyond t = 1002 s"), std::string::npos) << error.what();
  }
}

TEST(Trajectory, AnElastoplasticBlockStops) {
  const auto& entry = table()["elastoplastic_scalar"];
  expect_first_stop(entry, 1e-11);
  for (const auto& [t, state] : entry["states_x_v_kappa"].items())
    expect_state(entry["parameters"], std::stod(t), state, 1e-11);
}

TEST(Trajectory, Example47) {
  const auto& entry = table()["misc"]["example_4_7_simulation"];
  expect_first_stop(entry, 1e-9);
  expect_state(entry["parameters"], 1, entry["state_xvk_at_1s"], 1e-9);
  expect_state(entry["parameters"], 8, entry["state_xvk_at_T"], 1e-9);
}

// Stick and slip in turn; the slip is followed, the stick known.
TEST(Trajectory, ABeltDrivesALimitCycle) {
  for (const auto& entry : table()["belt_stick_slip"]["cases"]) {
    const auto& p = entry["parameters"];
    const double m = number(p["m"]), k = number(p["k"]), v0 = number(p["v0"]), Fs = number(p["Fs"]),
                 Fk = number(p["Fk"]);
    using Slip = Trajectory<2>;
    Slip slip(
        [&](double, const Slip::State& y, Slip::State& rates) {
          rates = {y[1], (Fk - k * y[0]) / m};
        },
        {Fs / k, v0}, 0, {.tolerance = 1e-13});
    // The belt is left with its own speed.
    slip.watch([&](double t, const Slip::State& y) { return t == 0 ? -v0 : y[1] - v0; });
    double highest = Fs / k, lowest = Fs / k;
    slip.watch([](double, const Slip::State& y) { return y[1]; });
    ASSERT_TRUE(slip.run(10, [&](double t, const Slip::State& y, std::size_t which) {
      if (which == 1) (y[0] > Fk / k ? highest : lowest) = y[0];
      return which == 0 && t > 1e-3 / std::sqrt(k / m);
    }));
    const double stick = (Fs / k - slip.state()[0]) / v0;
    EXPECT_NEAR(slip.time(), number(entry["slip_s"]), 1e-10);
    EXPECT_NEAR(stick, number(entry["stick_s"]), 1e-9);
    EXPECT_NEAR(slip.time() + stick, number(entry["period_s"]), 1e-9);
    EXPECT_NEAR((highest - lowest) / 2, number(entry["amplitude_m"]), 1e-11);
    EXPECT_NEAR(slip.state()[0], number(entry["x_stick_start_m"]), 1e-11);
  }
}

TEST(Trajectory, KarnoppDriftsInItsDeadBand) {
  const auto& entry = table()["karnopp"];
  const auto& p = entry["parameters"];
  const Law law = Law::stribeck(number(p["muH"]), number(p["muG"]), 1);
  const double m = number(p["m"]), F = number(p["FN"]), dv = number(p["dv"]), load = number(p["FT"]);
  using Point = Trajectory<2>;
  Point motion(
      [&](double, const Point::State& y, Point::State& rates) {
        rates = {y[1], (load + karnopp_force(law, F, dv, load, y[1])) / m};
      },
      {0, number(p["v0"])}, 0, {.tolerance = 1e-13});
  motion.watch([&](double, const Point::State& y) { return y[1] - dv; });
  ASSERT_TRUE(motion.run(10, [](double, const Point::State&, std::size_t) { return true; }));
  EXPECT_NEAR(motion.time(), number(entry["time_at_dead_band_s"]), 1e-9);
  EXPECT_NEAR(motion.state()[0], number(entry["x_at_dead_band_m"]), 1e-9);
  motion.run(10);
  EXPECT_NEAR(motion.state()[1], number(entry["drift_speed_after_m_per_s"]), 1e-9);
  EXPECT_NEAR(motion.state()[0], number(entry["x_at_10_s"]), 1e-8);
}

TEST(Trajectory, EventsComeInOrderAndOnce) {
  Trajectory<2> swing(
      [](double, const auto& y, auto& rates) {
        rates = {y[1], -y[0]};
      },
      {1, 0}, 0, {.tolerance = 1e-13});
  swing.watch([](double, const auto& y) { return y[0]; });
  swing.watch([](double t, const auto&) { return t - 2; });
  std::vector<double> times;
  EXPECT_FALSE(swing.run(10, [&](double t, const auto&, std::size_t) {
    times.push_back(t);
    return false;
  }));
  constexpr double half = std::numbers::pi / 2;
  const std::vector<double> expected{half, 2, 3 * half, 5 * half};
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], expected[i], 1e-11);
  EXPECT_EQ(swing.time(), 10);
  EXPECT_NEAR(swing.state()[0], std::cos(10), 1e-11);
}

TEST(Trajectory, WhatCannotBeFollowedIsSaid) {
  Trajectory<1> burst([](double, const auto& y, auto& rates) { rates = {y[0] * y[0]}; }, {1}, 0);
  try {
    burst.run(2);
    FAIL();
  } catch (const std::exception& error) {
    EXPECT_NE(std::string(error.what()).find("t = "), std::string::npos) << error.what();
    EXPECT_NEAR(burst.time(), 1, 1e-3);
  }
  const auto still = [](double, const auto&, auto& rates) { rates = {0}; };
  EXPECT_THROW(Trajectory<1>(still, {1}, 0, {.tolerance = 0}), std::invalid_argument);
  EXPECT_THROW(Trajectory<1>(still, {1}, 0, {.first_step = -1}), std::invalid_argument);
  Trajectory<1> motion(still, {1}, 0);
  EXPECT_THROW(motion.run(-1), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::dynamics
