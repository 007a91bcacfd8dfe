// The table [contact] of a scene: a patch by its kind and size, several parts, or two bodies from which a patch
// follows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <patchgrip/cli/input_error.h>
#include <patchgrip/cli/patch_variant.h>
#include <patchgrip/cli/scene/materials.h>
#include <patchgrip/cli/scene/patch_reader.h>
#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/placed.h>

namespace patchgrip::cli {

struct Contact {
  PatchVariant patch;
  friction::PlanarFrame frame;         // where the patch has its own axes
  double normal_force;                 // F_N [N], > 0
  double sum_error = 0;                // relative, of normal_force and resistance where they are sums over parts
  double radius_error = 0;             // relative, of a disc whose radius follows from bodies; else 0
  double shape_error = 0;              // of any patch that follows from bodies (rubbed_bodies.h)
  double extent = 0;                   // of that patch: its greatest distance from the centre [m]
  std::optional<double> resistance{};  // sum of mu_i F_i [N], where parts have their own mu
  std::optional<friction::AnyPatch>
      coarse{};                            // the same on half as many cells, where the pressure is computed on a grid
  std::optional<RadiusScatter> scatter{};  // of a fitted radius, in place of radius_error and shape_error
  std::optional<double> growth{0};         // e: with its force the patch grows as F_N^e, alike; none: by another law
  std::vector<std::string> notes{};        // the contact in words, for the head of a table
  std::vector<std::string> warnings{};     // what its patch leaves out
};

// All throw SceneError.
TomlReader contact_table(const TomlReader& scene);  // [contact], with all its keys
// What follows from bodies, or of a fingertip, is pressed `factor` times as hard as the scene says.
Contact read_contact(const TomlReader& scene, const MaterialLibrary& materials, double factor = 1);

// Its patch in the contact frame.
friction::AnyPatch any_patch(const Contact& contact);

}  // namespace patchgrip::cli
