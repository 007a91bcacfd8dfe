#include <patchgrip/cli/tabulate.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/local_stribeck.h>

#include "scenes.h"
#include "scratch_folder.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;

using test::scene_of;
using test::with;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::StartsWith;

struct Row {
  double pole_x, pole_y, spin, fx, fy, m, force_error, moment_error, vx, vy, w;
};

struct Table {
  std::vector<std::string> comments;
  std::string header;
  std::vector<Row> rows;
  std::string text;
};

double number(std::string_view text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_TRUE(error == std::errc{} && end == text.data() + text.size()) << text;
  return value;
}

Table parsed(std::string text) {
  Table table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) {
      table.comments.push_back(line);
    } else if (table.header.empty()) {
      table.header = line;
    } else {
      std::vector<double> v;
      std::istringstream fields(line);
      for (std::string field; std::getline(fields, field, ',');) v.push_back(number(field));
      EXPECT_THAT(v, SizeIs(11));
      if (v.size() == 11) table.rows.push_back({v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10]});
    }
  }
  table.text = std::move(text);
  return table;
}

class Tabulate : public test::ScratchFolder {
 protected:
  Table table_of(const Scene& scene) {
    const fs::path file = folder_ / "table.csv";
    OutputFile out(file.string());
    tabulate(scene, "scenes/tilt.toml", out);
    out.commit();
    return parsed(content(file));
  }

  // The rows of a scene, a force of 10 N on `patch`, are what the library says at each point.
  template <class P>
  void expect_local_friction(const std::string& text, const P& patch) {
    const Scene scene = scene_of(text + "angular_speed = [0.1, 1, 10]\n");
    const Table table = table_of(scene);
    ASSERT_THAT(table.rows, SizeIs(6));
    for (const Row& row : table.rows) {
      const auto wrench = local_friction_wrench(scene.law, 10, patch, {row.vx, row.vy, row.w});
      EXPECT_EQ(row.fx, wrench.value.fx);
      EXPECT_EQ(row.m, wrench.value.m);
      EXPECT_GE(row.force_error, wrench.force_error);
      EXPECT_LE(row.force_error, 1e-13);
    }
  }

  static std::string content(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

TEST_F(Tabulate, AHertzDiscAboutItsCentreHasTheBoringMoment) {
  const Table table = table_of(scene_of(test::good_disc));
  ASSERT_THAT(table.rows, SizeIs(2));
  const Row& row = table.rows[1];
  const double exact = -3 * std::numbers::pi / 16 * 0.5 * 10 * 0.005;
  EXPECT_EQ(row.fx, 0);
  EXPECT_EQ(row.fy, 0);
  EXPECT_NEAR(row.m, exact, row.moment_error + 1e-18);
  EXPECT_LT(row.moment_error, 1e-14 * std::fabs(exact));
}

TEST_F(Tabulate, TheHeadNamesVersionSceneContactLawAndUnits) {
  Scene scene = scene_of("title = \"Tilted µ\"\n" + test::good_bodies);
  const Table table = table_of(scene);
  ASSERT_GE(table.comments.size(), 6U);
  EXPECT_THAT(table.comments[0], StartsWith("# patchgrip "));
  EXPECT_EQ(table.comments[1], "# scene: scenes/tilt.toml");
  EXPECT_EQ(table.comments[2], "# title: Tilted µ");
  EXPECT_THAT(table.text, HasSubstr("# contact: Hertz disc, radius 0.000829"));
  EXPECT_THAT(table.text, HasSubstr("# contact: body A: ball of radius 0.01 m, rubber, E = 5e+07 Pa, nu = 0.49"));
  EXPECT_THAT(table.text, HasSubstr("# friction: Coulomb, mu = 0.8"));
  for (const std::string& comment : table.comments) EXPECT_THAT(comment, StartsWith("# "));
  EXPECT_EQ(table.header,
            "pole_x_m,pole_y_m,spin,force_x_N,force_y_N,moment_Nm,force_error_N,moment_error_Nm,vx_m_per_s,vy_m_per_s,"
            "w_rad_per_s");
}

TEST_F(Tabulate, NumbersReadBackAsTheSameDoubles) {
  const Scene scene = scene_of(with(test::good_disc, "[[0.001, 0.002], [0, 0]]", "[[0.1, 0.30000000000000004]]"));
  const Table table = table_of(scene);
  ASSERT_THAT(table.rows, SizeIs(1));
  const Row& row = table.rows[0];
  EXPECT_EQ(row.pole_x, 0.1);
  EXPECT_EQ(row.pole_y, 0.30000000000000004);
  const auto wrench = friction_wrench(scene.law, 10, friction::HertzDisc::of_radius(0.005), {row.vx, row.vy, row.w});
  EXPECT_EQ(row.fx, wrench.value.fx);
  EXPECT_EQ(row.fy, wrench.value.fy);
  EXPECT_EQ(row.m, wrench.value.m);
}

TEST_F(Tabulate, NoZeroHasASign) {
  const Table table = table_of(
      scene_of(with(test::good_disc, "[[0.001, 0.002], [0, 0]]", "[[0, 0], [1, 0], [0, -1]]\nspin = [1, -1]")));
  EXPECT_EQ(table.text.find(",-0,"), std::string::npos);
  EXPECT_EQ(table.text.find("\n-0,"), std::string::npos);
}

TEST_F(Tabulate, ATranslationCarriesItsTwistAndFullForce) {
  const Table table = table_of(
      scene_of(with(test::good_disc, "list = [[0.001, 0.002], [0, 0]]", "translation = { direction = [3, 4] }")));
  ASSERT_THAT(table.rows, SizeIs(1));
  const Row& row = table.rows[0];
  EXPECT_TRUE(std::isinf(row.pole_x) && std::isinf(row.pole_y));
  EXPECT_EQ(row.spin, 0);
  EXPECT_EQ(row.w, 0);
  EXPECT_NEAR(row.fx, -3, row.force_error + 1e-18);
  EXPECT_NEAR(row.fy, -4, row.force_error + 1e-18);
  EXPECT_NEAR(row.m, 0, row.moment_error);
}

TEST_F(Tabulate, OffCentreThePoleMovesWithThePatch) {
  const Table middle = table_of(scene_of(test::good_disc));
  const Table moved = table_of(scene_of(with(with(test::good_disc, "radius", "centre = [3, -2]\nradius"),
                                             "[[0.001, 0.002], [0, 0]]", "[[3.001, -1.998], [3, -2]]")));
  ASSERT_THAT(moved.rows, SizeIs(2));
  const Row& a = middle.rows[0];
  const Row& b = moved.rows[0];
  const double rounding = 1e-12 * 5;  // 3.001 - 3 keeps twelve digits
  EXPECT_NEAR(a.fx, b.fx, rounding);
  EXPECT_NEAR(a.fy, b.fy, rounding);
  EXPECT_NEAR(b.m, a.m + 3 * b.fy + 2 * b.fx, rounding);
}

// f = 2 y / Q across the line, seen from a pole on it.
TEST_F(Tabulate, ALineAboutAPointOfItself) {
  const std::string line = with(with(test::good_disc, "hertz_disc", "line"), "radius = 0.005", "length = 0.02");
  const Table table = table_of(scene_of(with(line, "[[0.001, 0.002], [0, 0]]", "[[0.004, 0], [0, 0]]")));
  ASSERT_THAT(table.rows, SizeIs(2));
  const Row& turning = table.rows[1];
  EXPECT_NEAR(turning.fx, 0, turning.force_error);
  EXPECT_NEAR(table.rows[0].fy / turning.m, -0.4 / 0.005, 1e-13);
  EXPECT_NEAR(table.rows[0].m / turning.m, 1 - 0.4 * 0.4, 1e-15);
}

TEST_F(Tabulate, BothSpinsAreOppositeForARoundPatch) {
  const Table table = table_of(scene_of(test::good_disc + "spin = [1, -1]\n"));
  ASSERT_THAT(table.rows, SizeIs(4));
  EXPECT_EQ(table.rows[0].fx, -table.rows[1].fx);
  EXPECT_EQ(table.rows[0].m, -table.rows[1].m);
}

TEST_F(Tabulate, StribeckFrictionFallsWithSpeed) {
  const Table table = table_of(
      scene_of(with(test::good_disc, "mu = 0.5", "mu_static = 0.6\nmu_kinetic = 0.4\nstribeck_velocity = 0.01") +
               "angular_speed = [1e-9, 1e9]\n"));
  ASSERT_THAT(table.rows, SizeIs(4));
  const double slow = std::hypot(table.rows[0].fx, table.rows[0].fy);
  const double fast = std::hypot(table.rows[1].fx, table.rows[1].fy);
  EXPECT_NEAR(slow / fast, 0.6 / 0.4, 1e-12);
}

TEST_F(Tabulate, StribeckFrictionIsTakenAtEachPointIfAsked) {
  const std::string law = "mu_static = 0.6\nmu_kinetic = 0.4\nstribeck_velocity = 0.01\nstribeck = \"local\"";
  const std::string disc = with(test::good_disc, "mu = 0.5", law);
  expect_local_friction(disc, friction::HertzDisc::of_radius(0.005));
  expect_local_friction(with(disc, "hertz_disc\"\nradius", "line\"\nlength"), friction::LineLoad::of_length(0.005));
  const Table bodies = table_of(scene_of(with(test::good_bodies, "mu = 0.8", law)));
  EXPECT_GT(bodies.rows[0].moment_error, 0);  // the bound is wider for a disc from bodies
  EXPECT_LT(bodies.rows[0].moment_error, 1e-13 * 10 * 0.001);
}

TEST_F(Tabulate, BodiesWidenTheBound) {
  const Scene from_bodies = scene_of(test::good_bodies);
  const Table bodies = table_of(from_bodies);
  const Table disc =
      table_of(scene_of(with(with(with(test::good_disc, "0.005", "0.000829341536182125"), "mu = 0.5", "mu = 0.8"),
                             "[[0.001, 0.002], [0, 0]]", "[[0.001, 0.002]]")));
  EXPECT_GT(bodies.rows[0].moment_error, disc.rows[0].moment_error);
  EXPECT_LT(bodies.rows[0].moment_error, 100 * 0x1p-53 * std::fabs(bodies.rows[0].m));
}

TEST_F(Tabulate, FrictionNeverDrivesTheMotionInAnySceneOfTheRepository) {
  for (const auto& entry : fs::directory_iterator(test::data_folder / "scenes")) {
    if (entry.path().extension() != ".toml") continue;
    const Scene scene = load_scene(entry.path());
    const Table table = table_of(scene);
    EXPECT_THAT(table.rows, SizeIs(scene.motions.size())) << entry.path();
    for (const Row& r : table.rows) {
      ASSERT_LE(r.fx * r.vx + r.fy * r.vy + r.m * r.w, 0) << entry.path() << " pole " << r.pole_x << " " << r.pole_y;
      ASSERT_GE(r.force_error, 0);
      ASSERT_GE(r.moment_error, 0);
    }
  }
}

TEST_F(Tabulate, Example48HasTheNumbersOfTheSeed) {
  const Table table = table_of(load_scene(test::data_folder / "scenes" / "example_4_8_line.toml"));
  for (const Row& r : table.rows) {
    if (r.pole_x != 0) continue;
    EXPECT_NEAR(r.fx, -0.865204647 * 5, 1e-8);
    EXPECT_NEAR(r.m, -0.290337795 * 0.1 * 5, 1e-9);
    return;
  }
  FAIL() << "no row with the pole on the axis";
}

TEST_F(Tabulate, AWrenchBeyondDoubleIsAnErrorAndLeavesTheOldTable) {
  const fs::path file = folder_ / "table.csv";
  std::ofstream(file) << "old";
  const Scene scene = scene_of(with(with(with(test::good_disc, "= 10", "= 1e60"), "mu = 0.5", "mu_viscous = 1e60"),
                                    "list = [[0.001, 0.002], [0, 0]]", "angular_speed = 1e60\nlist = [[1e60, 1e60]]") +
                               "grid = { x = [1, 1e60], y = 1e60 }\n");
  const Scene beyond = [&] {
    Scene s = scene;
    s.contact.normal_force = 1e200;
    return s;
  }();
  {
    OutputFile out(file.string());
    EXPECT_THROW(tabulate(beyond, "scene.toml", out), SceneError);
  }
  EXPECT_EQ(content(file), "old");
}

const std::string poles_of_parts =
    "[poles]\nlist = [[0.001, 0.002], [0.05, -0.03], [5, 4]]\ntranslation = { angle = 0.4 }\n";

std::string two_halves(const std::string& first, const std::string& second) {
  const std::string half = "[[contact.parts]]\npatch = \"rectangle\"\nsides = [0.02, 0.02]\nnormal_force = 0.5\n";
  return half + "centre = [-0.01, 0]\n" + first + half + "centre = [0.01, 0]\n" + second;
}

void expect_same(const Table& a, const Table& b, double scale) {
  ASSERT_EQ(a.rows.size(), b.rows.size());
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    const Row &p = a.rows[i], &q = b.rows[i];
    EXPECT_LE(std::hypot(scale * p.fx - q.fx, scale * p.fy - q.fy), scale * p.force_error + q.force_error + 4e-16) << i;
    EXPECT_NEAR(scale * p.m, q.m, scale * p.moment_error + q.moment_error + 4e-16 * std::fabs(q.m)) << i;
  }
}

TEST_F(Tabulate, PartsTogetherAreThePatchThatTheyMake) {
  const std::string law = "[friction]\nmu_static = 0.6\nmu_kinetic = 0.4\nstribeck_velocity = 0.05\nmu_viscous = 0.1\n";
  const Table whole = table_of(
      scene_of("[contact]\npatch = \"rectangle\"\nsides = [0.04, 0.02]\nnormal_force = 1\n" + law + poles_of_parts));
  expect_same(table_of(scene_of(two_halves("", "") + law + poles_of_parts)), whole, 1);
}

TEST_F(Tabulate, PartsMayHaveTheirOwnCoefficients) {
  const Table own = table_of(scene_of(two_halves("mu = 0.3\n", "mu = 0.3\n") + poles_of_parts));
  const Table common = table_of(scene_of(two_halves("", "") + "[friction]\nmu = 0.3\n" + poles_of_parts));
  expect_same(own, common, 1);
  // The second part alone, in effect.
  const Table one = table_of(scene_of(two_halves("mu = 0\n", "mu = 0.3\n") + poles_of_parts));
  const Table alone =
      table_of(scene_of("[contact]\npatch = \"rectangle\"\nsides = [0.02, 0.02]\ncentre = [0.01, 0]\nnormal_force = "
                        "0.5\n[friction]\nmu = 0.3\n" +
                        poles_of_parts));
  expect_same(one, alone, 1);
}

TEST_F(Tabulate, CrossedRodsRubAsTheEllipseThatTheyMake) {
  const std::string rods =
      "[contact]\nnormal_force = 100\n[[contact.bodies]]\ncylinder = 5e-3\nmaterial = \"steel\"\n"
      "[[contact.bodies]]\ncylinder = 12e-3\ndirection = 1.0\nmaterial = \"steel\"\n[friction]\nmu = 0.2\n"
      "[poles]\nray = { angle = [0, 1, 2], distance = [0, 1e-5, 1e-4, 1e-3, 1] }\n";
  const Scene scene = scene_of(rods);
  EXPECT_GT(scene.contact.shape_error, 0);
  EXPECT_EQ(scene.contact.radius_error, 0);
  const Table table = table_of(scene);
  for (const Row& row : table.rows) {
    EXPECT_GT(row.moment_error, 0);
    EXPECT_LE(row.force_error, 1e-12);
  }
  // Rods of one size at right angles make a circle.
  const std::string square = with(with(rods, "12e-3", "5e-3"), "direction = 1.0", "direction = 1.5707963267948966");
  const Table circle = table_of(scene_of(square));
  const Table ball = table_of(scene_of(with(with(square, "cylinder = 5e-3", "radius = 5e-3"),
                                            "cylinder = 5e-3\ndirection = 1.5707963267948966", "plane = true")));
  expect_same(circle, ball, 1);
}

TEST_F(Tabulate, ASignalLeavesTheOldTable) {
  const fs::path file = folder_ / "table.csv";
  std::ofstream(file) << "old";
  const Scene scene =
      scene_of(with(test::good_disc, "list = [[0.001, 0.002], [0, 0]]",
                    "grid = { x = { from = 0, to = 1, count = 10000 }, y = { from = 0, to = 1, count = 10000 } }"));
  const InterruptGuard guard;
  std::signal(SIGALRM, [](int) { std::raise(SIGINT); });
  alarm(1);
  {
    OutputFile out(file.string());
    EXPECT_THROW(tabulate(scene, "scene.toml", out), Interrupted);
    EXPECT_GT(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
  }
  std::signal(SIGALRM, SIG_DFL);
  EXPECT_EQ(content(file), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

}  // namespace
}  // namespace patchgrip::cli
