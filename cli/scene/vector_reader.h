// Vectors and places in space, [x, y, z].
#pragma once

#include <array>
#include <string_view>

#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

using SpaceVector = std::array<double, 3>;

// `allowed` says what the three numbers are: "a force [x, y, z] in N". All throw SceneError.
SpaceVector read_vector(const TomlReader& table, std::string_view key, std::string_view allowed,
                        const Quantity& component);
SpaceVector read_direction(const TomlReader& table, std::string_view key, std::string_view allowed);  // not 0

}  // namespace patchgrip::cli
