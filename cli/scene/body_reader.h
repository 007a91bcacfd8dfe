// The two bodies of a contact: shape (ball, hollow or plane) and material of each.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/contact/material.h>

namespace patchgrip::cli {

struct Body {
  double radius;  // [m]; +infinity for a plane, negative for a hollow
  contact::Material material;
  std::string words;
};

// Throws SceneError.
std::pair<Body, Body> read_two_bodies(const TomlReader& contact, std::string_view key,
                                      const MaterialLibrary& materials);

}  // namespace patchgrip::cli
