// What `patchgrip simulate` refuses, with line and reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <patchgrip/cli/scene/scene_error.h>

#include "bad_scene.h"
#include "simulate_scenes.h"

namespace patchgrip::cli {
namespace {

using test::BadScene;
using test::expect_refused;
using test::good_point;
using test::good_puck;
using test::simulate_scene;
using test::with;

class BadSimulate : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadSimulate, IsRefusedWithLineAndReason) {
  expect_refused(GetParam(), [](const std::string& text) { return simulate_scene(text); });
}

std::string puck(const std::string& from, const std::string& to) { return with(good_puck, from, to); }
std::string point(const std::string& from, const std::string& to) { return with(good_point, from, to); }
std::string applied(const std::string& keys) { return good_puck + "[[applied]]\n" + keys + "\n"; }
std::string method(const std::string& keys) { return puck("method = \"rigid\"", keys); }

std::vector<BadScene> bad_scenes() {
  return {
      {"NoBody", puck("[body]\nmass = 1\ninertia = 0.00125\nvelocity = [1, 0]\nspin = 20\n", ""), 1, "body: missing"},
      {"NoMotion", puck("[motion]\nmethod = \"rigid\"\ntimes = { from = 0, to = 0.4, count = 41 }\n", ""), 1,
       "motion: missing"},
      {"NoFriction", puck("[friction]\nmu = 0.5\n", ""), 1, "friction: missing"},
      {"NoMass", puck("mass = 1\n", ""), 7, "body.mass: missing: a mass in kg"},
      {"MassZero", puck("mass = 1", "mass = 0"), 8, "body.mass = 0: a mass in kg, from 1e-60"},
      {"InertiaNegative", puck("0.00125", "-1"), 9, "body.inertia = -1: a moment of inertia"},
      {"VelocityOfThree", puck("[1, 0]", "[1, 0, 0]"), 10, "body.velocity = [1, 0, 0]: a velocity [vx, vy]"},
      {"VelocityNotFinite", puck("[1, 0]", "[nan, 0]"), 10, "body.velocity[0] = nan"},
      {"Misspelt", puck("spin", "spn"), 11, "body.spn = 20: unknown key; did you mean 'spin'?"},
      {"SettledWithoutBristles", puck("spin = 20", "spin = 20\nsettled = true"), 12,
       "body.settled = true: not used by method = \"rigid\""},
      {"LoadThatChangesTooFast", applied("force = [1, 0]\nsine = { angular_frequency = 1e20 }"), 17,
       "applied[0].sine.angular_frequency = 1e20: an angular frequency in rad/s that steps of 1/40 of a period can "
       "follow to the last of 'times', from 1e-60 to 392699081.698"},
      {"PressedTooFast", good_puck + "[normal_force]\nsine = { angular_frequency = 1e12, mean = 2 }\n", 16,
       "normal_force.sine.angular_frequency = 1e12: an angular frequency in rad/s that steps of 1/40 of a period can"},
      {"SpringOfABody", puck("spin = 20", "spring = 20"), 11, "body.spring = 20: used with patch = \"point\""},
      {"UnknownMethod", method("method = \"rigd\""), 13,
       "motion.method = \"rigd\": unknown name; did you mean 'rigid'?"},
      {"MethodOfAPoint", method("method = \"lugre\""), 13, "motion.method = \"lugre\": of a patch: rigid"},
      {"StepOfRigid", method("method = \"rigid\"\nstep = 1"), 14, "motion.step = 1: not used by method = \"rigid\""},
      {"NoStep", method("method = \"return_mapping\"\nstiffness = 1\nturn_stiffness = 1"), 12, "motion.step: missing"},
      {"StepZero", method("method = \"return_mapping\"\nstiffness = 1\nturn_stiffness = 1\nstep = 0"), 16,
       "motion.step = 0: a step in s"},
      {"StepTooShort", method("method = \"return_mapping\"\nstiffness = 1\nturn_stiffness = 1\nstep = 1e-12"), 16,
       "motion.step = 1e-12: at least the last of 'times' / 1e+09"},
      {"NoStiffness", method("method = \"return_mapping\"\nstep = 1"), 12, "motion.stiffness: missing"},
      {"DampingNegative", method("method = \"elastoplastic\"\nstiffness = 1\nturn_stiffness = 1\ndamping = -1"), 16,
       "motion.damping = -1: a damping in N s/m"},
      {"HalfFreedomWithoutDamping", method("method = \"half_freedom\"\nstiffness = 1\nturn_stiffness = 1"), 12,
       "motion.damping: missing"},
      {"HalfFreedomDampedTooLittle",
       with(method("method = \"half_freedom\"\nstiffness = 1\nturn_stiffness = 1\ndamping = 1\nturn_damping = 1"),
            "mu = 0.5", "mu_static = 0.5\nmu_kinetic = 0.3\nstribeck_velocity = 0.01"),
       14, "damping is not allowed: must be more than 168"},
      {"BlockDampedTooLittle",
       point("[motion]", "[motion]\nmethod = \"half_freedom\"\nstiffness = 1\ndamping = 1")
           .replace(good_point.find("mu = 0.5"), 8, "mu_static = 0.5\nmu_kinetic = 0.3\nstribeck_velocity = 0.01"),
       14, "damping must be above 171.553 N s/m, or the zone jumps"},
      {"LinearisedWithoutDamping", point("[motion]", "[motion]\nmethod = \"half_freedom_linearised\"\nstiffness = 1"),
       12, "motion.damping: missing: a damping in N s/m"},
      {"LinearisedDampedTooLittle",
       point("[motion]", "[motion]\nmethod = \"half_freedom_linearised\"\nstiffness = 1\ndamping = 1")
           .replace(good_point.find("mu = 0.5"), 8, "mu_static = 0.5\nmu_kinetic = 0.3\nstribeck_velocity = 0.01"),
       14, "damping must be above 171.553 N s/m, or the zone jumps"},
      {"LinearisedOfABody", method("method = \"half_freedom_linearised\""), 13, "of a patch: rigid, return_mapping"},
      {"BoundaryLayerOfABody", method("method = \"boundary_layer\""), 13, "of a patch: rigid, return_mapping"},
      {"ZoneMassOfTanh", point("[motion]", "[motion]\nmethod = \"tanh\"\nzone_mass = 1"), 14,
       "motion.zone_mass = 1: not used by method = \"tanh\""},
      {"UnknownIntegrator",
       method("method = \"return_mapping\"\nstiffness = 1\nturn_stiffness = 1\nstep = 1\nintegrator = \"sdirk\""), 17,
       "unknown name; did you mean 'sdirk2'?"},
      {"ToleranceTooLarge", method("tolerance = 1"), 13, "motion.tolerance = 1: a tolerance of a step"},
      {"TimesFall", puck("{ from = 0, to = 0.4, count = 41 }", "[0, 2, 1]"), 14, "each later than the one before"},
      {"TimesAtZero", puck("{ from = 0, to = 0.4, count = 41 }", "0"), 14, "the last one above 0"},
      {"TimesNegative", puck("from = 0,", "from = -1,"), 14, "motion.times.from = -1: a time in s"},
      {"TooManyTimes", puck("count = 41", "count = 10000000"), 14, "at most 1000000 times"},
      {"EmptyApplied", applied(""), 15, "applied[0]: needs 'force' or 'moment'"},
      {"AppliedAsOneTable", good_puck + "[applied]\nmoment = 1\n", 15, "applied: tables, each headed [[applied]]"},
      {"TwoCourses", applied("moment = 1\nramp = [0, 1]\nduring = [0, 1]"), 18, "one of 'during', 'ramp'"},
      {"RampBackwards", applied("moment = 1\nramp = [2, 1]"), 17, "applied[0].ramp = [2, 1]: two times [t1, t2]"},
      {"SineWithoutFrequency", applied("moment = 1\nsine = { mean = 1 }"), 17, "sine.angular_frequency: missing"},
      {"CourseFalls", applied("moment = 1\ncourse = [[1, 0], [0, 1]]"), 17, "t not falling"},
      {"PressingAHertzContactAside",
       puck("radius = 0.05", "radius = 0.05\ncentre = [0.1, 0]") + "[normal_force]\nramp = [0, 1]\n", 4,
       "contact.centre = [0.1, 0]: [0, 0], the centre of mass, under a [normal_force] with which"},
      {"PressingElastoplastic",
       method("method = \"elastoplastic\"\nstiffness = 1\nturn_stiffness = 1") + "[normal_force]\nramp = [0, 1]\n", 17,
       "normal_force: not used by method = \"elastoplastic\" of a patch"},
      {"PressingAWholeSphere",
       puck("patch = \"hertz_disc\"\nradius = 0.05\nnormal_force = 9.81",
            "normal_force = 9.81\n[[contact.bodies]]\nstamp = \"sphere\"\nradius = 1\nyoungs_modulus = 1e6\n"
            "poisson_ratio = 0.5\n[[contact.bodies]]\nplane = true\nrigid = true") +
           "[normal_force]\nramp = [0, 1]\n",
       21, "normal_force: used with a contact whose pressure keeps its shape: a patch, balls"},
      {"PressingHertzianParts",
       puck("patch = \"hertz_disc\"\nradius = 0.05\nnormal_force = 9.81",
            "[[contact.parts]]\npatch = \"hertz_disc\"\nradius = 0.05\nnormal_force = 9.81") +
           "[normal_force]\nramp = [0, 1]\n",
       16, "normal_force: used with a contact whose pressure keeps its shape"},
      {"Pulling", good_puck + "[normal_force]\ncourse = [[0, 1], [1, -0.5]]\n", 16,
       "-0.5: a factor of the normal force, which only presses, from 1e-60 to 1e+60, or 0"},
      {"PullingInWaves", good_puck + "[normal_force]\nsine = { angular_frequency = 1, mean = 0.5 }\n", 16,
       "normal_force.sine.mean = 0.5: a mean of the factor of the normal force, which only presses, from 1 to"},
      {"PullingWithoutMean", good_puck + "[normal_force]\nsine = { angular_frequency = 1 }\n", 16,
       "normal_force.sine.mean: missing: a mean of the factor of the normal force"},
      {"PressingInTwoWays", good_point + "[normal_force]\nramp = [0, 1]\nduring = [0, 1]\n", 16,
       "one of 'during', 'ramp', 'sine' and 'course'"},
      {"LoadsOfLimit", good_puck + "[[loads]]\nmoment = 1\n", 15, "loads: not used by 'simulate'"},
      {"LocalStribeck",
       puck("mu = 0.5", "mu_static = 0.5\nmu_kinetic = 0.3\nstribeck_velocity = 1\nstribeck = \"local\""), 9,
       "'simulate' takes Stribeck's law in the mean"},
      {"ViscousBristles",
       with(method("method = \"return_mapping\"\nstiffness = 1\nturn_stiffness = 1\nstep = 1"), "mu = 0.5",
            "mu_viscous = 0.5"),
       6, "not used by method = \"return_mapping\""},
      {"PointThatTurns", point("mass = 2", "mass = 2\nspin = 1"), 8, "body.spin = 1: a point does not turn"},
      {"PointAside", point("[3, 0]", "[3, 1]"), 8, "body.velocity = [3, 1]: a point moves along x"},
      {"MomentOnAPoint", point("force = [1, 0]", "force = [1, 0]\nmoment = 1"), 11, "a point does not turn"},
      {"MethodOfAPatch", point("times = [0, 1, 2]", "times = [0, 1]\nmethod = \"return_mapping\""), 14,
       "of a point: rigid, elastoplastic"},
      {"NoSteepness", point("times = [0, 1, 2]", "times = [0, 1]\nmethod = \"tanh\""), 12, "motion.steepness: missing"},
  };
}

INSTANTIATE_TEST_SUITE_P(Scene, BadSimulate, ::testing::ValuesIn(bad_scenes()),
                         [](const auto& bad) { return bad.param.name; });

TEST(SimulateInput, GoodScenesAreAccepted) {
  EXPECT_NO_THROW(simulate_scene(good_puck));
  EXPECT_NO_THROW(simulate_scene(good_point));
  EXPECT_NO_THROW(simulate_scene(good_puck + "[normal_force]\nsine = { angular_frequency = 1, mean = 1 }\n"));
  // Return mapping has its own step.
  EXPECT_NO_THROW(simulate_scene(method("method = \"return_mapping\"\nstiffness = 1\nturn_stiffness = 1\nstep = 1") +
                                 "[[applied]]\nforce = [1, 0]\nsine = { angular_frequency = 1e12 }\n"
                                 "[normal_force]\nsine = { angular_frequency = 1e12, mean = 2 }\n"));
  EXPECT_NO_THROW(simulate_scene(applied("force = [1, 2]\ncourse = [[0, 0], [1, 1], [1, 3]]")));
}

TEST(SimulateInput, LoadsFollowTheirCourse) {
  const AppliedLoads loads({{{1, 0, 0}, DuringCourse{1, 2}},
                            {{0, 1, 0}, RampCourse{1, 3}},
                            {{0, 0, 1}, PointCourse{{{0, 1}, {2, 3}, {2, 5}, {4, 5}}}}});
  const auto at = [&](double t) { return loads(t); };
  EXPECT_EQ(at(0.5), dynamics::Vector3(0, 0, 1.5));
  EXPECT_EQ(at(1), dynamics::Vector3(1, 0, 2));
  EXPECT_EQ(at(2), dynamics::Vector3(0, 0.5, 5));
  EXPECT_EQ(at(9), dynamics::Vector3(0, 1, 5));
  EXPECT_EQ(loads.corners(), (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_DOUBLE_EQ(AppliedLoads({{{1, 0, 0}, SineCourse{2, 3, 0.5}}})(0.7)[0], 2 + std::sin(3 * 0.7 + 0.5));
}

}  // namespace
}  // namespace patchgrip::cli
