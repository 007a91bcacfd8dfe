// The table [contact] of a scene: a patch by its kind and size, or two bodies from which the Hertz circle follows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchgrip/cli/patch_variant.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

struct ComputedRadius {
  double radius;  // [m]
  double error;   // relative, against the exact radius for the given bodies
};

struct Contact {
  PatchVariant patch;
  friction::Pole centre;                // [m], where the patch has its own origin
  double normal_force;                  // F_N [N], > 0
  std::optional<ComputedRadius> hertz;  // of a Hertz disc that follows from bodies
  std::vector<std::string> notes;       // the contact in words, for the head of a table
};

struct DescribedPatch {
  PatchVariant patch;
  std::string words;
};

// All throw SceneError.
TomlReader contact_table(const TomlReader& scene);     // [contact], with all its keys
DescribedPatch read_patch(const TomlReader& contact);  // 'patch' and its sizes, without the force
Contact read_contact(const TomlReader& scene, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
