// What `patchgrip grasp` answers: the scenes of data/scenes/grasp by known numbers, and the same numbers however asked.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include <patchgrip/cli/grasp/grasp_files.h>
#include <patchgrip/cli/grasp/grasp_picture.h>
#include <patchgrip/cli/grasp/run_grasp.h>
#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/scene/scene_error.h>

#include "grasp_scenes.h"
#include "scratch_folder.h"

namespace patchgrip::cli {
namespace {

using grasp::Verdict;
using test::committed_grasp;
using test::good_grasp;
using test::grasp_scene;
using test::with;

const GraspLoadAnswer first_of(const GraspScene& scene) { return answer_grasp(scene).loads.front(); }

struct Known {
  std::string scene;
  Verdict verdict;
  double value;  // where it holds
};

void PrintTo(const Known& known, std::ostream* out) { *out << known.scene; }

class KnownGrasp : public ::testing::TestWithParam<Known> {};

TEST_P(KnownGrasp, IsFound) {
  const Known& known = GetParam();
  const GraspLoadAnswer a = first_of(committed_grasp(known.scene));
  EXPECT_EQ(a.verdict, known.verdict);
  if (known.verdict != Verdict::holds || !(known.value > 0)) return;
  EXPECT_NEAR(a.grip.value, known.value, 2e-12 * known.value);
  EXPECT_LE(a.lower, known.value * (1 + 1e-15));
  EXPECT_GE(a.upper, known.value * (1 - 1e-15));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, KnownGrasp,
    ::testing::Values(
        // grasp.json, pub-006 (the moment 0.01962 N m as a weight 4 mm beside the line of the fingers)
        Known{"pinch", Verdict::holds, 8.71523005126040164474450050996},
        Known{"turned_load", Verdict::holds, 8.71523005126040164474450050996},
        // each finger bears mu F = 4.8 N of friction: 14.4 N, less the weight 0.3 kg x 9.80665 m/s^2, upwards
        Known{"three_fingers", Verdict::holds, 3 * 0.6 * 8 + 0.3 * 9.80665},
        Known{"on_the_boundary", Verdict::holds, 4},
        // 2 F (mu cos 15 - sin 15) = 1 N
        Known{"friction_needed", Verdict::holds,
              0.5 / (0.5 * std::cos(std::numbers::pi / 12) - std::sin(std::numbers::pi / 12))},
        Known{"seven_frictionless", Verdict::holds, 0}, Known{"cannot_turn", Verdict::cannot_hold, 0},
        Known{"cup", Verdict::holds, 0}, Known{"mesh_object", Verdict::holds, 0}));

TEST(Grasp, GrowingContactsBearMoreThanThoseOfTheGivenForce) {
  const GraspScene scene = committed_grasp("rubber_fingers");
  const GraspLoadAnswer grown = first_of(scene);
  EXPECT_EQ(grown.verdict, Verdict::holds);
  EXPECT_LE(grown.upper - grown.lower, 1e-12 * grown.upper);
  // Pressed with what they need they need just that.
  GraspScene pressed = scene;
  pressed.question = GraspQuestion::least_grip;
  for (GraspContact& c : pressed.contacts) c.cone = c.grown(grown.upper);
  EXPECT_NEAR(first_of(pressed).grip.value, grown.upper, 1e-11 * grown.upper);
}

TEST(Grasp, AFamilyTellsWhereItStopsHolding) {
  const GraspAnswer answer = answer_grasp(committed_grasp("friction_needed"));
  ASSERT_EQ(answer.boundaries.size(), 1U);
  // Beyond tan 15 degrees the grip falls from infinity; it counts once it is below 1e6 times the load.
  const double exact = std::tan(std::numbers::pi / 12);
  EXPECT_GT(answer.boundaries[0], exact);
  EXPECT_LT(answer.boundaries[0], exact * (1 + 4e-6));
  for (const FamilyMember& m : answer.family) {
    const double grip = 0.5 / (m.value * std::cos(std::numbers::pi / 12) - std::sin(std::numbers::pi / 12));
    if (grip < 0) {
      EXPECT_EQ(m.verdict, Verdict::cannot_hold) << m.value;
    } else {
      EXPECT_NEAR(m.grip, grip, 1e-11 * grip) << m.value;
    }
  }
}

TEST(Grasp, ATurnedLoadIsThatOfAnotherScene) {
  const GraspAnswer family =
      answer_grasp(grasp_scene(good_grasp + "[family]\nturn = [0, 0.5, 1.5, 3]\naxis = [1, 0, 0]\n"));
  for (const FamilyMember& m : family.family) {
    const double c = std::cos(m.value), s = std::sin(m.value);
    const GraspScene turned = grasp_scene(
        with(good_grasp, "force = [0, 0, -4.905]", fmt::format("force = [0, {}, {}]", 4.905 * s, -4.905 * c)));
    EXPECT_NEAR(m.grip, first_of(turned).grip.value, 1e-11 * m.grip);
  }
}

TEST(Grasp, EveryQuestionIsAnswered) {
  const std::string limited = with(with(good_grasp, "mu = 0.5\n[[contacts]]", "mu = 0.5\nlimit = 20\n[[contacts]]"),
                                   "moment_length = 0.003\n", "moment_length = 0.003\nlimit = 20\n");
  for (const std::string_view question : grasp_questions) {
    if (question == "growing_grip") continue;  // asks for bodies
    SCOPED_TRACE(question);
    const GraspScene scene = grasp_scene(limited, question);
    const GraspAnswer answer = answer_grasp(scene);
    const auto json = nlohmann::json::parse(to_json(answer, scene, "scene.toml"));
    EXPECT_EQ(json["question"], question);
    EXPECT_TRUE(json.contains("answers") || json.contains("ball") || json.contains("internal_forces"));
    EXPECT_EQ(json["contacts"].size(), 2U);
  }
}

TEST(Grasp, WhatItSaysOfALoadBalances) {
  const GraspScene scene = grasp_scene(good_grasp);
  const auto json = nlohmann::json::parse(to_json(answer_grasp(scene), scene, "scene.toml"));
  const auto& answer = json["answers"][0];
  EXPECT_EQ(answer["verdict"], "holds");
  grasp::Vector6 sum;
  for (int i = 0; i < 3; ++i) {
    sum[i] = answer["load"]["force"]["value"][static_cast<std::size_t>(i)].get<double>();
    sum[i + 3] = answer["load"]["moment"]["value"][static_cast<std::size_t>(i)].get<double>();
  }
  const auto contacts = contacts_of(scene.contacts);
  double power = 0, slopes = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& c = answer["contacts"][i];
    const grasp::Vector3 t(c["friction"]["value"][0], c["friction"]["value"][1], c["friction_moment"]["value"]);
    sum += contacts[i].wrench(c["normal_force"]["value"], t);
    slopes += c["slope_of_value_with_mu"].get<double>();
  }
  EXPECT_LE(sum.norm(), 1e-12);
  // The power of the load in the escape is the value, and friction grows with mu in both contacts.
  for (int i = 0; i < 3; ++i) {
    power += answer["load"]["force"]["value"][static_cast<std::size_t>(i)].get<double>() *
             answer["escape_twist"]["velocity"][static_cast<std::size_t>(i)].get<double>();
    power += answer["load"]["moment"]["value"][static_cast<std::size_t>(i)].get<double>() *
             answer["escape_twist"]["turn_rate"][static_cast<std::size_t>(i)].get<double>();
  }
  const double value = answer["results"]["least_grip"]["value"];
  EXPECT_NEAR(power, value, 1e-11 * value);
  // Both contacts with mu (1 + d): the slope, by differences.
  const auto grip = [&](double mu) {
    GraspScene other = scene;
    for (GraspContact& c : other.contacts) c.cone = c.cone.with_mu(mu);
    return first_of(other).grip.value;
  };
  EXPECT_NEAR(slopes, (grip(0.5 + 1e-6) - grip(0.5 - 1e-6)) / 2e-6, 1e-6 * std::fabs(slopes));
}

TEST(Grasp, WeightAndMotionLoadTheObject) {
  const std::string head = "[object]\nmass = 2\ncentre_of_mass = [0.1, 0, 0]\ngravity = [0, 0, 0]\n";
  const std::string contacts = good_grasp.substr(good_grasp.find("[[contacts]]"));
  const GraspScene turned =
      grasp_scene(head + "inertia = [0.01, 0.03, 0.03, 0, 0, 0]\n[carried]\nturn_rate = [0, 0, 10]\n" + contacts);
  EXPECT_NEAR(turned.weight[0], 2 * 100 * 0.1, 1e-13);  // m omega^2 r
  const GraspScene pushed = grasp_scene(head + "[carried]\nacceleration = [0, 3, 0]\n" + contacts);
  EXPECT_NEAR(pushed.weight[1], -6, 1e-14);
  EXPECT_NEAR(pushed.weight[5], -0.6, 1e-14);
}

TEST(Grasp, WhatAContactSlidesWithBelongsToTheEscape) {
  const GraspScene scene = grasp_scene(good_grasp.substr(0, good_grasp.rfind("[[contacts]]")), "distance");
  const GraspLoadAnswer a = first_of(scene);
  EXPECT_EQ(a.verdict, Verdict::cannot_hold);
  const grasp::Contact contact = contacts_of(scene.contacts).front();
  const friction::Twist v = contact.sliding(a.grip.escape_twist), own = a.grip.contacts[0].sliding;
  EXPECT_NEAR(own.vx, v.vx, 1e-12 * std::hypot(v.vx, v.vy));
  EXPECT_NEAR(own.vy, v.vy, 1e-12 * std::hypot(v.vx, v.vy));
  EXPECT_NEAR(a.grip.contacts[0].resistance,
              -contact.opening(a.grip.escape_twist) + 0.5 * contact.cone().surface().patch().dissipation(v),
              1e-12 * a.grip.escape_twist.norm());
}

// Each of the committed scene's loads, weight included, asks for no more than the worst of them.
TEST(Grasp, TheWorstLoadBoundsThoseOfItsSet) {
  const GraspScene scene = committed_grasp("shaken_cube");
  const GraspLoadAnswer worst = first_of(scene);
  ASSERT_EQ(worst.verdict, Verdict::holds);
  EXPECT_LE(worst.upper - worst.lower, scene.worst.relative_width * worst.upper);
  grasp::Grasp grasp(contacts_of(scene.contacts));
  EXPECT_NEAR(grasp.least_grip(worst.load).value, worst.grip.value, 1e-12 * worst.upper);
  for (const grasp::Vector6& load : scene.loads) {
    for (const grasp::Vector6& axis : scene.disturbance) {
      for (const double side : {-1, 1}) {
        EXPECT_LE(grasp.least_grip(scene.weight + load + side * axis).lower, worst.upper);
      }
    }
  }
  const auto json = nlohmann::json::parse(to_json(answer_grasp(scene), scene, "scene.toml"));
  EXPECT_EQ(json["set"]["axes"], scene.disturbance.size());
  const auto& result = json["answers"][0]["results"]["worst_grip"];
  EXPECT_NEAR(result["value"].get<double>() + result["error"].get<double>(), worst.upper, 1e-12 * worst.upper);
}

// Up to 3 N in any direction at a point are three axes there; up to 3 N m are three more.
TEST(Grasp, ADisturbanceActsWhereItIsSaidTo) {
  const GraspScene scene =
      grasp_scene(good_grasp + "[disturbance]\nforce = 3\nat = [0, 0, 0.1]\nmoment = 0.2\n", "worst_grip");
  ASSERT_EQ(scene.disturbance.size(), 6U);
  const grasp::Vector6 along_x = grasp::spatial({3, 0, 0}, {0, 0.3, 0}), about_z = 0.2 * grasp::Vector6::Unit(5);
  EXPECT_LE((scene.disturbance[0] - along_x).norm(), 1e-16);
  EXPECT_EQ(scene.disturbance[5], about_z);
  const GraspScene axes = grasp_scene(good_grasp + "[disturbance]\naxes = [[3, 0, 0, 0, 0.3, 0]]\n", "worst_grip");
  ASSERT_EQ(axes.disturbance.size(), 1U);
  EXPECT_LE((axes.disturbance[0] - along_x).norm(), 1e-16);
}

// All loads times the factor, beside the weight, ask for no more than the limits; the worst one for just that.
TEST(Grasp, TheWorstFactorIsThatOfTheWorstLoad) {
  const std::string limited = with(with(good_grasp, "mu = 0.5\n[[contacts]]", "mu = 0.5\nlimit = 20\n[[contacts]]"),
                                   "moment_length = 0.003\n", "moment_length = 0.003\nlimit = 20\n");
  const GraspScene scene =
      grasp_scene(limited + "[object]\nmass = 0.1\n[disturbance]\nforce = 1\n", "worst_load_factor");
  const GraspLoadAnswer worst = first_of(scene);
  ASSERT_EQ(worst.verdict, Verdict::holds);
  EXPECT_LE(worst.upper - worst.lower, 0.01 * worst.upper);
  grasp::Grasp grasp(contacts_of(scene.contacts));
  EXPECT_NEAR(grasp.least_grip(scene.weight + worst.upper * worst.load).value, 20, 1e-9);
}

TEST(Grasp, ALoadThatIsHeldIsAtNoDistance) {
  EXPECT_EQ(first_of(grasp_scene(good_grasp, "distance")).verdict, Verdict::holds);
}

// A mesh tells its curvature, and so the patch, with an error of per cents: it is in every bracket.
TEST(Grasp, TheErrorOfBodiesIsInEveryBracket) {
  const std::string text = R"([[loads]]
force = [0, 0, -1]
[[contacts]]
position = [0.03, 0, 0]
normal = [1, 0, 0]
mu = 0.6
normal_force = 2
[[contacts.bodies]]
mesh = "../press/ellipsoid.off"
unit = 1e-3
point = [0, 0, 10]
material = "rubber"
[[contacts.bodies]]
plane = true
material = "glass"
[[contacts]]
position = [-0.03, 0, 0.001]
normal = [-1, 0, 0]
mu = 0.6
model = "soft_elliptic"
moment_length = 0.002
)";
  const GraspLoadAnswer least = first_of(grasp_scene(text));
  ASSERT_EQ(least.verdict, Verdict::holds);
  const double width = (least.upper - least.lower) / least.upper;
  EXPECT_GT(width, 1e-4);
  const GraspLoadAnswer growing = first_of(grasp_scene(text, "growing_grip"));
  EXPECT_GT((growing.upper - growing.lower) / growing.upper, 1e-4);
  const FamilyMember member = answer_grasp(grasp_scene(text + "[family]\nmu = [0.6]\n")).family.front();
  EXPECT_NEAR(member.lower, least.lower, 1e-9 * least.lower);
  EXPECT_NEAR(member.upper, least.upper, 1e-9 * least.upper);
}

using GraspFilesTest = test::ScratchFolder;

TEST_F(GraspFilesTest, AreWritten) {
  const std::string scene = (test::grasp_folder / "cup.toml").string();
  run_grasp({scene, path("cup.json"), path("cup.csv"), path("cup.vtk"), path("cup.svg"), ""}, "",
            MaterialLibrary({test::data_folder / "materials"}));
  for (const char* name : {"cup.json", "cup.csv", "cup.vtk", "cup.svg"}) {
    EXPECT_GT(std::filesystem::file_size(folder_ / name), 500U) << name;
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 4);
}

// No load, and one that is not held: every file is written, and forces where there are some.
TEST_F(GraspFilesTest, AreWrittenWithoutForces) {
  const MaterialLibrary materials({test::data_folder / "materials"});
  const std::string bodies = (test::grasp_folder / "rubber_fingers.toml").string();
  std::ifstream in(bodies);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text = with(text, "mass = 0.4                      # kg\ncentre_of_mass = [0.0, 0.006, 0.0]", "");
  const auto scene = write("none.toml", text + "[[loads]]\nforce = [0, 0, 0]\n");
  run_grasp({scene.string(), path("a.json"), path("a.csv"), path("a.vtk"), path("a.svg"), ""}, "", materials);
  EXPECT_GT(std::filesystem::file_size(folder_ / "a.vtk"), 100U);
  const std::string turn = (test::grasp_folder / "cannot_turn.toml").string();
  run_grasp({turn, path("b.json"), path("b.csv"), path("b.vtk"), "", ""}, "", materials);
  std::ifstream vtk(path("b.vtk"));
  const std::string vectors{std::istreambuf_iterator<char>(vtk), {}};
  EXPECT_THAT(vectors, ::testing::Not(::testing::HasSubstr("VECTORS force")));
  EXPECT_THAT(vectors, ::testing::HasSubstr("VECTORS escape"));
}

TEST_F(GraspFilesTest, BearTheNamesOfTheirKinds) {
  const std::string scene = (test::grasp_folder / "cup.toml").string();
  const MaterialLibrary materials({test::data_folder / "materials"});
  EXPECT_THROW(run_grasp({scene, path("a.json"), "", path("a.svg"), "", ""}, "", materials), std::runtime_error);
  EXPECT_THROW(run_grasp({scene, path("a.json"), "", "", path("a.vtk"), ""}, "", materials), std::runtime_error);
  EXPECT_THROW(run_grasp({scene, path("a.json"), path("a.csv"), "", "", ""}, "held_ball", materials),
               std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(GraspFilesTest, HoldInequalitiesOfConesThatAreSome) {
  const MaterialLibrary materials({test::data_folder / "materials"});
  const std::string scene = (test::grasp_folder / "friction_needed.toml").string();
  run_grasp({scene, path("a.json"), "", "", "", path("a.dat-s")}, "", materials);
  std::ifstream in(path("a.dat-s"));
  std::string line;
  int unknowns = 0, blocks = 0;
  std::getline(in, line);  // a comment
  (in >> unknowns).ignore(100, '\n');
  in >> blocks;
  EXPECT_EQ(unknowns, 6 + 2);  // the twist, and a force each
  EXPECT_EQ(blocks, 2 + 1);
  const std::string patches = (test::grasp_folder / "pinch.toml").string();
  EXPECT_THROW(run_grasp({patches, path("b.json"), "", "", "", path("b.dat-s")}, "", materials), SceneError);
  const std::string turn = (test::grasp_folder / "cannot_turn.toml").string();
  EXPECT_THROW(run_grasp({turn, path("b.json"), "", "", "", path("b.dat-s")}, "distance", materials), OutputError);
  EXPECT_FALSE(std::filesystem::exists(path("b.json")));
}

TEST(GraspPicture, DrawsEveryScene) {
  for (const std::string& name : test::scenes_in(test::grasp_folder)) {
    GraspScene scene = committed_grasp(name);
    scene.ball.max_simplices = 10;
    const std::string svg = picture_of(answer_grasp(scene), scene);
    EXPECT_THAT(svg, ::testing::StartsWith("<svg")) << name;
    EXPECT_THAT(svg, ::testing::Not(::testing::HasSubstr("nan"))) << name;
  }
}

}  // namespace
}  // namespace patchgrip::cli
