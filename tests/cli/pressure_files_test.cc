// Files of a pressure that `limit` and `tabulate` read beside a scene: what they may hold, and what is told of them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <patchgrip/cli/limit/limit_scene.h>
#include <patchgrip/cli/scene/scene_error.h>

#include "scenes.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;

class PressureFile : public ::testing::Test {
 protected:
  PressureFile() : folder_(fs::path(::testing::TempDir()) / ("pressure_files_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~PressureFile() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  void put(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

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

  fs::path folder_;
};

const std::string over_mesh = "patch = \"pressure_mesh\"\nmesh = ";

// An octahedron: its upper half lies over its lower one.
TEST_F(PressureFile, FoldedMeshIsRefusedWithTheLinesOfTwoTriangles) {
  const std::string corners = "1 0 1\n-1 0 1\n0 1 1\n0 -1 1\n0 0 2\n0 0 0\n";
  const std::string upper = "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n", lower = "3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";
  put("closed.off", "OFF\n# both halves\n6 8 0\n" + corners + upper + lower);
  const std::string folded = refusal(over_mesh + "\"closed.off\"");
  EXPECT_THAT(folded, HasSubstr("s.toml:3: contact.mesh = \"closed.off\": triangle "));
  const auto pair_of = [](int k) {
    return HasSubstr(fmt::format("triangle {} (line {} of closed.off) with a corner in (", k, 10 + k));
  };
  EXPECT_THAT(folded, AnyOf(AllOf(pair_of(0), pair_of(4)), AllOf(pair_of(1), pair_of(5)), AllOf(pair_of(2), pair_of(6)),
                            AllOf(pair_of(3), pair_of(7))));
  EXPECT_THAT(folded, HasSubstr(" lie over each other: the pressure must be one number a point"));
  put("upper.off", "OFF\n6 4 0\n" + corners + upper);
  EXPECT_EQ(refusal(over_mesh + "\"upper.off\""), "accepted");
}

TEST_F(PressureFile, SecondSheetIsRefusedInStlToo) {
  const auto facet = [](const std::string& a, const std::string& b, const std::string& c) {
    std::string text = "facet normal 0 0 0\nouter loop\n";
    for (const std::string& corner : {a, b, c}) text.append("vertex ").append(corner).append("\n");
    return text + "endloop\nendfacet\n";
  };
  const std::string first = facet("0 0 1", "1 0 1", "0 1 1");
  put("sheets.stl",
      "solid s\n" + first + facet("5 0 1", "6 0 1", "5 1 1") + facet("0.5 0 2", "1 0 2", "0.5 1 2") + "endsolid s\n");
  EXPECT_THAT(refusal(over_mesh + "\"sheets.stl\""),
              HasSubstr("triangle 0 (line 2 of sheets.stl) with a corner in (0, 0) and triangle 2 (line 16 of "));
}

}  // namespace
}  // namespace patchgrip::cli
