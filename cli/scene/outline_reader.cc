#include <patchgrip/cli/scene/outline_reader.h>

#include <fmt/format.h>

namespace patchgrip::cli {
namespace {

using friction::Point;
using friction::Pole;

std::vector<Point> read_ring(const TomlReader& table, const toml::node& value, std::string_view name,
                             std::size_t& vertices) {
  std::vector<Point> ring;
  for (const Pole& p : read_points(table, value, name)) ring.push_back({p.x, p.y});
  if (ring.size() < 3) table.refuse(value, name, "at least 3 points [x, y]");
  vertices += ring.size();
  if (vertices > most_vertices)
    table.refuse(value, name, fmt::format("at most {} vertices, those of holes included", most_vertices));
  return ring;
}

}  // namespace

Pole read_point(const TomlReader& table, const toml::node& value, std::string_view name) {
  constexpr std::string_view allowed = "a point [x, y] in m";
  const toml::array& xy = table.array(value, name, allowed);
  if (xy.size() != 2) table.refuse(value, name, allowed);
  constexpr Quantity coordinate = any_sign("a coordinate in m");
  return {table.number(xy[0], name, coordinate), table.number(xy[1], name, coordinate)};
}

std::vector<Pole> read_points(const TomlReader& table, const toml::node& value, std::string_view name) {
  std::vector<Pole> points;
  for (const toml::node& point : table.array(value, name, "points [[x, y], ...] in m")) {
    points.push_back(read_point(table, point, fmt::format("{}[{}]", name, points.size())));
  }
  return points;
}

Sides read_sides(const TomlReader& table, std::string_view key) {
  constexpr std::string_view allowed = "two lengths in m, along x and along y";
  if (!table.has(key)) table.refuse(key, allowed);
  const toml::array& sides = table.array(table.node(key), key, allowed);
  if (sides.size() != 2) table.refuse(key, allowed);
  constexpr Quantity length = positive("a length in m");
  return {table.number(sides[0], key, length), table.number(sides[1], key, length)};
}

Outline read_outline(const TomlReader& table, std::string_view vertices, std::string_view holes) {
  Outline outline;
  std::size_t count = 0;
  if (!table.has(vertices)) table.refuse(vertices, "points [[x, y], ...] in m");
  outline.outer = read_ring(table, table.node(vertices), vertices, count);
  if (!table.has(holes)) return outline;
  for (const toml::node& hole : table.array(table.node(holes), holes, "outlines [[[x, y], ...], ...] in m")) {
    outline.holes.push_back(read_ring(table, hole, fmt::format("{}[{}]", holes, outline.holes.size()), count));
  }
  return outline;
}

}  // namespace patchgrip::cli
