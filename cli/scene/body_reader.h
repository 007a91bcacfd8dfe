// The two bodies of a contact: shape and material of each.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/shape.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/material.h>

namespace patchgrip::cli {

struct Body {
  Shape shape;
  contact::Material material;                             // elastic, or as it answers at once
  std::optional<contact::ViscoelasticMaterial> relaxing;  // where it creeps
  std::string words;
  Place place;  // its table
};

struct BodyPair {
  Body first, second;  // body A, body B
};

// Throws SceneError.
BodyPair read_two_bodies(const TomlReader& contact, std::string_view key, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
