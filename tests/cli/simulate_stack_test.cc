// What `patchgrip simulate` answers of a body on another one: textbook slides, no creep, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <patchgrip/cli/scene/scene_error.h>

#include "bad_scene.h"
#include "simulate_scenes.h"

namespace patchgrip::cli {
namespace {

using test::BadScene;
using test::expect_refused;
using test::simulate_scene;
using test::with;

class SimulateStack : public test::SimulateTest {};

// mu = 0.1 below, 0.5 between; 2 kg and 1 kg; the upper one at 1 m/s.
const std::string good_stack = R"([contact]
patch = "hertz_disc"
radius = 0.05
normal_force = 29.43
[friction]
mu = 0.1
[body]
mass = 2
inertia = 0.01
[upper.contact]
patch = "uniform_disc"
radius = 0.03
normal_force = 9.81
[upper.friction]
mu = 0.5
[upper.body]
mass = 1
inertia = 0.002
velocity = [1, 0]
[upper.bristles]
stiffness = 1e8
turn_stiffness = 1e5
damping = 100
turn_damping = 0.1
[motion]
method = "return_mapping"
step = 5e-4
stiffness = 1e8
turn_stiffness = 1e5
damping = 100
turn_damping = 0.1
times = { from = 0, to = 0.8, count = 81 }
)";

double time_of(const nlohmann::json& events, const std::string& kind, const std::string& contact) {
  for (const auto& e : events) {
    if (e["event"] == kind && e["contact"] == contact) return e["time"]["value"];
  }
  return std::nan("");
}

// Both decelerate evenly until they move alike, then together.
TEST_F(SimulateStack, SlidesAsTheTextbookSays) {
  const double g = 9.81, a1 = (0.5 * 1 - 0.1 * 3) * g / 2, a2 = 0.5 * g, meet = 1 / (a1 + a2), v = a1 * meet;
  const double rest = meet + v / (0.1 * g), on = v * v / (2 * 0.1 * g);
  const Answer a = answer_to(good_stack);
  EXPECT_NEAR(time_of(a.json["events"], "sticks", "upper"), meet, 1e-3);
  EXPECT_NEAR(a.value("stop_time"), rest, 1e-3);
  EXPECT_NEAR(a.value("stop_distance"), a1 * meet * meet / 2 + on, 2e-5);
  EXPECT_NEAR(a.value("upper_stop_distance"), meet - a2 * meet * meet / 2 + on, 2e-5);
  EXPECT_LE(std::fabs(a.value("upper_stop_distance") - (meet - a2 * meet * meet / 2 + on)),
            a.error("upper_stop_distance") + 1e-6);
  EXPECT_EQ(a.value("upper_drift_in_stick"), 0);
}

// F = 10 N/s t: the plate leaves at mu_1 (m_1 + m_2) g with the block, and from under it at (mu_1 + mu_2) (m_1 + m_2) g.
TEST_F(SimulateStack, APlateIsPulledFromUnderABlock) {
  const Answer a = committed("stack_pulled");
  const double g = 9.81, first = 0.2 * 3 * g / 10, second = 0.6 * 3 * g / 10, end = 2.2;
  EXPECT_NEAR(time_of(a.json["events"], "break_away", "lower"), first, 2e-3);
  EXPECT_NEAR(time_of(a.json["events"], "break_away", "upper"), second, 2e-3);
  const double together = 5 * (second - first) * (second - first) / 3;
  const double plate = together + (5 * (end * end - second * second) - (0.2 * 3 + 0.4) * g * (end - second)) / 2;
  EXPECT_NEAR(a.table["vx_m_per_s"].back(), plate, 1e-3);
  EXPECT_NEAR(a.table["upper_vx_m_per_s"].back(), together + 0.4 * g * (end - second), 1e-3);
  const auto over = a.table["x_m"].back() - a.table["upper_x_m"].back();
  EXPECT_GT(over, 0);
  EXPECT_LT(over, 0.15 - 0.03);  // all of the block still on the plate
  EXPECT_EQ(a.table["slips"].back(), 1);
  EXPECT_NEAR(a.table["force_x_N"].back(), -0.2 * 3 * g, 1e-9);
  EXPECT_NEAR(a.table["upper_force_x_N"].back(), 0.4 * g, 1e-9);
}

// Below both limits: settled bristles stay as they are, and the ground carries what acts on both.
TEST_F(SimulateStack, WhatIsHeldDoesNotCreep) {
  const std::string held = with(with(good_stack, "velocity = [1, 0]", "place = [0.02, 0]"), "[upper.bristles]",
                                "[[upper.applied]]\nforce = [0, 1]\n[upper.bristles]");
  const Answer a = answer_to(with(held, "inertia = 0.01", "inertia = 0.01\nsettled = true"));
  EXPECT_TRUE(a.json["events"].empty());
  EXPECT_EQ(a.value("drift_in_stick"), 0);
  EXPECT_EQ(a.value("upper_drift_in_stick"), 0);
  for (const char* column : {"y_m", "turn_rad", "upper_y_m"}) EXPECT_NEAR(a.table[column].back(), 0, 1e-15) << column;
  EXPECT_NEAR(a.table["force_y_N"].back(), -1, 1e-12);
  EXPECT_NEAR(a.table["moment_Nm"].back(), -0.02, 1e-12);  // 1 N at 0.02 m
  EXPECT_NEAR(a.table["upper_moment_Nm"].back(), 0, 1e-12);
  EXPECT_NEAR(a.table["upper_share_of_limit"].back(), 1 / (0.5 * 9.81), 1e-9);
}

// On a body too heavy to move it is the puck alone.
TEST_F(SimulateStack, OnAHeavyBodyItIsABodyOnTheGround) {
  const Answer alone = committed("puck_bristles");
  std::string stack = with(good_stack, "mass = 2\ninertia = 0.01", "mass = 1e9\ninertia = 1e9");
  stack = with(stack, "patch = \"uniform_disc\"\nradius = 0.03", "patch = \"hertz_disc\"\nradius = 0.05");
  stack = with(stack, "inertia = 0.002\nvelocity = [1, 0]", "inertia = 1.25e-3\nvelocity = [1, 0]\nspin = 20");
  stack = with(stack, "turn_stiffness = 1e5\ndamping = 100\nturn_damping = 0.1\n[motion]",
               "turn_stiffness = 1.25e5\n[motion]");
  stack = with(with(stack, "step = 5e-4", "step = 2e-3"), "to = 0.8, count = 81", "to = 0.4, count = 201");
  const Answer a = answer_to(stack);
  for (const char* column : {"x_m", "turn_rad", "vx_m_per_s", "w_rad_per_s", "force_x_N", "moment_Nm"}) {
    const auto one = alone.table[column], other = a.table["upper_" + std::string(column)];
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < 140; ++i) EXPECT_NEAR(one[i], other[i], 1e-6 * (1 + std::fabs(one[i]))) << column << i;
  }
  EXPECT_NEAR(a.value("upper_stop_distance"), .12928855096844, 1e-5);
}

class BadStack : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadStack, IsRefusedWithLineAndReason) {
  expect_refused(GetParam(), [](const std::string& text) { return simulate_scene(text); });
}

std::string stack(const std::string& from, const std::string& to) { return with(good_stack, from, to); }

std::vector<BadScene> bad_stacks() {
  return {
      {"NoContact", stack("[upper.contact]\npatch = \"uniform_disc\"\nradius = 0.03\nnormal_force = 9.81\n", ""), 10,
       "upper.contact: missing: a table [upper.contact]"},
      {"NoFriction", stack("[upper.friction]\nmu = 0.5\n", ""), 10,
       "upper.friction: missing: a table [upper.friction], with 'mu' say"},
      {"NoBody", stack("[upper.body]\nmass = 1\ninertia = 0.002\nvelocity = [1, 0]\n", ""), 10,
       "upper.body: missing: a table [upper.body] with its 'mass'"},
      {"NoBristles",
       stack("[upper.bristles]\nstiffness = 1e8\nturn_stiffness = 1e5\ndamping = 100\nturn_damping = 0.1\n", ""), 10,
       "upper.bristles: missing: a table [upper.bristles] with 'stiffness'"},
      {"MassZero", stack("mass = 1\n", "mass = 0\n"), 17, "upper.body.mass = 0: a mass in kg, from 1e-60"},
      {"StiffnessNegative",
       stack("stiffness = 1e8\nturn_stiffness = 1e5\ndamping = 100\nturn_damping = 0.1\n[motion]",
             "stiffness = -1\nturn_stiffness = 1e5\n[motion]"),
       21, "upper.bristles.stiffness = -1: the stiffness of the bristles in N/m"},
      {"Misspelt", stack("[upper.bristles]", "[upper.bristels]"), 20,
       "upper.bristels: unknown key; did you mean 'bristles'?"},
      {"PointOnABody", stack("patch = \"uniform_disc\"\nradius = 0.03", "patch = \"point\""), 11,
       "upper.contact.patch = \"point\": a patch with a size"},
      {"NoPatch", stack("patch = \"uniform_disc\"\nradius = 0.03\nnormal_force", "normal_force"), 10,
       "upper.contact: needs 'patch' (a name), two tables [[upper.contact.bodies]], some [[upper.contact.parts]]"},
      {"LowerThatCarriesLess", stack("normal_force = 29.43", "normal_force = 9.8"), 4,
       "contact.normal_force = 9.8: both weights, at least the 9.81 N of the normal force of [upper.contact]"},
      {"PartsThatCarryLess",
       stack("[contact]\npatch = \"hertz_disc\"\nradius = 0.05\nnormal_force = 29.43",
             "[[contact.parts]]\npatch = \"hertz_disc\"\nradius = 0.05\nnormal_force = 9.8"),
       1, "contact: its normal force of 9.8 N carries both weights, at least the 9.81 N"},
      {"OnAPoint", test::good_point + "[upper.body]\nmass = 1\n", 14,
       "upper: used on a body in the plane, not on a point"},
      {"ByAnotherMethod",
       stack("method = \"return_mapping\"\nstep = 5e-4\nstiffness = 1e8\nturn_stiffness = 1e5\ndamping = 100\n"
             "turn_damping = 0.1\n",
             ""),
       10, "upper: a body on another one is followed by method = \"return_mapping\""},
      {"SettledAbove", stack("velocity = [1, 0]", "settled = true"), 19,
       "upper.body.settled = true: given in [body], for the bristles of both contacts"},
      {"RestSpeed", stack("step = 5e-4", "step = 5e-4\nrest_speed = 1"), 28,
       "motion.rest_speed = 1: not used with [upper]"},
      {"Pressed", good_stack + "[normal_force]\nramp = [0, 1]\n", 33, "normal_force: not used with [upper]"},
      {"Viscous", stack("mu = 0.5", "mu = 0.5\nmu_viscous = 1"), 16,
       "upper.friction.mu_viscous = 1: not used by method = \"return_mapping\""},
  };
}

INSTANTIATE_TEST_SUITE_P(Scene, BadStack, ::testing::ValuesIn(bad_stacks()),
                         [](const auto& bad) { return bad.param.name; });

}  // namespace
}  // namespace patchgrip::cli
