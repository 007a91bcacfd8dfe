#include <patchgrip/cli/scene/motion_reader.h>

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include <patchgrip/cli/scene/outline_reader.h>
#include <patchgrip/cli/scene/sequence_reader.h>

namespace patchgrip::cli {
namespace {

constexpr Quantity coordinate = any_sign("a coordinate in m");
constexpr Quantity angle = any_angle("an angle in rad");

std::vector<Direction> read_vectors(const TomlReader& table) {
  constexpr std::string_view allowed = "a vector [x, y], or several [[x, y], ...], none of them 0";
  const toml::node& value = table.node("direction");
  const toml::array& all = table.array(value, "direction", allowed);
  if (all.empty()) table.refuse("direction", allowed);
  const auto points = all.front().is_array() ? read_points(table, value, "direction")
                                             : std::vector{read_point(table, value, "direction")};
  std::vector<Direction> vectors;
  for (const auto& p : points) {
    if (p.x == 0 && p.y == 0) table.refuse("direction", allowed);
    vectors.push_back({p.x, p.y});
  }
  return vectors;
}

Directions read_directions(const TomlReader& table) {
  if (table.has("angle") == table.has("direction")) {
    table.refuse_table("needs either 'angle' (in rad against the x-axis) or 'direction' (a vector [x, y])");
  }
  if (table.has("angle")) return Directions(read_sequence(table, "angle", angle));
  return Directions(read_vectors(table));
}

PoleSet read_grid(const TomlReader& poles) {
  const TomlReader grid = poles.table("grid", {"x", "y"});
  return Grid{read_sequence(grid, "x", coordinate), read_sequence(grid, "y", coordinate)};
}

PoleSet read_ray(const TomlReader& poles) {
  const TomlReader ray = poles.table("ray", {"from", "angle", "direction", "distance"});
  const auto from = ray.has("from") ? read_point(ray, ray.node("from"), "from") : friction::Pole{};
  return Ray{from, read_directions(ray), read_sequence(ray, "distance", non_negative("a distance in m"))};
}

PoleSet read_list(const TomlReader& poles) {
  PoleList list{read_points(poles, poles.node("list"), "list")};
  if (list.poles.empty()) poles.refuse("list", "at least one point [x, y] in m");
  return list;
}

std::vector<int> read_spins(const TomlReader& poles) {
  constexpr std::string_view allowed = "1 (counterclockwise), -1 (clockwise) or both, [1, -1]";
  if (!poles.has("spin")) return {1};
  const toml::node& value = poles.node("spin");
  const auto one = [&](const toml::node& spin) {
    const auto* const whole = spin.as_integer();
    if (whole == nullptr || (whole->get() != 1 && whole->get() != -1)) poles.refuse("spin", allowed);
    return static_cast<int>(whole->get());
  };
  const auto* const both = value.as_array();
  if (both == nullptr) return {one(value)};
  if (both->empty() || both->size() > 2) poles.refuse("spin", allowed);
  std::vector<int> spins;
  for (const toml::node& spin : *both) spins.push_back(one(spin));
  if (spins.size() == 2 && spins[0] == spins[1]) poles.refuse("spin", allowed);
  return spins;
}

Sequence read_speeds(const TomlReader& poles, std::string_view key, std::string_view what) {
  return poles.has(key) ? read_sequence(poles, key, positive(what)) : Sequence::of_values({1});
}

void refuse_too_many(const TomlReader& poles, std::string_view key, double count, double& total) {
  total += count;
  if (total > most_motions) {
    poles.refuse(key, fmt::format("that makes {:.0f} rows, but a table may have at most {:.0f}", total, most_motions));
  }
}

}  // namespace

Motions read_motions(const TomlReader& scene) {
  constexpr std::string_view needs = "one or several of 'grid', 'ray', 'list' and 'translation'";
  if (!scene.has("poles")) scene.refuse("poles", fmt::format("a table [poles] with {}", needs));
  const TomlReader poles =
      scene.table("poles", {"grid", "ray", "list", "translation", "spin", "angular_speed", "speed"});

  Motions::Rotations rotations{{}, read_spins(poles), read_speeds(poles, "angular_speed", "an angular speed in rad/s")};
  const double passes =
      static_cast<double>(rotations.spins.size()) * static_cast<double>(rotations.angular_speeds.size());
  double total = 0;
  const auto add = [&](std::string_view key, PoleSet (*read)(const TomlReader&)) {
    if (!poles.has(key)) return;
    rotations.sets.push_back(read(poles));
    refuse_too_many(poles, key, passes * pole_count(rotations.sets.back()), total);
  };
  add("grid", read_grid);
  add("ray", read_ray);
  add("list", read_list);

  std::optional<Motions::Translations> translations;
  if (poles.has("translation")) {
    translations.emplace(Motions::Translations{read_directions(poles.table("translation", {"angle", "direction"})),
                                               read_speeds(poles, "speed", "a speed in m/s")});
    refuse_too_many(
        poles, "translation",
        static_cast<double>(translations->directions.size()) * static_cast<double>(translations->speeds.size()), total);
  } else if (poles.has("speed")) {
    poles.refuse("speed", "only used with 'translation'; rotations take 'angular_speed'");
  }

  if (rotations.sets.empty()) {
    if (!translations) poles.refuse_table(fmt::format("needs {}", needs));
    for (const auto* const key : {"spin", "angular_speed"}) {
      if (poles.has(key)) poles.refuse(key, "only used with 'grid', 'ray' or 'list'; translations take 'speed'");
    }
  }
  return {std::move(rotations), std::move(translations)};
}

}  // namespace patchgrip::cli
