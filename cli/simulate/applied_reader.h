// The tables [[applied]] and [normal_force] of a scene: loads, and a factor over time.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/cli/simulate/applied.h>

namespace patchgrip::cli {

constexpr std::array<std::string_view, 4> courses{"during", "ramp", "sine", "course"};

// What the factor of a course may be, and the mean and frequency of a sine.
struct Factor {
  Quantity value, mean, angular_frequency;
};

// Both throw SceneError.
Course read_course(const TomlReader& load, const Factor& factor);
std::vector<Applied> read_applied(const TomlReader& scene, bool point, const Quantity& angular_frequency);

}  // namespace patchgrip::cli
