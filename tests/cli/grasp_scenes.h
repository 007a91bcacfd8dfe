// Scenes of `patchgrip grasp` as text.
#pragma once

#include <string>
#include <vector>

#include <patchgrip/cli/grasp/grasp_answer.h>
#include <patchgrip/cli/grasp/grasp_scene.h>

#include "scenes.h"

namespace patchgrip::cli::test {

inline const std::filesystem::path grasp_folder = data_folder / "scenes" / "grasp";

// The tweezers of the reference table, pub-006: 8.71523005126040164474450050996 N.
inline const std::string good_grasp = R"([[loads]]
force = [0, 0, -4.905]
at = [0, 0, 0]
moment = [0.01962, 0, 0]
[[contacts]]
position = [0.03, 0, 0]
normal = [1, 0, 0]
tangent = [0, 1, 0]
patch = "hertz_disc"
radius = 0.005
mu = 0.5
[[contacts]]
position = [-0.03, 0, 0]
normal = [-1, 0, 0]
tangent = [0, 1, 0]
model = "soft_elliptic"
moment_length = 0.003
mu = 0.5
)";

inline GraspScene grasp_scene(std::string text, std::string_view question = "") {
  return read_grasp_scene(TomlDocument::parse(std::move(text), (grasp_folder / "scene.toml").string()),
                          MaterialLibrary({data_folder / "materials"}), question);
}

inline GraspScene committed_grasp(const std::string& name) {
  return read_grasp_scene(TomlDocument::read(grasp_folder / (name + ".toml")),
                          MaterialLibrary({data_folder / "materials"}), "");
}

}  // namespace patchgrip::cli::test
