#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <patchgrip/cli/press/press_creep.h>
#include <patchgrip/cli/press/press_scene.h>
#include <patchgrip/cli/press/press_tables.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/material.h>

#include "scenes.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path press_folder = test::data_folder / "scenes" / "press";

PressScene press_scene(std::string text) {
  return read_press_scene(TomlDocument::parse(std::move(text), (press_folder / "scene.toml").string()),
                          MaterialLibrary({test::data_folder / "materials"}));
}

PressScene committed(const std::string& name) {
  return read_press_scene(TomlDocument::read(press_folder / (name + ".toml")),
                          MaterialLibrary({test::data_folder / "materials"}));
}

const Result& result(const LawAnswer& law, std::string_view name) {
  for (const Result& r : law.results) {
    if (r.name == name) return r;
  }
  throw std::logic_error("no result " + std::string(name));
}

double value(const LawAnswer& law, std::string_view name) { return result(law, name).value; }

const LawAnswer& beside(const Answer& answer, std::string_view law) {
  for (const LawAnswer& l : answer.beside) {
    if (l.law == law) return l;
  }
  throw std::logic_error("no law " + std::string(law));
}

std::size_t column(const Table& table, std::string_view name) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i] == name) return i;
  }
  throw std::logic_error("no column " + std::string(name));
}

// A stamp on soft rubber, E* = 200 kPa / 3.
std::string stamp(const std::string& shape, const std::string& load = "normal_force = 0.1") {
  return "[contact]\n" + load + "\n[[contact.bodies]]\n" + shape +
         "\nrigid = true\n[[contact.bodies]]\nplane = true\nyoungs_modulus = 50e3\npoisson_ratio = 0.5\n";
}

void expect_sound(const LawAnswer& law) {
  EXPECT_FALSE(law.law.empty());
  for (const Result& r : law.results) {
    EXPECT_TRUE(std::isfinite(r.value)) << law.law << ' ' << r.name;
    EXPECT_TRUE(std::isfinite(r.error) && r.error >= 0) << law.law << ' ' << r.name;
  }
}

class CommittedScene : public ::testing::TestWithParam<std::string> {};

std::vector<std::string> committed_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(press_folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST_P(CommittedScene, IsAnsweredWithErrorsAndATable) {
  const PressScene scene = committed(GetParam());
  EXPECT_FALSE(scene.title.empty());
  Answer answer;
  Table table;
  if (std::holds_alternative<TimedLoad>(scene.load)) {
    PressedOverTime pressed = press_over_time(scene);
    answer = std::move(pressed.answer);
    table = std::move(pressed.table);
  } else {
    const Pressed pressed = press(scene);
    answer = pressed.answer;
    table = scene.sweep ? sweep_table(scene) : surface_table(scene, pressed);
  }
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
  std::ifstream readme(test::data_folder / "scenes" / "README.md");
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
  const Table table = sweep_table(scene);
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
  const auto by_force = test::with(by_approach, "approach = 5e-4", fmt::format("normal_force = {:.17g}", force));
  EXPECT_NEAR(value(press(press_scene(by_force)).answer.main, "approach") / 5e-4, 1, 1e-13);
}

TEST(Press, MeshOfAnEllipsoidAgreesWithItsRadii) {
  const Answer mesh = press(committed("mesh_on_plate")).answer;
  // At the pole of the ellipsoid R = ax^2 / az, ay^2 / az.
  const std::string text = test::with(test::good_bodies, "radius = 0.01", "radii = [0.09, 0.04]");
  const Answer exact = press(press_scene(test::with(text, "normal_force = 5.0", "normal_force = 1.0"))).answer;
  for (const char* name : {"semi_axis_a", "semi_axis_b", "approach", "peak_pressure"}) {
    const Result& r = result(mesh.main, name);
    EXPECT_NEAR(r.value, value(exact.main, name), r.error) << name;
    EXPECT_LT(r.error, 0.15 * r.value) << name;
  }
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

struct Bad {
  std::string name;
  std::string text;
  std::string message;
};

class BadPressScene : public ::testing::TestWithParam<Bad> {};

TEST_P(BadPressScene, IsRefusedWithKeyValueAndWhatIsAllowed) {
  const auto refusal = [&]() -> std::string {
    try {
      const PressScene scene = press_scene(GetParam().text);
      if (std::holds_alternative<TimedLoad>(scene.load)) {
        press_over_time(scene);
      } else {
        press(scene);
      }
    } catch (const SceneError& error) {
      return error.what();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal(), HasSubstr(GetParam().message));
}

std::vector<Bad> bad_scenes() {
  const std::string creep = test::with(stamp("radius = 0.02", ""), "youngs_modulus = 50e3",
                                       "poynting_thomson = { E1 = 1e4, E2 = 2e4, eta = 1e3 }");
  const std::string load = "[load]\nnormal_force = [[0, 1]]\ntimes = [1]\n";
  return {
      {"NoLoad", stamp("radius = 0.02", ""), "contact: needs 'normal_force', 'approach' or 'contact_radius'"},
      {"TwoLoads", stamp("radius = 0.02", "normal_force = 1\napproach = 1e-3"),
       "contact.approach = 1e-3: one of 'normal_force', 'approach' and 'contact_radius'"},
      {"NegativeForce", stamp("radius = 0.02", "normal_force = -1"), "contact.normal_force = -1: a force in N, from"},
      {"UnknownStamp", stamp("stamp = \"kone\"\nslope = 1"), "stamp = \"kone\": unknown name; did you mean 'cone'?"},
      {"ConeWithRadius", stamp("stamp = \"cone\"\nslope = 1\nradius = 1"), "radius = 1: not used by a cone"},
      {"ConeWithoutSlope", stamp("stamp = \"cone\""), "slope: missing: a slope"},
      {"FractionOfATerm", stamp("stamp = \"sphere\"\nradius = 1\nterms = 2.5"), "terms = 2.5: a whole number"},
      {"FlatEndOfBoth", stamp("stamp = \"flat_end\"\nend_radius = 1\nradius = 1\nslope = 1"),
       "a flat end goes on with either 'radius' (paraboloid) or 'slope' (cone)"},
      {"FallingPoints", stamp("stamp = \"points\"\npoints = [[0, 0], [1e-3, 1e-4], [2e-3, 0]]"), "is not allowed"},
      {"TwoStamps", test::with(stamp("stamp = \"cone\"\nslope = 1"), "plane = true", "radius = 1"),
       "bodies: a stamp presses on a plane"},
      {"SphereBeyondItsEquator", stamp("stamp = \"sphere\"\nradius = 1e-3", "contact_radius = 2e-3"),
       "contact_radius = 0.002 is not allowed"},
      {"Saddle", stamp("radii = [0.02, -0.01]"), "is not allowed"},
      {"RadiiOfThree", stamp("radii = [1, 2, 3]"), "two principal radii [R1, R2]"},
      {"RadiusOfAnEllipse", stamp("radii = [0.02, 0.01]", "contact_radius = 1e-3"),
       "contact_radius: an ellipse has two"},
      {"NoSuchMesh", stamp("mesh = \"no.off\"\npoint = [0, 0, 0]"), "no.off"},
      {"NoSuchMap", stamp("height_map = \"no.csv\"\ncell = [1e-3, 1e-3]"), "no.csv\": no such file"},
      {"MapWithoutCells", stamp("height_map = \"rough_surface.csv\""), "cell: missing: two lengths in m"},
      {"MapIsNoGrid", stamp("height_map = \"ellipsoid.off\"\ncell = [1e-3, 1e-3]"), "ellipsoid.off"},
      {"StaticCreep", test::with(creep, "[contact]\n", "[contact]\nnormal_force = 1\n"),
       "a viscoelastic body needs its load over time"},
      {"LoadTwice", test::with(creep, "[contact]\n", "[contact]\nnormal_force = 1\n") + load,
       "contact: the load is under [load]"},
      {"TimesBackwards", creep + "[load]\nnormal_force = [[0, 1]]\ntimes = [2, 1]\n",
       "load.times = [2, 1]: times in s"},
      {"PointsBackwards", creep + "[load]\nnormal_force = [[1, 1], [0, 1]]\ntimes = [2]\n",
       "t_1 = 0 is not allowed: must not be less than the time before it"},
      {"LoadWithoutHistory", creep + "[load]\ntimes = [1]\n", "load: needs one of 'normal_force', 'approach', 'sine'"},
      {"NegativeViscosity", test::with(creep, "eta = 1e3", "eta = -1") + load, "eta = -1: a viscosity in Pa s"},
      {"TwoModels", test::with(creep, "poisson_ratio", "maxwell = { E1 = 1, eta = 1 }\npoisson_ratio") + load,
       "maxwell: not used beside 'poynting_thomson'"},
      {"CreepWithoutPoisson", test::with(creep, "poisson_ratio = 0.5", "") + load, "poisson_ratio: missing"},
      {"PullBelowPullOff", stamp("radius = 0.01", "normal_force = -1") + "[adhesion]\nwork = 0.1\n", "is not allowed"},
      {"AdhesionOfAStamp", stamp("stamp = \"cone\"\nslope = 1") + "[adhesion]\nwork = 0.1\n",
       "adhesion: covered between balls, hollows and planes"},
      {"SweepOfTwo", stamp("radius = 0.01") + "[sweep]\nmu = [1, 2]\napproach = [1e-3]\n",
       "one quantity is swept at a time"},
      {"RatioOfBalls", stamp("radius = 0.01") + "[sweep]\nradii_ratio = [1, 0.5]\n",
       "'radii_ratio' varies the smaller"},
      {"FingertipOfNothing", "[contact]\nnormal_force = 1\n[contact.fingertip]\nalpha = 2\n",
       "contact.fingertip: needs 'coefficient' and 'exponent', 'measured'"},
      {"ApproachOfAFingertip", "[contact]\napproach = 1e-3\n[contact.fingertip]\ncoefficient = 4e-3\nexponent = 0.3\n",
       "approach: the power law says nothing of it"},
      {"PatchWithoutModulus", "[contact]\npatch = \"hertz_disc\"\nradius = 1e-3\nnormal_force = 1\n",
       "contact.contact_modulus: missing"},
      {"PolygonAsPressure",
       "[contact]\npatch = \"rectangle\"\nsides = [1, 1]\nnormal_force = 1\ncontact_modulus = 1e6\n",
       "press makes stamps of round pressures"},
      {"UnknownTable", stamp("radius = 0.01") + "[lode]\n", "lode: unknown key; did you mean 'load'?"},
  };
}

INSTANTIATE_TEST_SUITE_P(Press, BadPressScene, ::testing::ValuesIn(bad_scenes()),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace patchgrip::cli
