// The table [contact] of a scene: a patch by its kind and size, or two bodies from which a round one follows.
#pragma once

#include <string>
#include <vector>

#include <patchgrip/cli/patch_variant.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

struct Contact {
  PatchVariant patch;
  friction::Pole centre;           // [m], where the patch has its own origin
  double normal_force;             // F_N [N], > 0
  double radius_error;             // relative, of a disc whose radius follows from bodies; else 0
  std::vector<std::string> notes;  // the contact in words, for the head of a table
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
