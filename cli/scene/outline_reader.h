// Points and outlines in a scene: [x, y], sides [along x, along y], vertices and holes of a polygon.
#pragma once

#include <string_view>
#include <vector>

#include <patchgrip/cli/scene/toml_reader.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

constexpr std::size_t most_vertices = 100'000;  // of a polygon and its holes together

struct Outline {
  std::vector<friction::Point> outer;
  std::vector<std::vector<friction::Point>> holes;
};

struct Sides {
  double along_x;
  double along_y;
};

// All throw SceneError; `name` is what an error calls the value.
friction::Pole read_point(const TomlReader& table, const toml::node& value, std::string_view name);
std::vector<friction::Pole> read_points(const TomlReader& table, const toml::node& value, std::string_view name);
Sides read_sides(const TomlReader& table, std::string_view key);
Outline read_outline(const TomlReader& table, std::string_view vertices, std::string_view holes);

}  // namespace patchgrip::cli
