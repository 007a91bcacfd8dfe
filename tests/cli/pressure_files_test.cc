// Files of a pressure that `limit` and `tabulate` read beside a scene: what they may hold, and what is told of them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include <patchgrip/cli/limit/limit.h>
#include <patchgrip/cli/limit/limit_scene.h>
#include <patchgrip/cli/press/run_press.h>
#include <patchgrip/cli/scene/csv_reader.h>
#include <patchgrip/cli/scene/scene_error.h>

#include "scenes.h"
#include "scratch_folder.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using test::with;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class PressureFile : public test::ScratchFolder {
 protected:
  LimitScene scene(const std::string& contact) const {
    const TomlDocument document = TomlDocument::parse("[contact]\n" + contact + "\nnormal_force = 1\n", path("s.toml"));
    return read_limit_scene(document, MaterialLibrary({test::data_folder / "materials"}));
  }

  std::string refusal(const std::string& contact) const {
    try {
      (void)scene(contact);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "accepted";
  }
};

const std::string over_mesh = "patch = \"pressure_mesh\"\nmesh = ";

// An octahedron: its upper half lies over its lower one.
TEST_F(PressureFile, FoldedMeshIsRefusedWithTheLinesOfTwoTriangles) {
  const std::string corners = "1 0 1\n-1 0 1\n0 1 1\n0 -1 1\n0 0 2\n0 0 0\n";
  const std::string upper = "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n", lower = "3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";
  write("closed.off", "OFF\n# both halves\n6 8 0\n" + corners + upper + lower);
  const std::string folded = refusal(over_mesh + "\"closed.off\"");
  EXPECT_THAT(folded, HasSubstr("s.toml:3: contact.mesh = \"closed.off\": triangle "));
  const auto pair_of = [](int k) {
    return HasSubstr(fmt::format("triangle {} (line {} of closed.off) with a corner in (", k, 10 + k));
  };
  EXPECT_THAT(folded, AnyOf(AllOf(pair_of(0), pair_of(4)), AllOf(pair_of(1), pair_of(5)), AllOf(pair_of(2), pair_of(6)),
                            AllOf(pair_of(3), pair_of(7))));
  EXPECT_THAT(folded, HasSubstr(" lie over each other: the pressure must be one number a point"));
  write("upper.off", "OFF\n6 4 0\n" + corners + upper);
  EXPECT_EQ(refusal(over_mesh + "\"upper.off\""), "accepted");
}

TEST_F(PressureFile, SecondSheetIsRefusedInStlToo) {
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    std::string text = "facet normal 0 0 0\nouter loop\n";
    for (const std::string& corner : {a, b, c}) text.append("vertex ").append(corner).append("\n");
    return text + "endloop\nendfacet\n";
  };
  const std::string first = facet("0 0 1", "1 0 1", "0 1 1");
  write("sheets.stl",
        "solid s\n" + first + facet("5 0 1", "6 0 1", "5 1 1") + facet("0.5 0 2", "1 0 2", "0.5 1 2") + "endsolid s\n");
  EXPECT_THAT(refusal(over_mesh + "\"sheets.stl\""),
              HasSubstr("triangle 0 (line 2 of sheets.stl) with a corner in (0, 0) and triangle 2 (line 16 of "));
}

class Numbers : public PressureFile {
 protected:
  NumberRows rows(const std::string& text, std::span<const std::string_view> names = {}) const {
    write("numbers.csv", text);
    const TomlDocument document = TomlDocument::parse("# a scene\nfile = \"numbers.csv\"\n", path("s.toml"));
    return read_numbers(TomlReader(document, document.root(), "", {"file"}), "file", names);
  }

  // What is said after the name of the file and before that of the scene.
  std::string refusal(const std::string& text, std::span<const std::string_view> names = {}) const {
    try {
      (void)rows(text, names);
    } catch (const SceneError& error) {
      const std::string words = error.what(), file = path("numbers.csv") + ":";
      const std::string scene = ", read for " + path("s.toml") + ":2: file = \"numbers.csv\"";
      if (words.starts_with(file) && words.ends_with(scene)) {
        return words.substr(file.size(), words.size() - file.size() - scene.size());
      }
      return words;
    }
    return "accepted";
  }
};

TEST_F(Numbers, StandBetweenComments) {
  const NumberRows read = rows("# x, y\n\n 1, 2.5 ,-3e-1\r\n4,5,6\n");
  ASSERT_EQ(read.rows(), 2U);
  EXPECT_EQ(read.columns, 3U);
  EXPECT_EQ(read[0][2], -0.3);
  EXPECT_EQ(read[1][0], 4);
  EXPECT_EQ(read.lines[1], 4U);
  EXPECT_FALSE(read.has_header);
}

TEST_F(Numbers, BeginAfterAByteOrderMark) {
  EXPECT_EQ(rows("\xEF\xBB\xBF"
                 "1, 2\n")[0][0],
            1);
}

TEST_F(Numbers, AreRefusedWithTheirLine) {
  EXPECT_EQ(refusal("1, 2\n3\n"), "2: 1 columns, but line 1 has 2");
  EXPECT_EQ(refusal("1, x\n"), "1: column 2: 'x' is not a finite number");
  EXPECT_EQ(refusal("1, nan\n"), "1: column 2: 'nan' is not a finite number");
  EXPECT_EQ(refusal("1,\n"), "1: column 2 is empty: a comma too many");
  EXPECT_EQ(refusal(",1\n"), "1: column 1 is empty");
  EXPECT_EQ(refusal("1,2\n3,\n"), "2: column 2 is empty");
  EXPECT_EQ(refusal("1;2;3\n"), "1: column 1: '1;2;3' is not a finite number; numbers are separated by commas");
  EXPECT_EQ(refusal("1 2\n"), "1: column 1: '1 2' is not a finite number; numbers are separated by commas");
  EXPECT_EQ(refusal("+-1\n"), "1: column 1: '+-1' is not a finite number");
  EXPECT_EQ(refusal("# nothing\n"), " has no numbers");
  EXPECT_EQ(refusal("x,y\n1,2\n"), "1: column 1: 'x' is not a finite number");
}

TEST_F(Numbers, AreTakenFromTheColumnsAskedFor) {
  constexpr std::array<std::string_view, 2> names{"p", "x"};
  const NumberRows read = rows("# a table\nx , y, p,word\n1,,3,a\n4,b,6,inf\n", names);
  EXPECT_TRUE(read.has_header);
  ASSERT_EQ(read.rows(), 2U);
  EXPECT_THAT(read.numbers, ElementsAre(3, 1, 6, 4));
  EXPECT_THAT(read.lines, ElementsAre(3, 4));
  EXPECT_THAT(rows("1,2,3\n", names).numbers, ElementsAre(1, 2, 3));
  EXPECT_EQ(refusal("x,y,z\n1,2,3\n", names), "1: no column is headed p: p, x are needed");
  EXPECT_EQ(refusal("x,p,x\n1,2,3\n", names), "1: more than one column is headed x");
  EXPECT_EQ(refusal("x,p\n1,\n", names), "2: column 2 is empty");
  EXPECT_EQ(refusal("X,P\n1,2\n", names), "1: no column is headed p: p, x are needed");
  EXPECT_EQ(refusal("x,p\n1\n", names), "2: 1 columns, but line 1 has 2");
  EXPECT_EQ(refusal("x,p\n", names), " has no numbers");
  EXPECT_EQ(refusal("nan,x\n", names), "1: column 1: 'nan' is not a finite number");
  EXPECT_EQ(refusal("x;p\n1;2\n", names), "1: column 1: 'x;p' is not a finite number; numbers are separated by commas");
  EXPECT_EQ(refusal("1;2\n", names), "1: column 1: '1;2' is not a finite number; numbers are separated by commas");
  EXPECT_EQ(refusal("\xff\xfe,p\n", names), "1: column 1: '\\xff\\xfe' is not a finite number");
  EXPECT_THAT(rows("\"x\",\"p\"\n+1,2\n", names).numbers, ElementsAre(2, 1));
}

const std::string over_grid = "patch = \"pressure_grid\"\npressures = \"p.csv\"\n";
const std::string over_points =
    "patch = \"pressure_points\"\npoints = \"p.csv\"\nvertices = [[0, 0], [2, 0], [2, 2], [0, 2]]\n";

TEST_F(PressureFile, TableOfAGridIsRefusedWhereItIsNone) {
  const auto refused = [&](const std::string& table, const std::string& keys = "") {
    write("p.csv", "x_m,y_m,pressure_Pa\n" + table);
    return refusal(over_grid + keys);
  };
  const std::string square = "0,0,1\n1,0,2\n0,1,3\n1,1,4\n";
  EXPECT_EQ(refused(square), "accepted");
  EXPECT_THAT(refused(square, "cell = [1, 1]\n"), HasSubstr("s.toml:4: contact.cell = [1, 1]: not used here"));
  EXPECT_THAT(refused(square + "1,0,2\n"), HasSubstr("p.csv:6: the cell of line 3 once more, read for "));
  EXPECT_THAT(refused(square + "2,0,2\n"), HasSubstr("\"p.csv\": no row for the cell at (2, 1) m"));
  EXPECT_THAT(refused(square + "3,0,1\n3,1,1\n"),
              HasSubstr("x_m of 0 and 1 follow each other where equal steps of 1.5"));
  EXPECT_THAT(refused("0,0,1\n1,0,1\n"), HasSubstr("all of y_m is 0: a line has no cells"));
  EXPECT_THAT(refused("0,0,1\n1,0,-1\n0,1,3\n1,1,4\n"),
              HasSubstr("p.csv:3: pressure_Pa = -1: must be >= 0, read for "));
  write("p.csv", "x_m,y_m,displacement_m\n" + square);
  EXPECT_THAT(refusal(over_grid), HasSubstr("p.csv:1: no column is headed pressure_Pa"));
  EXPECT_THAT(refusal(over_points + "unit = 1e-3\n"), HasSubstr("p.csv:1: no column is headed pressure_Pa"));
  write("p.csv", "x_m,y_m,pressure_Pa\n" + square);
  EXPECT_THAT(refusal(over_points + "unit = 1e-3\n"), HasSubstr("contact.unit = 1e-3: not used here"));
  EXPECT_EQ(refusal(over_points), "accepted");
  write("p.csv", "0,0,1\n0,nan,0\n");
  EXPECT_THAT(refusal(over_grid + "cell = [1, 1]\n"),
              HasSubstr("p.csv:2: column 2: 'nan' is not a finite number, read for " + path("s.toml") +
                        ":3: contact.pressures = \"p.csv\""));
}

// A paraboloid pressed on a plane: its table is the pressure that the bodies themselves have, and nearly that of Hertz,
// whose gauge of a moment is m / (3 pi a / 16).
TEST_F(PressureFile, TableOfPressIsReadByLimit) {
  constexpr int cells = 48;
  constexpr double step = 1e-4, radius = 0.02, modulus = 2e6 / 0.75, force = 0.5, moment = 1e-4;
  std::string heights;
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const double x = (i - 0.5 * (cells - 1)) * step, y = (j - 0.5 * (cells - 1)) * step;
      heights += fmt::format("{}{}", -(x * x + y * y) / (2 * radius), i + 1 < cells ? "," : "\n");
    }
  }
  write("cap.csv", heights);
  const std::string bodies = fmt::format(
      "[contact]\nnormal_force = {}\n[[contact.bodies]]\nheight_map = \"cap.csv\"\ncell = [{}, {}]\n"
      "youngs_modulus = 2e6\npoisson_ratio = 0.5\n[[contact.bodies]]\nplane = true\nrigid = true\n",
      force, step, step);
  write("bodies.toml", bodies);
  const MaterialLibrary materials({test::data_folder / "materials"});
  run_press({path("bodies.toml"), path("press.json"), path("p.csv")}, materials);

  const std::string load = fmt::format("[[loads]]\nmoment = {}\n", moment);
  const auto gauge = [&](const std::string& contact) {
    const TomlDocument document = TomlDocument::parse(contact + load, path("s.toml"));
    return answer_limit(read_limit_scene(document, materials)).loads.at(0).gauge.value;
  };
  const std::string given = fmt::format("[contact]\nnormal_force = {}\n", force);
  const double of_bodies = gauge(bodies);
  EXPECT_NEAR(gauge(given + over_grid), of_bodies, 1e-8 * of_bodies);
  const double a = std::cbrt(0.75 * force * radius / modulus);
  const double of_hertz = moment / (3 * std::numbers::pi / 16 * a);
  EXPECT_NEAR(of_bodies, of_hertz, 2e-3 * of_hertz);
  const double half = 0.5 * cells * step;
  const double between = gauge(given + with(over_points, "[[0, 0], [2, 0], [2, 2], [0, 2]]",
                                            fmt::format("[[-{0}, -{0}], [{0}, -{0}], [{0}, {0}], [-{0}, {0}]]", half)));
  EXPECT_NEAR(between, of_hertz, 1e-2 * of_hertz);
}

}  // namespace
}  // namespace patchgrip::cli
