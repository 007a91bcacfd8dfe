// Patches of a measured or computed pressure, from a file beside the scene: over a grid, over a mesh, at points.
#pragma once

#include <patchgrip/cli/scene/patch_reader.h>
#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

// All throw SceneError.
DescribedPatch read_pressure_grid(const TomlReader& table);
DescribedPatch read_pressure_mesh(const TomlReader& table);
DescribedPatch read_pressure_points(const TomlReader& table);

}  // namespace patchgrip::cli
