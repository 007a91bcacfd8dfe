// The table [poles] of a scene: which motions a table is asked for.
#pragma once

#include <patchgrip/cli/scene/motions.h>
#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

constexpr double most_motions = 1e8;

// Throws SceneError.
Motions read_motions(const TomlReader& scene);

}  // namespace patchgrip::cli
