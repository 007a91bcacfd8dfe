// What `patchgrip simulate` answers: known stops, no creep, energies, and the scenes that come along.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/cli/unanswered.h>
#include <patchgrip/contact/hertz_circle.h>

#include "simulate_scenes.h"

namespace patchgrip::cli {
namespace {

using test::good_point;
using test::good_puck;
using test::with;

class Simulate : public test::SimulateTest {};

std::string scene_text(const std::string& name) {
  std::ifstream in(test::simulate_folder / (name + ".toml"));
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(Simulate, PucksStopWhereTheyAreKnownTo) {
  const Answer hertz = committed("puck_hertz");
  EXPECT_NEAR(hertz.value("stop_time"), .28808448600715, 2e-13);
  EXPECT_NEAR(hertz.value("stop_distance"), .12928855096844, 2e-13);
  EXPECT_NEAR(hertz.value("stop_turn"), 3.27323081330, 2e-11);
  EXPECT_LE(hertz.error("stop_time"), 1e-10);
  const Answer uniform = committed("puck_uniform");
  EXPECT_NEAR(uniform.value("stop_time"), .27325143366306, 2e-13);
  EXPECT_NEAR(uniform.value("stop_distance"), .12994846567449, 2e-13);
}

TEST_F(Simulate, BristlesStopThePuckInsideOfTheirError) {
  const Answer a = committed("puck_bristles");
  const double off = std::fabs(a.value("stop_time") - .28808448600715);
  EXPECT_LE(off, 1e-6);
  EXPECT_LE(off, a.error("stop_time"));
  EXPECT_NEAR(a.value("stop_distance"), .12928855096844, 1e-6);
}

TEST_F(Simulate, EveryLawStopsTheDiscOfFigure430WhenItIsKnownTo) {
  EXPECT_NEAR(committed("figure_4_30").value("stop_time"), 43.93610596445, 1e-7);
  EXPECT_NEAR(committed("figure_4_30_return_mapping").value("stop_time"), 44.17093, 1e-5);
  const Answer rigid = committed("figure_4_30_rigid");
  EXPECT_NEAR(rigid.value("stop_time"), 24.835538557, 2e-9);
  EXPECT_NEAR(rigid.value("break_away"), 5, 1e-14);
}

// Its zone slips where g(s*) passes the limit, as in return mapping, whose foot has no lever; rigid is where both tend.
TEST_F(Simulate, HalfADegreeOfFreedomStopsTheDiscNearReturnMapping) {
  const Answer half = committed("figure_4_30_half_freedom"), mapped = committed("figure_4_30_return_mapping");
  EXPECT_NEAR(half.value("break_away"), 5.2094, 1e-3);
  EXPECT_NEAR(half.value("stop_time"), mapped.value("stop_time"), 0.1);
  EXPECT_LE(half.value("drift_in_stick"), 1e-13);
  const auto scene = [](double k, double d) {
    return with(good_puck, "method = \"rigid\"",
                "method = \"half_freedom\"\nrest_speed = 1e-4\nstiffness = " + std::to_string(k) +
                    "\nturn_stiffness = " + std::to_string(k * 1.25e-3) + "\ndamping = " + std::to_string(d) +
                    "\nturn_damping = " + std::to_string(d * 1.25e-3));
  };
  const Answer puck = answer_to(scene(1e6, 1e3));
  EXPECT_NEAR(puck.table["x_m"].back(), .12928855096844, 1e-5);
  EXPECT_NEAR(puck.table["turn_rad"].back(), 3.27323081330, 1e-3);
}

// What the linearised law leaves out is small where friction hardly changes with the speed of the zone.
TEST_F(Simulate, LinearisedHalfFreedomStopsNearTheExactOne) {
  const Answer exact = committed("block_half_freedom"), linear = committed("block_half_freedom_linearised");
  EXPECT_NEAR(linear.value("stop_time"), exact.value("stop_time"), 1e-3);
  EXPECT_NEAR(linear.value("stop_distance"), exact.value("stop_distance"), 1e-5);
  EXPECT_GT(std::fabs(linear.value("stop_time") - exact.value("stop_time")), 10 * exact.error("stop_time"));
  EXPECT_LE(linear.value("drift_in_stick"), 1e-13);
}

// A zone with a mass and smoothed friction tends to one without, which tends to the rigid block.
TEST_F(Simulate, ABoundaryLayerTendsToHalfADegreeOfFreedom) {
  const Answer half = committed("block_half_freedom"), layer = committed("block_boundary_layer");
  const Answer lighter = answer_to(with(
      with(scene_text("block_boundary_layer"), "zone_mass = 0.01 ", "zone_mass = 0.001 "), "to = 1.5", "to = 1.2"));
  const double far = std::fabs(layer.value("stop_distance") - half.value("stop_distance"));
  const double near = std::fabs(lighter.value("stop_distance") - half.value("stop_distance"));
  // Its mass is a hundredth of the block's, and so is what it adds to the way.
  EXPECT_NEAR(far, 0.01 * half.value("stop_distance"), 1e-3);
  EXPECT_LE(near, far / 4);
}

TEST_F(Simulate, Example47StopsWhenItIsKnownTo) {
  const Answer a = committed("example_4_7");
  EXPECT_NEAR(a.value("stop_time"), 1.1842052756356714, 1e-9);
  EXPECT_NEAR(a.value("stop_distance"), 2.3544450410035065, 2e-9);
}

// Steps that time cannot resolve are refused, not taken for ever.
TEST_F(Simulate, RefusesAPointThatOscillatesTooFast) {
  const std::string stiff = with(good_point, "mass = 2", "mass = 2\nspring = 1e40");
  EXPECT_THROW(answer_to(with(stiff, "[motion]", "[motion]\nmethod = \"tanh\"\nsteepness = 100")), SceneError);
}

TEST_F(Simulate, WhatIsHeldDoesNotCreep) {
  for (const char* scene : {"held_load", "oscillation"}) {
    const Answer a = committed(scene);
    EXPECT_EQ(a.value("drift_in_stick"), 0) << scene;
    EXPECT_TRUE(a.json["events"].empty()) << scene;
    EXPECT_FALSE(a.json["summary"].contains("stop_time")) << scene;
    const auto share = a.table["share_of_limit"];
    EXPECT_NEAR(*std::ranges::max_element(share), std::string(scene) == "held_load" ? 0.95 : 0.9, 1e-3);
  }
  EXPECT_GT(committed("oscillation_lugre").value("drift_in_stick"), 0.05);
}

// Period of a belt with Stribeck friction: the same from cycle to cycle, and energy balances.
TEST_F(Simulate, ABeltSticksAndSlips) {
  const Answer a = committed("belt");
  std::vector<double> leaves;
  for (const auto& e : a.json["events"]) {
    if (e["event"] == "break_away") leaves.push_back(e["time"]["value"]);
  }
  ASSERT_GE(leaves.size(), 5u);
  EXPECT_NEAR(leaves[0], 12 / 800. / 0.05, 0.01);
  for (std::size_t i = 2; i < leaves.size(); ++i) EXPECT_NEAR(leaves[i] - leaves[i - 1], leaves[1] - leaves[0], 1e-9);
  EXPECT_LE(a.json["summary"]["energy_balance_error"]["value"].get<double>(), 1e-9);
}

TEST_F(Simulate, EnergyBalancesInEveryScene) {
  for (const std::string& scene : test::scenes_in(test::simulate_folder)) {
    const Answer a = committed(scene);
    EXPECT_LE(a.json["summary"]["energy_balance_error"]["value"].get<double>(), 1e-9) << scene;
    EXPECT_TRUE(a.json["warnings"].empty()) << scene;
    if (scene == "figure_4_15_karnopp") continue;  // holds with -F_T while it still moves: it can push
    const auto lost = a.table["dissipated_J"];
    EXPECT_TRUE(std::ranges::is_sorted(lost, [](double x, double y) { return x < y - 1e-12; })) << scene;
  }
}

TEST_F(Simulate, APointStopsAndStartsByCoulomb) {
  const Answer a = answer_to(with(good_point, "ramp = [0, 1]", "during = [4, 5]"));
  EXPECT_NEAR(a.value("stop_time"), 1.2, 1e-12);  // 3 m/s against 5 N / 2 kg
  EXPECT_NEAR(a.value("stop_distance"), 1.8, 1e-12);
  EXPECT_EQ(a.table["friction_N"], (std::vector<double>{-5, -5, 0}));
  EXPECT_EQ(a.table["slips"], (std::vector<double>{1, 1, 0}));
}

// m v' = F - mu F_N over the ramp F = 10 t N of 1 s, then 10 N.
TEST_F(Simulate, ARampBreaksAwayWhereTheTextbookSays) {
  std::string text = with(good_point, "velocity = [3, 0]\n", "");
  text = with(text, "force = [1, 0]", "force = [10, 0]");
  const Answer a = answer_to(text);
  EXPECT_NEAR(a.value("break_away"), 0.5, 1e-13);
  EXPECT_NEAR(a.table["v_m_per_s"][1], 10 * 0.25 / 2 / 2, 1e-10);
  EXPECT_NEAR(a.table["v_m_per_s"][2], 0.625 + 2.5, 1e-10);
}

// Pressed less and less, 10 N (1 - t / 2): what is pulled by 2 N breaks away at mu F_N = 2 N. Then
// m v' = 2 - 5 (1 - t / 2).
TEST_F(Simulate, ANormalForceThatFallsLetsGo) {
  std::string text =
      with(with(good_point, "velocity = [3, 0]\n", ""), "force = [1, 0]\nramp = [0, 1]", "force = [2, 0]");
  text += "[normal_force]\ncourse = [[0, 1], [2, 0]]\n";
  const Answer point = answer_to(text);
  EXPECT_NEAR(point.value("break_away"), 1.2, 1e-12);
  EXPECT_NEAR(point.table["v_m_per_s"].back(), 2.5 / 2 * 0.8 * 0.8 / 2, 1e-10);
  text = with(with(text, "patch = \"point\"", "patch = \"uniform_disc\"\nradius = 0.01"), "mass = 2",
              "mass = 2\ninertia = 1");
  const Answer disc = answer_to(text);
  EXPECT_NEAR(disc.value("break_away"), 1.2, 1e-9);
  EXPECT_NEAR(disc.table["vx_m_per_s"].back(), 0.4, 1e-6);
  const Answer mapped = answer_to(
      with(with(text, "inertia = 1", "inertia = 1\nsettled = true"),
           "times =", "method = \"return_mapping\"\nstep = 1e-4\nstiffness = 1e7\nturn_stiffness = 1e3\ntimes ="));
  EXPECT_NEAR(mapped.value("break_away"), 1.2, 2e-4);
  EXPECT_NEAR(mapped.table["vx_m_per_s"].back(), 0.4, 1e-4);
}

// The same scene by another method, without bristles.
std::string rigid(std::string text) {
  text = with(text, "method = \"return_mapping\"", "method = \"rigid\"");
  for (const char* key : {"\nstep =", "\nstiffness =", "\nturn_stiffness ="}) {
    const auto from = text.find(key);
    if (from != std::string::npos) text.erase(from, text.find('\n', from + 1) - from);
  }
  return text;
}

// By every law of a point: nothing rubs while nothing presses, what the bristles held is lost, and then it rubs again.
TEST_F(Simulate, APointThatNothingPressesCoasts) {
  const std::string block =
      "[contact]\npatch = \"point\"\nnormal_force = 10\n[friction]\nmu_static = 1\nmu_kinetic = 0.4\n"
      "stribeck_velocity = 0.1\n[body]\nmass = 1\nvelocity = [4, 0]\n[motion]\ntimes = { from = 0, to = 3, count = 61 "
      "}\n"
      "stiffness = 5000\ndamping = 10\nmethod = ";
  const auto without_bristles = [&](const std::string& method) {
    return with(block, "stiffness = 5000\ndamping = 10\nmethod = ", method);
  };
  for (const std::string& scene :
       {block + "\"elastoplastic\"\n", block + "\"elastoplastic\"\nnu0 = 1.5\n", block + "\"lugre\"\n",
        block + "\"dahl\"\n", block + "\"boundary_layer\"\nzone_mass = 1e-3\nsteepness = 100\n",
        without_bristles("method = \"rigid\"\n"), without_bristles("method = \"tanh\"\nsteepness = 100\n"),
        without_bristles("method = \"karnopp\"\ndead_band = 1e-3\n")}) {
    for (const char* course : {"during = [0, 0.5]", "course = [[0, 1], [0.5, 0], [2, 0], [2.5, 1]]",
                               "course = [[0, 1], [0.5, 1], [0.5, 0], [2, 0], [2, 0.3]]"}) {
      const std::string what = scene.substr(scene.rfind("method")) + course;
      const Answer a = answer_to(scene + "[normal_force]\n" + course + "\n");
      EXPECT_TRUE(a.json["warnings"].empty()) << what;
      EXPECT_LE(a.json["summary"]["energy_balance_error"]["value"].get<double>(), 1e-9) << what;
      const auto t = a.table["t_s"], v = a.table["v_m_per_s"], R = a.table["friction_N"];
      const bool layer = what.find("boundary") != std::string::npos;  // its zone rings until its damper rests
      for (std::size_t i = 0; i < t.size(); ++i) {
        if (t[i] <= (layer ? 0.7 : 0.5) || t[i] >= 2) continue;
        EXPECT_NEAR(R[i], 0, layer ? 1e-9 : 0) << what << t[i];
        EXPECT_NEAR(v[i], v[20], 1e-10) << what << t[i];
      }
      EXPECT_GT(v[20], 0.1) << what;
      EXPECT_EQ(v.back() < v[20] - 0.1, what.ends_with("]]")) << what;  // pressed again
    }
  }
}

// m v' = -mu_V F_N v by every law of a point, no dry friction: v = exp(-t) m/s. A bristle that is settled carries none
// of the load, and what it has stored is lost.
TEST_F(Simulate, ViscousFrictionAloneSlowsAPoint) {
  const std::string block =
      "[contact]\npatch = \"point\"\nnormal_force = 10\n[friction]\nmu_viscous = 0.1\n[body]\nmass = 1\n"
      "velocity = [1, 0]\n[motion]\ntimes = [0, 1, 2]\nmethod = ";
  for (const char* method : {"\"rigid\"", "\"tanh\"\nsteepness = 100", "\"dahl\"\nstiffness = 1e4",
                             "\"lugre\"\nstiffness = 1e4\ndamping = 10"}) {
    const std::string scene = block + method + "\n";
    const Answer a = answer_to(scene);
    for (const std::size_t i : {1u, 2u})
      EXPECT_NEAR(a.table["v_m_per_s"][i], std::exp(-static_cast<double>(i)), 1e-10) << method;
    EXPECT_LE(a.json["summary"]["energy_balance_error"]["value"].get<double>(), 1e-9) << method;
    if (scene.find("stiffness") == std::string::npos) continue;
    const Answer settled =
        answer_to(with(scene, "mass = 1", "mass = 1\nsettled = true") + "[[applied]]\nforce = [1, 0]\n");
    EXPECT_NEAR(settled.table["v_m_per_s"].back(), 1, 1e-10) << method;  // 1 N / mu_V F_N
    EXPECT_EQ(settled.table["stored_J"], (std::vector<double>{0, 0, 0})) << method;
  }
  for (const char* half : {"\"half_freedom\"", "\"half_freedom_linearised\""}) {
    // Its zone in balance: c_1 kappa' = V(v + kappa') - c_0 kappa, and a stiff bristle makes it the body's.
    const Answer a = answer_to(block + half + "\nstiffness = 1e6\ndamping = 1e3\n");
    EXPECT_NEAR(a.table["v_m_per_s"].back(), std::exp(-2), 1e-5) << half;
    EXPECT_LE(a.json["summary"]["energy_balance_error"]["value"].get<double>(), 1e-9) << half;
  }
}

// A body at rest that nothing presses any more has nothing to slip by; one that is pulled or turned then has a pole.
TEST_F(Simulate, ABodyThatNothingPressesBreaksAwayWhereItMoves) {
  const std::string scene =
      with(with(good_puck, "velocity = [1, 0]\nspin = 20\n", ""),
           "method = \"rigid\"\ntimes = { from = 0, to = 0.4, count = 41 }",
           "method = \"return_mapping\"\nstep = 2e-3\nstiffness = 1e6\nturn_stiffness = 1e3\ntimes = [0, 0.5, 2, 3]");
  for (const char* course : {"course = [[0, 1], [2, 0]]", "course = [[0, 1], [0.5, 1], [0.5, 0]]", "during = [0, 1]"}) {
    const std::string pressed = scene + "[normal_force]\n" + course + "\n";
    for (const std::string& text : {pressed, rigid(pressed)})
      EXPECT_TRUE(answer_to(text).json["events"].empty()) << course;
    const std::string settled = with(pressed, "inertia = 0.00125", "inertia = 0.00125\nsettled = true");
    for (const char* load : {"force = [1e-9, 0]", "force = [0, 0.1]", "moment = 1e-12"}) {
      const auto events = answer_to(settled + "[[applied]]\n" + load + "\n").json["events"];
      ASSERT_EQ(events.size(), 1u) << course << load;
      EXPECT_EQ(events[0]["event"], "break_away");
      if (std::string(load).starts_with("force")) {
        const double x = events[0]["slip_direction"][0], y = events[0]["slip_direction"][1];
        EXPECT_GT(x * x + y * y, 0) << course << load;
      } else {
        EXPECT_NEAR(events[0]["pole_from_centre_m"][0].get<double>(), 0, 1e-12) << course;
      }
    }
  }
}

// Held by 1 N, let go at 0.5 s. In a dead band it does not hold either.
TEST_F(Simulate, APointIsLetGoWhenNothingPressesAnyMore) {
  for (const char* method :
       {"\"rigid\"", "\"karnopp\"\ndead_band = 1e-3", "\"dahl\"\nstiffness = 1e4",
        "\"lugre\"\nstiffness = 1e4\ndamping = 10", "\"elastoplastic\"\nstiffness = 1e4\ndamping = 10"}) {
    const std::string rest = with(with(good_point, "velocity = [3, 0]", "settled = true"), "ramp = [0, 1]", "");
    const bool bristles = std::string(method).find("stiffness") != std::string::npos;
    const Answer a = answer_to(with(bristles ? rest : with(rest, "settled = true", ""), "[motion]",
                                    "[motion]\nmethod = " + std::string(method)) +
                               "[normal_force]\nduring = [0, 0.5]\n");
    EXPECT_EQ(a.value("break_away"), 0.5) << method;
    EXPECT_NEAR(a.table["v_m_per_s"].back(), 1.5 / 2, 1e-11) << method;
  }
}

// Bristles that nothing ever presses were never bent: what a settled one would have stored is lost at once.
TEST_F(Simulate, ABristleThatNothingEverPressesIsStraight) {
  const std::string settled = with(with(good_point, "velocity = [3, 0]", "settled = true"), "ramp = [0, 1]", "");
  for (const char* method : {"\"dahl\"\nstiffness = 1e4", "\"lugre\"\nstiffness = 1e4\ndamping = 10",
                             "\"elastoplastic\"\nstiffness = 1e4\ndamping = 10"}) {
    for (const char* course : {"course = [[0, 0], [1, 0]]", "course = [[0, 0], [5, 1]]", "during = [3, 4]"}) {
      const Answer a = answer_to(with(settled, "[motion]", "[motion]\nmethod = " + std::string(method)) +
                                 "[normal_force]\n" + course + "\n");
      if (!std::string(course).ends_with("[5, 1]]")) {
        EXPECT_EQ(a.table["deflection_m"], (std::vector<double>{0, 0, 0})) << method << course;
        EXPECT_NEAR(a.table["v_m_per_s"].back(), 1. / 2 * 2, 1e-11) << method << course;
      }
      EXPECT_EQ(a.table["stored_J"][0], 0) << method << course;
      EXPECT_LE(a.json["summary"]["energy_balance_error"]["value"].get<double>(), 1e-9) << method << course;
    }
  }
}

// Spin alone: J w' = -mu F_N m_0 a with m_0 = 3 pi / 16 and a as Hertz gives it under F_N (1 - t / T), that is
// -M (1 - t / T)^(4/3).
TEST_F(Simulate, AHertzContactShrinksWithItsForce) {
  const double J = 4e-4, w0 = 20, mu = 0.4, F = 20, T = 2, modulus = 50e6 / (1 - 0.49 * 0.49);
  const auto moment = [&](double t) {
    const double now = F * (1 - t / T);
    return mu * now * 3 * std::numbers::pi / 16 * contact::HertzCircle::under_force(now, 20e-3, modulus).radius;
  };
  const Answer mapped = committed("pressed_less"), exact = answer_to(rigid(scene_text("pressed_less")));
  const auto t = mapped.table["t_s"];
  ASSERT_EQ(t.size(), 101u);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    const double way = 3 * T / 7 * (1 - std::pow(1 - t[i] / T, 7. / 3));
    EXPECT_NEAR(exact.table["w_rad_per_s"][i], w0 - moment(0) / J * way, 1e-9) << t[i];
    EXPECT_NEAR(mapped.table["w_rad_per_s"][i], w0 - moment(0) / J * way, 1e-5) << t[i];
    EXPECT_NEAR(exact.table["moment_Nm"][i], -moment(t[i]), 1e-12 * moment(0)) << t[i];
  }
  for (const double share : mapped.table["share_of_limit"]) {
    EXPECT_TRUE(std::isnan(share) || share <= 1 + 1e-12) << share;
  }
}

TEST_F(Simulate, AContactThatSwingsHoldsWithoutCreep) {
  const Answer a = committed("pressed_in_waves");
  EXPECT_EQ(a.value("drift_in_stick"), 0);
  EXPECT_TRUE(a.json["events"].empty());
  const auto share = a.table["share_of_limit"];
  EXPECT_NEAR(*std::ranges::max_element(share), 0.91, 0.01);
  // More of it is too much for the least of them.
  const Answer more = answer_to(with(scene_text("pressed_in_waves"), "force = [0.35, 0.0]", "force = [0.45, 0.0]"));
  EXPECT_FALSE(more.json["events"].empty());
  EXPECT_GT(more.table["x_m"].back(), 10 * a.table["x_m"].back());
}

// A force that does not change leaves the contact as it is, to the bit.
TEST_F(Simulate, AConstantForceIsThatOfAFixedRadius) {
  for (const std::string& scene : {good_puck, scene_text("puck_bristles"), scene_text("held_load")}) {
    const Answer fixed = answer_to(scene), followed = answer_to(scene + "\n[normal_force]\ncourse = [[0, 1]]\n");
    EXPECT_EQ(fixed.table.rows, followed.table.rows);
    EXPECT_EQ(fixed.json["events"], followed.json["events"]);
  }
}

// Twice the force from the start is a radius of 2^(1/3).
TEST_F(Simulate, AForceTwiceAsLargeIsThatOfAWiderContact) {
  for (const std::string& text :
       {good_puck, with(good_puck, "method = \"rigid\"",
                        "method = \"return_mapping\"\nstep = 1e-3\nstiffness = 1e8\nturn_stiffness = 1e5")}) {
    const Answer pressed = answer_to(text + "[normal_force]\ncourse = [[0, 2]]\n");
    const Answer wide = answer_to(with(with(text, "normal_force = 9.81", "normal_force = 19.62"), "radius = 0.05",
                                       "radius = 0.062996052494743658"));
    for (const char* column : {"x_m", "turn_rad", "vx_m_per_s", "w_rad_per_s"}) {
      const auto one = pressed.table[column], other = wide.table[column];
      for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(one[i], other[i], 1e-9) << column;
    }
    EXPECT_NEAR(pressed.value("stop_time"), wide.value("stop_time"), 1e-9);
  }
}

// What the theory leaves out is judged where it presses most.
TEST_F(Simulate, WarnsOfTheLargestForce) {
  const std::string scene = with(scene_text("pressed_less"), "course = [[0, 1], [2, 0]]", "course = [[0, 1]]");
  const auto warnings_of = [&](const std::string& force, const std::string& course) {
    const Answer a = answer_to(
        with(with(scene, "normal_force = 20.0 ", "normal_force = " + force + " "), "course = [[0, 1]]", course));
    return a.json["warnings"];
  };
  const auto hard = warnings_of("20000.0", "course = [[0, 1]]");
  ASSERT_EQ(hard.size(), 1u);
  for (const char* course :
       {"course = [[0, 1000]]", "course = [[0, 1], [1, 1000]]", "sine = { angular_frequency = 5, mean = 999 }"})
    EXPECT_EQ(warnings_of("20.0", course), hard) << course;
  EXPECT_TRUE(warnings_of("20.0", "course = [[0, 1], [2, 0]]").empty());
  EXPECT_TRUE(warnings_of("20000.0", "course = [[0, 1e-3]]").empty());
  // What comes after the last of the times, 2 s, presses nobody.
  EXPECT_TRUE(warnings_of("20.0", "course = [[0, 1], [2, 1], [100, 1000]]").empty());
}

// The least that presses a bristle is a share of the most that presses it in time, not of what would later.
TEST_F(Simulate, WhatPressesLaterDoesNotMatter) {
  const std::string block = with(good_point, "[motion]", "[motion]\nmethod = \"lugre\"\nstiffness = 1e4\ndamping = 10");
  const Answer now = answer_to(block + "[normal_force]\ncourse = [[0, 1], [2, 1]]\n");
  const Answer later = answer_to(block + "[normal_force]\ncourse = [[0, 1], [2, 1], [9, 1e9]]\n");
  EXPECT_EQ(now.table.rows, later.table.rows);
}

TEST(Course, TheLargestIsThatOfItsTime) {
  EXPECT_EQ(largest_value(ConstantCourse{}, 2), 1);
  EXPECT_EQ(largest_value(DuringCourse{1, 3}, 2), 1);
  EXPECT_EQ(largest_value(DuringCourse{3, 4}, 2), 0);
  EXPECT_EQ(largest_value(DuringCourse{-1, 0}, 2), 0);
  EXPECT_EQ(largest_value(RampCourse{1, 5}, 2), 0.25);
  EXPECT_EQ(largest_value(RampCourse{3, 5}, 2), 0);
  EXPECT_EQ(largest_value(PointCourse{{{-1, 7}, {0, 6}, {0, 1}, {1, 3}, {1, 2}, {2, 2}, {4, 100}}}, 2), 3);
  EXPECT_EQ(largest_value(PointCourse{{{1, 1}, {3, 5}}}, 2), 3);
  EXPECT_EQ(largest_value(PointCourse{{{3, 5}, {4, 9}}}, 2), 5);
  // Against what it is at many times.
  for (const double phase : {-9., -2., 0., 1.5, 3., 8.}) {
    for (double w = 0.1; w < 10; w *= 1.3) {
      const Course sine = SineCourse{1.5, w, phase};
      double seen = 0;
      for (int i = 0; i <= 100000; ++i) seen = std::max(seen, value_at(sine, 2e-5 * i));
      EXPECT_NEAR(largest_value(sine, 2), seen, 1e-7) << w << ", " << phase;
    }
  }
}

// Whatever the force does: friction loses energy, and what it has lost balances.
TEST_F(Simulate, AContactThatGrowsAndShrinksNeverGivesEnergy) {
  const std::string puck =
      with(scene_text("puck_bristles"), "stiffness = 1e8 ", "damping = 30\nturn_damping = 0.04\nstiffness = 1e6 ");
  const std::string ellipse = with(puck, "patch = \"hertz_disc\"\nradius = 0.05 ",
                                   "patch = \"hertz_ellipse\"\nangle = 0.3\nsemi_axes = [0.06, 0.04]");
  for (const std::string& scene : {puck, ellipse, rigid(scene_text("puck_bristles"))}) {
    for (const char* course :
         {"course = [[0, 1], [0.05, 0], [0.1, 3], [0.1, 0.2], [0.2, 5], [0.3, 0]]",
          "sine = { angular_frequency = 90, phase = 1, mean = 1 }", "during = [0.1, 0.2]", "ramp = [0.05, 0.3]"}) {
      const Answer a = answer_to(scene + "\n[normal_force]\n" + course + "\n");
      EXPECT_LE(a.json["summary"]["energy_balance_error"]["value"].get<double>(), 1e-10) << course;
      const auto lost = a.table["dissipated_J"];
      EXPECT_TRUE(std::ranges::is_sorted(lost, [](double x, double y) { return x < y - 1e-15; })) << course;
      EXPECT_GT(lost.back(), 0.1) << course;
    }
  }
}

// Every contact whose pressure keeps its shape: a moment slips where mu F_N a (F_N) falls to it.
TEST_F(Simulate, EveryContactShrinksByItsOwnLaw) {
  const std::string rest =
      "[friction]\nmu = 0.5\n[body]\nmass = 1\ninertia = 1\n[[applied]]\nmoment = 1e-5\n"
      "[normal_force]\ncourse = [[0, 1], [1, 0]]\n[motion]\ntimes = [0, 1]\n";
  const std::string plane = "[[contact.bodies]]\nplane = true\nrigid = true\n";
  const std::string soft = "youngs_modulus = 1e6\npoisson_ratio = 0.5\n";
  struct Case {
    std::string contact;
    double growth;
  };
  for (const auto& [contact, growth] :
       {Case{"[[contact.bodies]]\nradius = 0.01\n" + soft + plane, 1. / 3},
        Case{"[[contact.bodies]]\nradii = [0.01, 0.02]\n" + soft + plane, 1. / 3},
        Case{"[[contact.bodies]]\nstamp = \"cone\"\nslope = 0.1\n" + soft + plane, 1. / 2},
        Case{"[[contact.bodies]]\nstamp = \"power\"\ncoefficient = 1000\nexponent = 4\n" + soft + plane, 1. / 5},
        Case{"[[contact.bodies]]\nstamp = \"flat_punch\"\nradius = 1e-3\n" + soft + plane, 0},
        Case{"[contact.fingertip]\ncoefficient = 2e-3\nexponent = 0.15\n", 0.15},
        Case{"[[contact.parts]]\npatch = \"ring\"\nradius = 1e-3\nnormal_force = 1\n", 0}}) {
    const bool parts = contact.find("parts") != std::string::npos;
    const Answer a = answer_to((parts ? "" : "[contact]\nnormal_force = 1\n") + contact + rest);
    // Its limit at first, from the margin at the break-away under the same moment.
    const double share = a.table["share_of_limit"][0];
    ASSERT_LT(share, 0.1) << contact;
    EXPECT_NEAR(std::pow(1 - a.value("break_away"), 1 + growth), share, 1e-9) << contact;
  }
}

// Any patch, any place of it: a rectangle that is turned, off the centre of mass, by bristles and without.
TEST_F(Simulate, AnyPatchIsFollowedByEveryMethod) {
  const std::string block =
      with(with(good_puck, "patch = \"hertz_disc\"\nradius = 0.05",
                "patch = \"rectangle\"\nsides = [0.1, 0.03]\ncentre = [0.01, 0.005]\nangle = 0.4"),
           "count = 41", "count = 3");
  const Answer rigid = answer_to(block);
  const std::string bristles = "stiffness = 1e7\nturn_stiffness = 1e4\n";
  const Answer mapped =
      answer_to(with(block, "method = \"rigid\"\n", "method = \"return_mapping\"\nstep = 2e-4\n" + bristles));
  const Answer plastic = answer_to(with(with(block, "method = \"rigid\"\n",
                                             "method = \"elastoplastic\"\ntolerance = 1e-7\n"
                                             "rest_speed = 1e-4\nstiffness = 1e5\nturn_stiffness = 1e2\n"),
                                        "inertia = 0.00125", "inertia = 0.00125"));
  EXPECT_NEAR(mapped.value("stop_time"), rigid.value("stop_time"), 1e-4);
  for (const char* column : {"x_m", "y_m", "turn_rad"}) {
    EXPECT_NEAR(mapped.table[column].back(), rigid.table[column].back(), 2e-5) << column;
    EXPECT_NEAR(plastic.table[column].back(), rigid.table[column].back(), 2e-2) << column;
  }
}

TEST_F(Simulate, ThePrintedLawStopsElsewhere) {
  const std::string text =
      with(with(scene_text("figure_4_30"), "length = 0.2                 # m: of the metric, the radius\n", ""),
           "method = \"elastoplastic\"", "method = \"elastoplastic_printed\"");
  const Answer a = answer_to(text);
  EXPECT_GT(std::fabs(a.value("stop_time") - 43.936), 1);
}

TEST_F(Simulate, WhatCannotBeFollowedFurtherIsKeptSoFar) {
  std::string text = with(good_point, "force = [1, 0]\nramp = [0, 1]", "force = [1e58, 0]\nramp = [1.5, 2]");
  text = with(text, "[motion]", "[motion]\nmethod = \"dahl\"\nstiffness = 1e4");
  try {
    answer_to(text);
    FAIL() << "followed";
  } catch (const Unanswered& error) {
    EXPECT_NE(std::string(error.what()).find("cannot be followed beyond t = 1.5 s"), std::string::npos) << error.what();
  }
  EXPECT_EQ(test::read_motion_table(folder_ / "motion.csv")["t_s"], (std::vector<double>{0, 1}));
  const auto json = nlohmann::json::parse(std::ifstream(folder_ / "answer.json"));
  EXPECT_EQ(json["warnings"].size(), 1u);
}

TEST_F(Simulate, ErrorsOfTimesAndPlacesAreTold) {
  const Answer rough = answer_to(with(good_puck, "method = \"rigid\"", "method = \"rigid\"\ntolerance = 1e-8"));
  EXPECT_LE(std::fabs(rough.value("stop_time") - .28808448600715), rough.error("stop_time"));
  const Answer fine = committed("puck_hertz");
  const auto x = rough.table["x_m"], error = rough.table["x_error_m"], t = rough.table["t_s"];
  const auto exact = fine.table["x_m"];
  ASSERT_EQ(x.size(), 41u);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LE(std::fabs(x[i] - exact[10 * i]), error[i] + 1e-12) << t[i];
}

}  // namespace
}  // namespace patchgrip::cli
