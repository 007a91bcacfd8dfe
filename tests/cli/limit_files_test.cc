// The limit surface in the files that `patchgrip limit` leaves: what they hold, and what they hold when it fails.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/limit/limit_mesh.h>
#include <patchgrip/cli/limit/run_limit.h>
#include <patchgrip/cli/limit/surface_files.h>
#include <patchgrip/cli/limit/surface_picture.h>
#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>

#include "limit_scenes.h"
#include "scratch_folder.h"
#include "vtk_file.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

using friction::AnyPatch;
using friction::Twist;
using friction::Wrench;
using test::VtkFile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string content(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Comments, one line of names, rows of as many numbers.
struct CsvFile {
  explicit CsvFile(const fs::path& path) {
    std::ifstream in(path);
    std::string line, cell;
    while (std::getline(in, line)) {
      if (line.starts_with('#')) {
        EXPECT_TRUE(columns.empty()) << "a comment among the rows: " << line;
        head += line + "\n";
        continue;
      }
      std::vector<std::string> cells;
      for (std::istringstream row(line); std::getline(row, cell, ',');) cells.push_back(cell);
      if (columns.empty()) {
        columns = cells;
        continue;
      }
      EXPECT_EQ(cells.size(), columns.size()) << line;
      std::map<std::string, double> row;
      for (std::size_t i = 0; i < std::min(cells.size(), columns.size()); ++i) {
        std::size_t read = 0;
        row[columns[i]] = std::stod(cells[i], &read);
        EXPECT_EQ(read, cells[i].size()) << cells[i];
      }
      rows.push_back(row);
    }
  }

  std::string head;
  std::vector<std::string> columns;
  std::vector<std::map<std::string, double>> rows;
};

class LimitFolder : public test::ScratchFolder {
 protected:
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.insert(entry.path().filename());
    return all;
  }

  void run(const std::string& scene, const std::string& surface, const std::string& picture = "") const {
    const auto given = [&](const std::string& name) { return name.empty() ? "" : path(name); };
    run_limit({scene, path("answer.json"), "", given(surface), given(picture)},
              MaterialLibrary({test::data_folder / "materials"}));
  }

  void run_text(const std::string& text, const std::string& surface, const std::string& picture = "") const {
    write("scene.toml", text);
    run(path("scene.toml"), surface, picture);
  }
};

struct Known {
  std::string name, contact;
  std::function<AnyPatch()> patch;

  friend std::ostream& operator<<(std::ostream& out, const Known& known) { return out << known.name; }
};

AnyPatch two_discs() {
  const friction::UniformDisc disc = friction::UniformDisc::of_radius(0.002);
  return friction::Several::of_parts(
      {{friction::Placed(disc, {-0.01, 0, 0}), 3}, {friction::Placed(disc, {0.02, 0.005, 0}), 1}});
}

const std::vector<Known> known{
    {"HertzEllipse", "patch = \"hertz_ellipse\"\nsemi_axes = [0.003, 0.001]\nnormal_force = 4",
     [] { return friction::HertzEllipse::of_semi_axes(0.003, 0.001); }},
    {"TurnedRectangle",
     "patch = \"rectangle\"\nsides = [0.02, 0.01]\nangle = 0.3\ncentre = [0.001, -0.002]\nnormal_force = 4",
     [] {
       return friction::Placed(friction::Rectangle::of_sides(0.02, 0.01), {0.001, -0.002, 0.3});
     }},
    {"Triangle", "patch = \"polygon\"\nvertices = [[0, 0], [0.03, 0], [0, 0.02]]\nnormal_force = 4",
     [] {
       return friction::Polygon::uniform({{0, 0}, {0.03, 0}, {0, 0.02}});
     }},
    {"Line", "patch = \"line\"\nlength = 0.2\nnormal_force = 4", [] { return friction::LineLoad::of_length(0.2); }},
    {"TwoDiscs",
     "[[contact.parts]]\npatch = \"uniform_disc\"\nradius = 0.002\ncentre = [-0.01, 0]\nnormal_force = 3\n"
     "[[contact.parts]]\npatch = \"uniform_disc\"\nradius = 0.002\ncentre = [0.02, 0.005]\nnormal_force = 1",
     two_discs},
};

class KnownSurface : public LimitFolder, public ::testing::WithParamInterface<Known> {};

// R = mu F_N = 0.5 x 4 N. The program places every patch, so that one more rounding of its velocity is allowed: what it
// does to force and moment is in the errors stated, beside the library's own.
TEST_P(KnownSurface, HoldsTheNumbersOfTheLibrary) {
  run_text("[contact]\n" + GetParam().contact + "\n[friction]\nmu = 0.5\n[surface]\nmeridians = 24\nparallels = 16\n",
           "surface.csv");
  const CsvFile file(path("surface.csv"));
  EXPECT_THAT(file.columns, ElementsAre("force_x_N", "force_y_N", "moment_Nm", "force_error_N", "moment_error_Nm",
                                        "pole_x_m", "pole_y_m", "vx_m_per_s", "vy_m_per_s", "w_rad_per_s"));
  EXPECT_THAT(file.head, HasSubstr("\n# net: meridians 24, parallels 16\n"));
  ASSERT_EQ(file.rows.size(), 15U * 24 + 2);
  const AnyPatch patch = GetParam().patch();
  const friction::LimitSurface surface(patch);
  for (auto row : file.rows) {
    const Twist v{row["vx_m_per_s"], row["vy_m_per_s"], row["w_rad_per_s"]};
    const Wrench t{row["force_x_N"], row["force_y_N"], row["moment_Nm"]};
    const friction::BoundedWrench g = patch.bounded_gradient(v);
    EXPECT_LE(std::hypot(t.fx - 2 * g.value.fx, t.fy - 2 * g.value.fy), row["force_error_N"] + 2 * g.force_error);
    EXPECT_LE(std::fabs(t.m - 2 * g.value.m), row["moment_error_Nm"] + 2 * g.moment_error);
    EXPECT_LE(row["force_error_N"], 1e-12);
    EXPECT_LE(row["moment_error_Nm"], 1e-13);
    EXPECT_NEAR(surface.gauge(t).value, 2, 1e-11);
    if (v.w != 0) {
      EXPECT_EQ(row["pole_x_m"], -v.vy / v.w);
      EXPECT_EQ(row["pole_y_m"], v.vx / v.w);
    } else {
      EXPECT_TRUE(std::isinf(row["pole_x_m"]) || std::isinf(row["pole_y_m"]));
      EXPECT_EQ(std::isinf(row["pole_x_m"]), std::fabs(v.vy) > 1e-15);
      EXPECT_EQ(std::isinf(row["pole_y_m"]), std::fabs(v.vx) > 1e-15);
      EXPECT_NEAR(std::hypot(t.fx, t.fy), 2, 1e-14);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(LimitFiles, KnownSurface, ::testing::ValuesIn(known),
                         [](const auto& given) { return given.param.name; });

// (3 pi / 16) mu F_N a in pure rotation, mu F_N in translation.
TEST_F(LimitFolder, CornersOfTheHertzDiscAreThoseOfTheory) {
  run_text(test::good_limit, "surface.csv");
  const CsvFile file(path("surface.csv"));
  const double greatest = 3 * std::numbers::pi / 16 * 5 * 0.005;
  EXPECT_NEAR(file.rows.front().at("moment_Nm"), greatest, 1e-16);
  EXPECT_NEAR(file.rows.back().at("moment_Nm"), -greatest, 1e-16);
  const auto by_force = [](const auto& row) { return std::hypot(row.at("force_x_N"), row.at("force_y_N")); };
  EXPECT_NEAR(by_force(*std::ranges::max_element(file.rows, {}, by_force)), 5, 1e-14);
}

TEST_F(LimitFolder, WithoutFrictionTheSurfaceIsPerMuF) {
  run_text(test::with(test::with(test::good_limit, "[friction]\nmu = 0.5\n", ""), "moment = 0.002\n", ""),
           "surface.csv");
  const CsvFile file(path("surface.csv"));
  EXPECT_EQ(file.columns.front(), "force_x");
  EXPECT_NEAR(file.rows.front().at("moment_m"), 3 * std::numbers::pi / 16 * 0.005, 1e-18);
}

class CommittedSurface : public LimitFolder, public ::testing::WithParamInterface<std::string> {};

double length_of(const std::string& title) {
  const std::size_t at = title.find("with L = ");
  return at == std::string::npos ? 0 : std::stod(title.substr(at + 9));
}

TEST_P(CommittedSurface, VtkAndCsvAreOneClosedSurface) {
  const std::string scene = (test::limit_folder / (GetParam() + ".toml")).string();
  run(scene, "surface.csv");
  run(scene, "surface.vtk");
  const CsvFile csv(path("surface.csv"));
  const VtkFile vtk = VtkFile::parse(content(path("surface.vtk")));
  const double length = length_of(vtk.title);
  ASSERT_GT(length, 0) << vtk.title;
  ASSERT_EQ(vtk.points.size(), csv.rows.size());
  for (std::size_t i = 0; i < csv.rows.size(); ++i) {
    const auto value = [&](std::size_t column) { return csv.rows[i].at(csv.columns[column]); };
    EXPECT_THAT(vtk.points[i], ElementsAre(value(0), value(1), value(2) / length + 0.0)) << i;
    EXPECT_THAT(vtk.slips[i], ElementsAre(value(7), value(8), value(9))) << i;
    const auto& n = vtk.normals[i];
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-15) << i;
    EXPECT_TRUE(vtk.shares[i] >= 0 && vtk.shares[i] <= 1) << vtk.shares[i];
  }
  // Every edge is in two polygons, once in each direction; no corner is beyond the points, none twice in a polygon.
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const auto& polygon : vtk.polygons) {
    ASSERT_TRUE(polygon.size() == 3 || polygon.size() == 4);
    EXPECT_EQ(std::set(polygon.begin(), polygon.end()).size(), polygon.size());
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      ASSERT_LT(polygon[k], vtk.points.size());
      ++edges[{polygon[k], polygon[(k + 1) % polygon.size()]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  EXPECT_EQ(vtk.polygons.size() + vtk.points.size() - edges.size() / 2, 2U);
}

INSTANTIATE_TEST_SUITE_P(LimitFiles, CommittedSurface,
                         ::testing::Values("figure_4_24", "hertz_ellipse", "l_shape", "pressure_mesh", "rubber_ball",
                                           "skate", "two_patches", "two_points"),
                         [](const auto& given) { return given.param; });

// Old files stay as they were and no temporary is left.
class Failure : public LimitFolder {
 protected:
  Failure() {
    for (const auto* const file : {"answer.json", "surface.csv", "surface.vtk"}) write(file, "old");
  }

  void expect_old() const {
    for (const auto* const file : {"answer.json", "surface.csv", "surface.vtk"}) EXPECT_EQ(content(path(file)), "old");
    std::set<std::string> rest = names();
    for (const auto* const mine : {"answer.json", "picture.svg", "scene.toml", "surface.csv", "surface.vtk"})
      rest.erase(mine);
    EXPECT_THAT(rest, ::testing::IsEmpty());
  }
};

TEST_F(Failure, OfThePictureLeavesTheSurfaceAsItWas) {
  fs::create_symlink("/dev/full", path("picture.svg"));
  for (const auto* const surface : {"surface.csv", "surface.vtk"}) {
    EXPECT_THROW(run_text(test::good_limit, surface, "picture.svg"), OutputError) << surface;
    expect_old();
  }
}

TEST_F(Failure, OfTheSurfaceItselfNamesTheFile) {
  fs::remove(path("surface.vtk"));
  fs::create_symlink("/dev/full", path("surface.vtk"));
  try {
    run_text(test::good_limit, "surface.vtk");
    ADD_FAILURE() << "written to a full disk";
  } catch (const OutputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("surface.vtk"));
    EXPECT_THAT(error.what(), HasSubstr("No space left"));
  }
  EXPECT_EQ(content(path("answer.json")), "old");
}

TEST_F(Failure, OfASceneWithoutFriction) {
  try {
    run_text(test::with(test::good_limit, "mu = 0.5", "mu = 0"), "surface.csv");
    ADD_FAILURE() << "a point was written";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr("scene.toml:5: friction"));
    EXPECT_THAT(error.what(), HasSubstr("without friction the limit surface is a point"));
  }
  expect_old();
}

TEST_F(Failure, ByASignalWhileTheSurfaceIsMade) {
  const InterruptGuard guard;
  std::thread alarm([] {
    std::this_thread::sleep_for(200ms);
    ::kill(::getpid(), SIGTERM);
  });
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THROW(run_text(test::good_limit + "[surface]\nmeridians = 4000\nparallels = 4000\n", "surface.vtk"),
               Interrupted);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 5s);
  alarm.join();
  expect_old();
}

TEST_F(Failure, EveryStageListensToSignals) {
  const LimitScene scene = test::limit_scene(test::good_limit);
  const auto mesh = [&] { return mesh_of(scene.contact, {5, 0}, 0.003, 24, 16); };
  const LimitMesh made = mesh();
  const Table rows = surface_rows(made, false);
  const InterruptGuard guard;
  std::raise(SIGINT);
  EXPECT_THROW(mesh(), Interrupted);
  EXPECT_THROW(to_vtk(made, ""), Interrupted);
  EXPECT_THROW(surface_rows(made, false), Interrupted);
  EXPECT_THROW(to_csv(rows, {}), Interrupted);
  EXPECT_THROW(picture_of(made, {"", 0, 0, 5, {}}), Interrupted);
}

}  // namespace
}  // namespace patchgrip::cli
