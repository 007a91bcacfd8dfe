#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/material.h>

#include "press_scenes.h"

namespace patchgrip::cli {
namespace {

using ::testing::HasSubstr;

using namespace test;

void expect_sound(const LawAnswer& law) {
  EXPECT_FALSE(law.law.empty());
  for (const Result& r : law.results) {
    EXPECT_TRUE(std::isfinite(r.value)) << law.law << ' ' << r.name;
    EXPECT_TRUE(std::isfinite(r.error) && r.error >= 0) << law.law << ' ' << r.name;
  }
}

class CommittedScene : public ::testing::TestWithParam<std::string> {};

TEST_P(CommittedScene, IsAnsweredWithErrorsAndATable) {
  const PressScene scene = committed(GetParam());
  EXPECT_FALSE(scene.title.empty());
  const auto [answer, table] = answered(scene);
  expect_sound(answer.main);
  for (const LawAnswer& law : answer.beside) expect_sound(law);
  EXPECT_GE(table.rows.size(), 2U);
  for (const auto& row : table.rows) {
    ASSERT_EQ(row.size(), table.columns.size());
    for (const double x : row) ASSERT_FALSE(std::isnan(x));
  }
}

INSTANTIATE_TEST_SUITE_P(Press, CommittedScene, ::testing::ValuesIn(committed_scenes()),
                         [](const auto& given) { return given.param; });

TEST(Press, TheReadmeKnowsEveryScene) {
  std::ifstream readme(data_folder / "scenes" / "README.md");
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  for (const std::string& name : committed_scenes()) {
    if (name.starts_with("figure_4_")) continue;
    EXPECT_THAT(text, HasSubstr("`" + name + "`"));
  }
}

TEST(Press, BallOnPlateIsTheHertzCircleOfTheLibrary) {
  const Pressed pressed = press(committed("rubber_ball"));
  const double modulus =
      contact::contact_modulus(contact::Material::elastic(50e6, 0.49), contact::Material::elastic(70e9, 0.25));
  const auto circle = contact::HertzCircle::under_force(5, 10e-3, modulus);
  const LawAnswer& answer = pressed.answer.main;
  EXPECT_NEAR(value(answer, "contact_radius"), circle.radius, result(answer, "contact_radius").error);
  EXPECT_NEAR(value(answer, "approach"), circle.approach, 2 * result(answer, "approach").error);
  EXPECT_NEAR(value(answer, "peak_pressure"), circle.peak_pressure, 2 * result(answer, "peak_pressure").error);
  EXPECT_EQ(value(answer, "normal_force"), 5);
}

TEST(Press, WarnsOfABallThatSinksInByHowMuch) {
  const auto warnings = press(press_scene(stamp("radius = 0.02", "contact_radius = 0.01"))).answer.warnings;
  ASSERT_EQ(warnings.size(), 1U);
  // At equal radius F / F_Hertz = 1 + (2/5) q^2 + (9/35) q^4 + ... with q = 1/2.
  EXPECT_THAT(warnings.front(), HasSubstr("a/R = 0.5 is not small"));
  EXPECT_THAT(warnings.front(), HasSubstr("change by +12 %"));
}

TEST(Press, WarnsOfABallThatSinksInDeeperThanASphereCan) {
  const std::string text =
      with(with(good_bodies, "normal_force = 5.0", "contact_radius = 0.02"), "[poles]\nlist = [[0.001, 0.002]]\n", "");
  const auto warnings = press(press_scene(text)).answer.warnings;
  EXPECT_THAT(warnings, ::testing::Contains(HasSubstr("sphere does not reach this load")));
  EXPECT_THAT(warnings, ::testing::Contains(HasSubstr("a/R = 2 is not small; slopes and strains")));
}

TEST(Press, PressureOfEveryRoundLawCarriesTheForce) {
  for (const char* shape :
       {"radius = 0.02", "stamp = \"sphere\"\nradius = 0.02", "stamp = \"sphere\"\nradius = 0.02\nterms = 3",
        "stamp = \"power\"\ncoefficient = 3\nexponent = 1.5", "stamp = \"power\"\ncoefficient = 1e4\nexponent = 4"}) {
    const PressScene scene = press_scene(stamp(shape) + "[profile]\ndistance = { from = 0, to = 1, count = 2 }\n");
    const Pressed pressed = press(scene);
    const double a = pressed.extent;
    double force = 0;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) / steps;  // r = a sin(pi t / 2): the root at the rim is gone
      const double r = a * std::sin(std::numbers::pi / 2 * t);
      const double dr = a * std::cos(std::numbers::pi / 2 * t) * std::numbers::pi / 2 / steps;
      force += 2 * std::numbers::pi * r * pressed.surface(r, 0).pressure.value * dr;
    }
    EXPECT_NEAR(force / 0.1, 1, 1e-6) << shape;
  }
}

TEST(Press, SurfaceTouchesTheStampInsideAndLeavesItOutside) {
  for (const char* shape : {"radius = 0.02", "stamp = \"cone\"\nslope = 0.3", "radii = [0.03, 0.01]\ndirection = 0.7",
                            "stamp = \"flat_end\"\nend_radius = 2e-3\nradius = 0.02"}) {
    const PressScene scene = press_scene(stamp(shape));
    const Pressed pressed = press(scene);
    const double a = pressed.extent;
    double last = 0;
    for (const double x : {1.05, 1.2, 1.5, 2., 3.}) {
      const SurfacePoint s = pressed.surface(x * a, 0);
      EXPECT_EQ(s.pressure.value, 0) << shape << x;
      EXPECT_GT(s.gap.value, last) << shape << x;
      last = s.gap.value;
    }
    EXPECT_EQ(pressed.surface(0.1 * a, 0.1 * a).gap.value, 0) << shape;
    const double force = value(pressed.answer.main, "normal_force");
    const double modulus = value(pressed.answer.main, "contact_modulus");
    const double far = 1e3 * a;
    EXPECT_NEAR(pressed.surface(far, 0).displacement.value * std::numbers::pi * modulus * far / force, 1, 2e-6)
        << shape;
  }
}

TEST(Press, AdhesiveSweepPassesThePullOff) {
  const PressScene scene = committed("figure_4_13");
  std::vector<std::string> warnings;
  const Table table = sweep_table(scene, warnings);
  EXPECT_THAT(warnings,
              ::testing::ElementsAre(
                  HasSubstr("sweep.contact_radius[175] = 0.0018, at 176 values: how far the attraction reaches"),
                  HasSubstr("sweep.contact_radius[96] = 0.00101 to sweep.contact_radius[175] = 0.0018, at 80 values; "
                            "at the first a/R = 0.101 is not small")));
  const std::size_t force = column(table, "normal_force_N");
  const double pull_off = value(press(scene).answer.main, "pull_off_force");
  EXPECT_NEAR(pull_off / (-1.5 * std::numbers::pi * 0.096 * 0.01), 1, 1e-15);  // Example 4.6: -0.45 N/m R
  double least = 0;
  for (const auto& row : table.rows) least = std::min(least, row[force]);
  EXPECT_NEAR(least / pull_off, 1, 1e-4);
  EXPECT_GE(least, pull_off * (1 + 1e-15));
}

TEST(Press, StressOfAdhesionMakesMaugisTheLaw) {
  const std::string text = stamp("radius = 0.01", "normal_force = 0.001") + "[adhesion]\nwork = 0.096\n";
  EXPECT_EQ(press(press_scene(text)).answer.main.law, "jkr");
  const Answer answer = press(press_scene(text + "stress = 500\n")).answer;
  EXPECT_EQ(answer.main.law, "maugis_dugdale");
  const double a = value(answer.main, "contact_radius");
  EXPECT_GT(a, value(beside(answer, "dmt"), "contact_radius"));
  EXPECT_LT(a, value(beside(answer, "jkr"), "contact_radius"));
  EXPECT_LT(value(beside(answer, "hertz"), "contact_radius"), value(beside(answer, "dmt"), "contact_radius"));
}

TEST(Press, CreepStartsElasticAndEndsRelaxed) {
  const PressedOverTime pressed = press_over_time(committed("figure_4_9"));
  const std::size_t delta = column(pressed.table, "approach_m");
  const std::size_t seed = column(pressed.table, "seed_approach_m");
  // C F^(2/3) of E1 + E2, and of E2 alone (formulas of 4.1.2); the seed's relation is (E/E2)^(1/3) too deep in the end.
  EXPECT_NEAR(pressed.table.rows.front()[delta], 8.585357e-3, 1e-9);
  const double relaxed = 13.628404e-3;
  const double left = std::exp(-2.5 * 2);
  EXPECT_NEAR(pressed.table.rows.back()[delta] / relaxed, std::cbrt((1 - left / 2) * (1 - left / 2)), 1e-7);
  EXPECT_NEAR(pressed.table.rows.back()[seed] / pressed.table.rows.back()[delta], std::cbrt(2 - left), 1e-7);
}

TEST(Press, CyclesAgreeWithTheTable) {
  const PressedOverTime pressed = press_over_time(committed("press_and_release"));
  const Table& t = pressed.table;
  for (const auto& row : t.rows) {
    if (std::fabs(row[0] - 0.8) > 1e-12) continue;
    EXPECT_NEAR(row[column(t, "normal_force_N")], 0.388499873671, 1e-11);  // visco_two_cycles
    EXPECT_NEAR(row[column(t, "contact_radius_m")], 0.005485106604, 1e-11);
    return;
  }
  FAIL() << "the scene does not ask for t = 0.8 s";
}

TEST(Press, WarnsOfTheSteepestSurfaceOverTime) {
  const std::string scene =
      "[contact]\n[[contact.bodies]]\nradius = 20e-3\nrigid = true\n[[contact.bodies]]\nplane = true\n"
      "poynting_thomson = { E1 = 25e3, E2 = 25e3, eta = 5e3 }\npoisson_ratio = 0.5\n"
      "[load]\napproach = [[0, 0.0], [1, 5e-3], [2, 0.1e-3]]\ntimes = [1.7]\n[profile]\ndistance = [0]\n";
  const auto warnings = [&](const std::string& times) {
    return press_over_time(press_scene(scene + "times = " + times)).answer.warnings;
  };
  EXPECT_THAT(warnings("[1.7]"), ::testing::ElementsAre(HasSubstr("a/R = 0.18 is not small")));
  EXPECT_THAT(warnings("[1]"), ::testing::ElementsAre(HasSubstr("a/R = 0.5 is not small")));
}

TEST(Press, GivenPressureOfHertzMakesAParaboloid) {
  const std::string text =
      "[contact]\npatch = \"hertz_disc\"\nradius = 4e-3\nnormal_force = 0.2844416\ncontact_modulus = 66666\n";
  const Pressed pressed = press(press_scene(text));
  EXPECT_NEAR(value(pressed.answer.main, "approach"), 0.8e-3, 1e-13);  // rot_sym_pressure_413, n = 1: R = 20 mm
  const double height = 0.8e-3 - pressed.surface(2.5e-3, 0).displacement.value;
  EXPECT_NEAR(height, 2.5e-3 * 2.5e-3 / (2 * 20e-3), 1e-13);
}

TEST(Press, FingertipFitHasItsLimits) {
  const Answer answer = press(committed("fingertip_measured")).answer;
  EXPECT_NEAR(value(answer.main, "gamma"), 0.295327141050, 1e-11);  // power_law_fit
  EXPECT_LT(value(answer.main, "gamma_low"), value(answer.main, "gamma"));
  EXPECT_GT(value(answer.main, "gamma_high"), value(answer.main, "gamma"));
}

TEST(Press, WinklerForceAndApproachAgree) {
  const std::string by_approach = "[contact]\napproach = 5e-4\n[contact.fingertip]\nradius = 0.02\nbed_modulus = 1e5\n";
  const double force = value(press(press_scene(by_approach)).answer.main, "normal_force");
  EXPECT_NEAR(force, 0.077222555320, 1e-11);  // winkler_theta0_0
  const auto by_force = with(by_approach, "approach = 5e-4", fmt::format("normal_force = {:.17g}", force));
  EXPECT_NEAR(value(press(press_scene(by_force)).answer.main, "approach") / 5e-4, 1, 1e-13);
}

TEST(Press, MeshOfAnEllipsoidAgreesWithItsRadii) {
  const Answer mesh = press(committed("mesh_on_plate")).answer;
  // At the pole of the ellipsoid R = ax^2 / az, ay^2 / az.
  const std::string text = with(good_bodies, "radius = 0.01", "radii = [0.09, 0.04]");
  const Answer exact = press(press_scene(with(text, "normal_force = 5.0", "normal_force = 1.0"))).answer;
  for (const char* name : {"semi_axis_a", "semi_axis_b", "approach", "peak_pressure"}) {
    const Result& r = result(mesh.main, name);
    EXPECT_NEAR(r.value, value(exact.main, name), r.error) << name;
    EXPECT_LT(r.error, 0.15 * r.value) << name;
  }
}

TEST(Press, TwoMeshesTouchEachInItsOwnPoint) {
  const auto meshes = [](const char* below) {
    return fmt::format(
        "[contact]\nnormal_force = 1.0\n"
        "[[contact.bodies]]\nmesh = \"ellipsoid.off\"\nunit = 1e-3\npoint = [0, 0, 10]\nmaterial = "
        "\"rubber\"\n[[contact.bodies]]\nmesh = \"ellipsoid.off\"\nunit = 1e-3\npoint = {}\nmaterial "
        "= \"glass\"\n",
        below);
  };
  const Answer answer = press(press_scene(meshes("[0, 0, -10]"))).answer;
  for (const char* body : {"body_a", "body_b"}) {
    const Result &narrow = result(answer.main, fmt::format("{}_radius_1", body)),
                 &wide = result(answer.main, fmt::format("{}_radius_2", body));
    EXPECT_NEAR(narrow.value, 0.04, narrow.error);  // ay^2 / az
    EXPECT_NEAR(wide.value, 0.09, wide.error);
    EXPECT_LT(wide.error, 0.2 * wide.value);
  }
  const Result& relative = result(answer.main, "radius_large");
  EXPECT_NEAR(relative.value, 0.045, relative.error);

  const auto refused = [&](const char* point, const char* why) {
    EXPECT_THAT([&] { press(press_scene(meshes(point))); }, ::testing::ThrowsMessage<SceneError>(HasSubstr(why)));
  };
  refused("[0, 0, 10]", "contact.bodies: angle_between_normals");
  refused("[0, 20, 0]", "contact.bodies: angle_between_normals");
  refused("[0, 0, 7000]", "contact.bodies[1].mesh = \"ellipsoid.off\": distance of the point to the mesh");
}

TEST(Press, HeightMapCarriesItsForce) {
  const PressScene scene = committed("rough_surface");
  const Pressed pressed = press(scene);
  const Table map = surface_table(scene, pressed);
  ASSERT_EQ(map.rows.size(), 64U * 64U);
  double force = 0;
  for (const auto& row : map.rows) force += row[2] * 15.625e-6 * 15.625e-6;
  EXPECT_NEAR(force / 0.2, 1, 1e-9);
}

TEST(Press, AnswersAreJsonThatReadsBack) {
  const PressScene scene = committed("rubber_ball");
  const Pressed pressed = press(scene);
  const auto json = nlohmann::json::parse(to_json(pressed.answer, "ball.toml", scene.title, scene.notes));
  EXPECT_EQ(json.at("law"), "hertz");
  EXPECT_EQ(json.at("results").at("approach").at("value").get<double>(), value(pressed.answer.main, "approach"));
  EXPECT_EQ(json.at("results").at("approach").at("unit"), "m");
  EXPECT_EQ(json.at("beside").at(0).at("law"), "sphere");
  EXPECT_EQ(json.at("contact").size(), 2U);
}

}  // namespace
}  // namespace patchgrip::cli
