// data/scenes/README.md names all that `patchgrip press` can say: results, laws and columns.
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include <patchgrip/cli/press/press_height_map.h>
#include <patchgrip/cli/press/pressed.h>

#include "press_scenes.h"

namespace patchgrip::cli {
namespace {

using namespace test;

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string section(const std::string& text, const std::string& heading) {
  const std::size_t begin = text.find("\n## " + heading + "\n");
  if (begin == std::string::npos) throw std::logic_error("no section " + heading);
  return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

class PressReadme : public ::testing::Test {
 protected:
  void expect(const std::string& name, const std::string& from) const {
    EXPECT_NE(text_.find("`" + name + "`"), std::string::npos) << name << " of " << from;
  }
  void expect(const LawAnswer& law, const std::string& from) const {
    expect(law.law, from);
    for (const Result& r : law.results) expect(r.name, from);
  }

  // The line that describes the table of a scene.
  std::string row_of(const PressScene& scene) const {
    const auto* pair = std::get_if<BodyPair>(&scene.subject);
    const bool over_time = std::holds_alternative<TimedLoad>(scene.load);
    const std::string heading = over_time && scene.profile.times ? "the surface over time"
                                : over_time                      ? "over time, with"
                                : pair != nullptr && height_map_of(*pair) != nullptr && !scene.profile.distance
                                    ? "the map of a height map"
                                    : "the surface along a line";
    const std::size_t begin = text_.find("\n| " + heading);
    if (begin == std::string::npos) throw std::logic_error("no row " + heading);
    return text_.substr(begin, text_.find('\n', begin + 1) - begin);
  }

  const std::string text_ = section(content(data_folder / "scenes" / "README.md"), "The answer of `press`");
};

TEST_F(PressReadme, KnowsTheAnswersOfEveryScene) {
  for (const std::string& name : committed_scenes()) {
    const PressScene scene = committed(name);
    const auto [answer, table] = answered(scene);
    expect(answer.main, name);
    for (const LawAnswer& law : answer.beside) expect(law, name);
    if (scene.sweep) continue;
    const std::string row = row_of(scene);
    for (const std::string& column : table.columns) {
      if (std::regex_match(column, std::regex("pressure_sphere\\w*_Pa"))) continue;  // of a law beside
      const std::string quantity = std::regex_replace(column, std::regex("_error"), "");
      EXPECT_NE(row.find("`" + quantity + "`"), std::string::npos) << column << " of " << name;
      if (quantity != column) {
        EXPECT_NE(row.find("error"), std::string::npos) << column << " of " << name;
      }
    }
  }
}

// "name", at the beginning of a result or of an answer.
TEST_F(PressReadme, KnowsTheNamesInTheSources) {
  const std::filesystem::path sources = data_folder.parent_path() / "cli";
  std::set<std::filesystem::path> files{sources / "scene" / "profile_of.h"};
  for (const auto& entry : std::filesystem::directory_iterator(sources / "press")) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("press_") && name.ends_with(".cc") && name != "press_scene.cc" && name != "press_tables.cc") {
      files.insert(entry.path());
    }
  }
  const std::regex first("[({]\\s*\"([a-z]\\w*)\",");
  int found = 0;
  for (const auto& file : files) {
    const std::string code = content(file);
    for (std::sregex_iterator match(code.begin(), code.end(), first), end; match != end; ++match, ++found) {
      expect((*match)[1], file.filename().string());
    }
  }
  EXPECT_GT(found, 100);
  for (const char* state : {"pull_off", "pull_off_held", "jump_in", "no_load"}) {
    for (const char* quantity : {"_force", "_radius", "_approach"}) expect(std::string(state) + quantity, "a state");
  }
}

}  // namespace
}  // namespace patchgrip::cli
