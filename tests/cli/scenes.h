// Scenes as text, for the tests of the program.
#pragma once

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/scene.h>

namespace patchgrip::cli::test {

inline const std::filesystem::path data_folder = PATCHGRIP_DATA_DIR;

// Names of the scenes in a folder.
inline std::vector<std::string> scenes_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

inline const std::string good_disc = R"([contact]
patch = "hertz_disc"
radius = 0.005
normal_force = 10
[friction]
mu = 0.5
[poles]
list = [[0.001, 0.002], [0, 0]]
)";

inline const std::string good_bodies = R"([contact]
normal_force = 5.0
[[contact.bodies]]
radius = 0.01
material = "rubber"
[[contact.bodies]]
plane = true
material = "glass"
[friction]
mu = 0.8
[poles]
list = [[0.001, 0.002]]
)";

inline const std::string good_polygon = R"([contact]
patch = "polygon"
vertices = [[0, 0], [3, 0], [3, 3], [0, 3]]
holes = [[[1, 1], [2, 1], [2, 2]]]
normal_force = 1
[friction]
mu = 0.5
[poles]
grid = { x = [0, 1], y = { from = -1, to = 1, count = 3 } }
)";

// `text` with the first `from` replaced; tests fail loudly when it is not there.
inline std::string with(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("no such text: " + std::string(from));
  return text.replace(at, from.size(), to);
}

inline Scene scene_of(std::string text) {
  const TomlDocument document = TomlDocument::parse(std::move(text), "scene.toml");
  return read_scene(document, MaterialLibrary({data_folder / "materials"}));
}

}  // namespace patchgrip::cli::test
