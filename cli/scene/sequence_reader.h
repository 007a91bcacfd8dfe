// A sequence of numbers in a scene, wherever several values may stand:
//
//     0.01                                                       one value
//     [0, 0.01, 0.05]                                            a list
//     { from = 0, to = 0.05, count = 101 }                       a range with equal steps
//     { from = 1e-4, to = 1, count = 101, spacing = "log" }      a range with equal ratios
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <patchgrip/cli/scene/sequence.h>
#include <patchgrip/cli/scene/toml_reader.h>

namespace patchgrip::cli {

// Every value lies in the range of `quantity`. Throws SceneError.
Sequence read_sequence(const TomlReader& table, std::string_view key, const Quantity& quantity);

// Points [[t, value], ...], at least one. Throws SceneError.
std::vector<std::array<double, 2>> read_pairs(const TomlReader& table, std::string_view key, std::string_view allowed,
                                              const Quantity& first, const Quantity& second);

}  // namespace patchgrip::cli
