// Height maps in press: a line through the pressure, its errors, and what is refused or warned of.
#include <patchgrip/cli/press/pressed.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/tests/support/cases.h>

#include "press_scenes.h"
#include "scratch_folder.h"

namespace patchgrip::cli {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

using namespace test;

class PressHeightMap : public ScratchFolder {
 protected:
  struct Cap {
    double radius = 20e-3, x = 0, y = 0;  // [m]
    int cells = 80;
    double side = 4e-3;
  };

  // The cap of a ball on a map, E = 2 MPa, on a rigid plane.
  PressScene scene(const Cap& cap, double force, const std::string& more = "") const {
    const double cell = cap.side / cap.cells;
    std::string rows;
    for (int j = 0; j < cap.cells; ++j) {
      for (int i = 0; i < cap.cells; ++i) {
        const double x = (i + 0.5) * cell - cap.side / 2 - cap.x, y = (j + 0.5) * cell - cap.side / 2 - cap.y;
        rows += fmt::format("{}{:.17g}", i > 0 ? "," : "", -(x * x + y * y) / (2 * cap.radius));
      }
      rows += "\n";
    }
    write("cap.csv", rows);
    return press_scene_here(
        fmt::format("[contact]\nnormal_force = {}\n"
                    "[[contact.bodies]]\nheight_map = \"cap.csv\"\ncell = [{}, {}]\n"
                    "youngs_modulus = 2e6\npoisson_ratio = 0.5\n"
                    "[[contact.bodies]]\nplane = true\nrigid = true\n{}",
                    force, cell, cell, more));
  }
};

constexpr double modulus = 2e6 / 0.75;  // E* [Pa]

// Hertz: a, p_0 of the cap.
struct Hertz {
  Hertz(double force, double radius)
      : a(std::cbrt(0.75 * force * radius / modulus)), p0(1.5 * force / (std::numbers::pi * a * a)) {}
  double pressure(double r) const { return r < a ? p0 * std::sqrt(1 - r * r / (a * a)) : 0; }
  double a, p0;
};

TEST_F(PressHeightMap, PressureAlongALineHasErrorsThatHold) {
  std::mt19937_64 engine(80);
  for (int k = 0; k < testing::cases(20); ++k) {
    Cap cap;
    cap.cells = 2 * static_cast<int>(testing::uniform(engine, 12, 50));
    cap.x = testing::uniform(engine, -3e-4, 3e-4);
    cap.y = testing::uniform(engine, -3e-4, 3e-4);
    const double force = testing::log_uniform(engine, 0.03, 0.6), angle = testing::uniform(engine, -3, 3);
    const PressScene s = scene(
        cap, force, fmt::format("[profile]\ndistance = {{ from = 0, to = 1.9e-3, count = 60 }}\nangle = {}\n", angle));
    const Hertz hertz(force, cap.radius);
    for (const auto& row : surface_table(s, press(s)).rows) {
      const double exact = hertz.pressure(std::hypot(row[0] - cap.x, row[1] - cap.y));
      EXPECT_LE(std::fabs(row[2] - exact), row[3]) << cap.cells << " cells, at " << row[0] << ", " << row[1];
    }
  }
}

TEST_F(PressHeightMap, NothingIsSaidBeyondTheMap) {
  const PressScene s = scene({}, 0.5, "[profile]\ndistance = [0, 1.9e-3, 2.1e-3]\n");
  const Table table = surface_table(s, press(s));
  EXPECT_GT(table.rows[0][2], 0);
  EXPECT_EQ(table.rows[1][2], 0);
  EXPECT_EQ(table.rows[1][3], 0);
  EXPECT_TRUE(std::isnan(table.rows[2][2]) && std::isnan(table.rows[2][3]));
  EXPECT_THAT(to_csv(table, {}), HasSubstr("\n0.0020999999999999999,0,,\n"));
}

TEST_F(PressHeightMap, EveryCellOfTheTableHasItsError) {
  const PressScene s = scene({}, 0.5);
  const Table map = surface_table(s, press(s));
  const Hertz hertz(0.5, 20e-3);
  ASSERT_EQ(map.columns.back(), "pressure_error_Pa");
  for (const auto& row : map.rows) {
    EXPECT_LE(std::fabs(row[2] - hertz.pressure(std::hypot(row[0], row[1]))), row[3]) << row[0] << ' ' << row[1];
  }
}

TEST_F(PressHeightMap, AMapTooSmallForItsContactIsRefusedAtTheMap) {
  const PressScene s = scene({.x = 1e-3, .y = -0.4e-3}, 0.5);
  EXPECT_THAT([&] { press(s); },
              ::testing::ThrowsMessage<SceneError>(HasSubstr(
                  "height_map = \"cap.csv\": the map is too small for the contact: contact touches the border")));
}

TEST_F(PressHeightMap, ANegativePressureIsToldByItsLineAndColumn) {
  write("p.csv", "# a comment\n1,2,3\n4,-5,6\n");
  const std::string text =
      "[contact]\npatch = \"pressure_grid\"\npressures = \"p.csv\"\ncell = [1e-3, 1e-3]\nnormal_force = 1\n"
      "contact_modulus = 1e6\n";
  EXPECT_THAT([&] { press_scene_here(text); },
              ::testing::ThrowsMessage<SceneError>(HasSubstr("p.csv:3: column 2: a pressure of -5: must be >= 0")));
}

TEST(PressRoughSurface, APeakThatTheGridDoesNotResolveIsNotPrinted) {
  const Answer answer = press(committed("rough_surface")).answer;
  EXPECT_FALSE(has(answer.main, "peak_pressure"));
  EXPECT_THAT(answer.warnings, Contains(HasSubstr("no peak pressure")));
  EXPECT_THAT(answer.warnings, Each(Not(HasSubstr("peak pressure / E*"))));
  EXPECT_THAT(answer.warnings, Contains(HasSubstr("highest pressure of a cell / E* = ")));
}

}  // namespace
}  // namespace patchgrip::cli
