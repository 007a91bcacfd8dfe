// The table [friction] of a scene: Coulomb or Stribeck, with or without a viscous part.
#pragma once

#include <string>

#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/friction/law.h>

namespace patchgrip::cli {

// All throw SceneError.
TomlReader friction_table(const TomlReader& scene);  // [friction], with all its keys
friction::Law read_friction(const TomlReader& scene);

// Whether Stribeck's law is taken at each point and not in the mean: 'stribeck'.
bool is_local_stribeck(const TomlReader& scene);

// The law as a formula, for the head of a table.
std::string in_words(const friction::Law& law, bool local);

}  // namespace patchgrip::cli
