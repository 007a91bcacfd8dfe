#include <patchgrip/cli/scene/patch_reader.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/outline_reader.h>
#include <patchgrip/cli/scene/pressure_reader.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/point_load.h>

namespace patchgrip::cli {
namespace {

using friction::AnyPatch;

constexpr Quantity radius_range = positive("a radius in m");
constexpr Quantity exponent_range{"the exponent n of (1 - r^2/a^2)^(n - 1/2)", -0.5, 20, false, false, true};

template <class Disc>
DescribedPatch read_disc(const TomlReader& table, std::string_view words) {
  const double radius = table.number("radius", radius_range);
  return {Disc::of_radius(radius), fmt::format("{}, radius {} m", words, radius)};
}

DescribedPatch read_hertz_disc(const TomlReader& table) {
  return hertz_disc(table, table.number("radius", radius_range));
}

DescribedPatch read_flat_punch(const TomlReader& table) {
  return read_disc<friction::FlatPunchDisc>(table, "disc under a flat punch");
}

DescribedPatch read_uniform(const TomlReader& table) { return read_disc<friction::UniformDisc>(table, "uniform disc"); }

DescribedPatch read_ring(const TomlReader& table) { return read_disc<friction::Ring>(table, "thin ring"); }

DescribedPatch read_power_disc(const TomlReader& table) {
  const double radius = table.number("radius", radius_range);
  const double exponent = table.number("exponent", exponent_range);
  return {made(table, "exponent", [&] { return friction::PowerDisc::of_radius(radius, exponent); }),
          fmt::format("disc with p ~ (1 - r^2/a^2)^(n - 1/2), n = {}, radius {} m", exponent, radius)};
}

DescribedPatch read_xydas_kao(const TomlReader& table) {
  const double radius = table.number("radius", radius_range);
  const double alpha = table.number("alpha", alpha_range);
  return {made(table, "alpha", [&] { return friction::XydasKaoDisc::of_radius(radius, alpha); }),
          fmt::format("disc with the pressure of Xydas and Kao, alpha = {}, radius {} m", alpha, radius)};
}

DescribedPatch read_rectangle(const TomlReader& table) {
  const auto [along_x, along_y] = read_sides(table, "sides");
  return {made(table, "sides", [&, x = along_x, y = along_y] { return friction::Rectangle::of_sides(x, y); }),
          fmt::format("uniform rectangle, sides {} m along x and {} m along y", along_x, along_y)};
}

DescribedPatch read_polygon(const TomlReader& table) {
  auto outline = read_outline(table, "vertices", "holes");
  std::string words =
      fmt::format("uniform polygon, outer vertices {}, holes {}", outline.outer.size(), outline.holes.size());
  return {made(table, "vertices",
               [&] { return friction::Polygon::uniform(std::move(outline.outer), std::move(outline.holes)); }),
          std::move(words)};
}

DescribedPatch read_hertz_ellipse(const TomlReader& table) {
  const auto [along_x, along_y] = read_sides(table, "semi_axes");
  return {made(table, "semi_axes",
               [&, a = along_x, b = along_y] { return AnyPatch(friction::HertzEllipse::of_semi_axes(a, b)); }),
          fmt::format("Hertz ellipse, semi-axes {} m along x and {} m along y", along_x, along_y)};
}

DescribedPatch read_line_load(const TomlReader& table) {
  const double length = table.number("length", positive("a length in m"));
  return {AnyPatch(friction::LineLoad::of_length(length)), fmt::format("line load along x, length {} m", length)};
}

DescribedPatch read_point_load(const TomlReader&) { return {AnyPatch(friction::PointLoad{}), "point load"}; }

// A name of 'patch', the keys that it takes, and how it is read.
struct Kind {
  std::string_view name;
  std::vector<std::string_view> keys;
  DescribedPatch (*read)(const TomlReader&);
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"hertz_disc", {"radius", "model", "centre"}, read_hertz_disc},
      {"flat_punch_disc", {"radius", "centre"}, read_flat_punch},
      {"uniform_disc", {"radius", "centre"}, read_uniform},
      {"ring", {"radius", "centre"}, read_ring},
      {"power_disc", {"radius", "exponent", "centre"}, read_power_disc},
      {"xydas_kao_disc", {"radius", "alpha", "centre"}, read_xydas_kao},
      {"hertz_ellipse", {"semi_axes", "centre"}, read_hertz_ellipse},
      {"rectangle", {"sides", "centre"}, read_rectangle},
      {"polygon", {"vertices", "holes"}, read_polygon},
      {"pressure_grid", {"pressures", "cell", "centre"}, read_pressure_grid},
      {"pressure_mesh", {"mesh", "unit", "centre"}, read_pressure_mesh},
      {"pressure_points", {"points", "unit", "vertices", "holes"}, read_pressure_points},
      {"line", {"length", "centre"}, read_line_load},
      {"point", {"centre"}, read_point_load},
  };
  return all;
}

// Keys of a contact that no patch takes.
constexpr std::array<std::string_view, 5> of_none{"bodies", "parts", "fingertip", "approach", "contact_radius"};

std::string listed(const std::vector<std::string_view>& keys) {
  std::string words = fmt::format("'{}'", keys.front());
  for (std::size_t i = 1; i < keys.size(); ++i) {
    words += fmt::format("{}'{}'", i + 1 < keys.size() ? ", " : " and ", keys[i]);
  }
  return words;
}

}  // namespace

DescribedPatch hertz_disc(const TomlReader& table, double radius) {
  constexpr std::array<std::string_view, 2> models{"exact", "seed_polynomial"};
  if (table.has("model") && table.choice("model", models) == 1) {
    return {friction::SeedHertzDisc::of_radius(radius),
            fmt::format("Hertz disc by the polynomials of Keppler 2006, 4.2.5, radius {} m", radius)};
  }
  return {friction::HertzDisc::of_radius(radius), fmt::format("Hertz disc, radius {} m", radius)};
}

DescribedPatch read_patch(const TomlReader& table) {
  std::vector<std::string_view> names;
  for (const Kind& kind : kinds()) names.push_back(kind.name);
  const Kind& kind = kinds()[table.choice("patch", names)];
  const auto refuse_unless_taken = [&](std::string_view key) {
    if (!table.has(key) || std::ranges::find(kind.keys, key) != kind.keys.end()) return;
    table.refuse(key, fmt::format("not used by a {}, which takes {}", kind.name, listed(kind.keys)));
  };
  for (const Kind& other : kinds()) std::ranges::for_each(other.keys, refuse_unless_taken);
  std::ranges::for_each(of_none, refuse_unless_taken);
  return kind.read(table);
}

friction::PlanarFrame read_frame(const TomlReader& table) {
  friction::PlanarFrame frame;
  if (table.has("centre")) {
    const friction::Pole centre = read_point(table, table.node("centre"), "centre");
    frame.x = centre.x;
    frame.y = centre.y;
  }
  if (table.has("angle")) frame.angle = table.number("angle", any_angle("an angle against the x-axis in rad"));
  return frame;
}

std::string in_words(const friction::PlanarFrame& frame) {
  std::string words;
  if (frame.x != 0 || frame.y != 0) words = fmt::format("centre ({}, {}) m", frame.x, frame.y);
  if (frame.angle != 0) words += fmt::format("{}turned by {} rad", words.empty() ? "" : ", ", frame.angle);
  return words;
}

}  // namespace patchgrip::cli
