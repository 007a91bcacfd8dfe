// Materials by name: <name>.toml in one of several folders, each value with its source.
//
//     youngs_modulus = { value = 200e9, source = "..." }     E [Pa], 1e-60 to 1e60
//     poisson_ratio  = { value = 0.3, source = "..." }       nu [1], above -1 to 0.5
//
// Throws   SceneError naming the material file and line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/contact/material.h>

namespace patchgrip::cli {

constexpr Quantity youngs_modulus = positive("a Young's modulus in Pa");
constexpr Quantity poisson_ratio{"a Poisson ratio", -1, 0.5, false, false, true};

class MaterialLibrary {
 public:
  // The first folder that has a material wins; a folder need not exist.
  explicit MaterialLibrary(std::vector<std::filesystem::path> folders);

  // materials/ beside the scene or beside its folder, then those that come with the program.
  static MaterialLibrary for_scene(const std::filesystem::path& scene);

  std::optional<contact::Material> find(std::string_view name) const;
  std::vector<std::string> names() const;

 private:
  std::vector<std::filesystem::path> folders_;
};

// Folders of the installed program (../share/patchgrip/materials) and of the source tree around a build.
std::vector<std::filesystem::path> material_folders_of(const std::filesystem::path& program);

}  // namespace patchgrip::cli
