// Every number of every scene of limit, far off: it is answered, or refused with file, line and key.
#include <patchgrip/cli/limit/run_limit.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "far_off.h"
#include "limit_scenes.h"

namespace patchgrip::cli {
namespace {

namespace fs = std::filesystem;
using namespace test;

// Few loads and a wide net: the numbers count here.
std::string coarse(std::string text) {
  text = std::regex_replace(text, std::regex("count = [0-9]+"), "count = 3");
  const std::string surface = "[surface]\n", net = "meridians = 8\nparallels = 6\n";
  return text.find(surface) != std::string::npos ? with(text, surface, surface + net) : text + surface + net;
}

class FarOffLimit : public ::testing::TestWithParam<std::string> {};

TEST_P(FarOffLimit, IsAnsweredOrRefusedAtItsPlace) {
  const MaterialLibrary materials({data_folder / "materials"});
  const std::string original = coarse(text_of(limit_folder / (GetParam() + ".toml")));
  expect_far_off_numbers_answered_or_refused(
      "limit/" + GetParam(), original, std::max(1, 55 / testing::cases(10)), "contact|friction|loads|surface",
      [&](const std::string& scene, const fs::path& folder) {
        run_limit({scene, (folder / "answer.json").string(), (folder / "table.csv").string(),
                   (folder / "surface.vtk").string(), (folder / "picture.svg").string()},
                  materials);
      });
}

INSTANTIATE_TEST_SUITE_P(Limit, FarOffLimit, ::testing::ValuesIn(committed_limit_scenes()),
                         [](const auto& given) { return given.param; });

}  // namespace
}  // namespace patchgrip::cli
