// A scene: what a file describes and what is asked of it. The format, key by key, is in data/scenes/README.md.
#pragma once

#include <filesystem>
#include <string>

#include <patchgrip/cli/scene/contact_reader.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/motions.h>
#include <patchgrip/friction/law.h>

namespace patchgrip::cli {

struct Scene {
  std::string title;
  Contact contact;
  friction::Law law;
  Motions motions;
  bool local = false;  // Stribeck's law at each point, not in the mean
};

// The whole file, with the tables of every question.
TomlReader scene_table(const TomlDocument& document);

// Both throw SceneError and nothing else for any content, std::bad_alloc excepted.
Scene load_scene(const std::filesystem::path& file);
Scene read_scene(const TomlDocument& document, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
