#include <patchgrip/cli/scene/shape.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include <patchgrip/cli/scene/csv_reader.h>
#include <patchgrip/cli/scene/outline_reader.h>

namespace patchgrip::cli {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Quantity any_radius{"a radius in m, negative for a hollow", smallest_size, largest_size, false, true};
constexpr Quantity angle = any_angle("an angle in rad");
constexpr Quantity slope = positive("a slope");
constexpr Quantity term_count{"a number of terms", 1, 60};
constexpr Quantity exponent{"the exponent of r", 0.05, 100};
constexpr std::size_t most_points = 100'000;

double direction_of(const TomlReader& body) { return body.has("direction") ? body.number("direction", angle) : 0; }

// A kind of shape: the key or name that says so, what else it takes, and how it is read.
struct Kind {
  std::string_view name;
  std::vector<std::string_view> with;
  DescribedShape (*read)(const TomlReader&);
};

// A flag that is false is as good as absent.
bool is_given(const TomlReader& body, std::string_view key) {
  return key == "plane" || key == "concave" || key == "periodic" ? body.flag(key) : body.has(key);
}

void refuse_others(const TomlReader& body, const Kind& kind, std::string_view selector) {
  for (const std::string_view key : shape_keys) {
    if (key != selector && is_given(body, key) && std::ranges::find(kind.with, key) == kind.with.end()) {
      body.refuse(key, fmt::format("not used by a {}", kind.name));
    }
  }
}

DescribedShape read_plane(const TomlReader&) { return {Plane{}, "plane"}; }

DescribedShape read_ball(const TomlReader& body) {
  const double radius = body.number("radius", positive("a radius in m ('concave = true' for a hollow)"));
  if (body.flag("concave")) return {Ball{-radius}, fmt::format("hollow of radius {} m", radius)};
  return {Ball{radius}, fmt::format("ball of radius {} m", radius)};
}

DescribedShape read_radii(const TomlReader& body) {
  constexpr std::string_view allowed = "two principal radii [R1, R2] in m, negative for a hollow";
  const toml::array& values = body.array(body.node("radii"), "radii", allowed);
  if (values.size() != 2) body.refuse("radii", allowed);
  const CurvedSurface surface{
      {body.number(values[0], "radii[0]", any_radius), body.number(values[1], "radii[1]", any_radius)},
      direction_of(body)};
  return {surface, fmt::format("principal radii {} m and {} m, the first at {} rad", surface.radii[0], surface.radii[1],
                               surface.direction)};
}

DescribedShape read_cylinder(const TomlReader& body) {
  const double radius = body.number("cylinder", any_radius);
  const double along = direction_of(body);
  return {CurvedSurface{{infinity, radius}, along},
          fmt::format("cylinder of radius {} m, its axis at {} rad", radius, along)};
}

DescribedShape read_sphere(const TomlReader& body) {
  const double radius = body.number("radius", positive("a radius in m"));
  if (!body.has("terms")) return {SphereStamp{radius, 0}, fmt::format("sphere of radius {} m", radius)};
  const double terms = body.number("terms", term_count);
  if (terms != static_cast<int>(terms)) body.refuse("terms", "a whole number");
  return {SphereStamp{radius, static_cast<int>(terms)},
          fmt::format("sphere of radius {} m by {} terms of its series", radius, terms)};
}

DescribedShape read_cone(const TomlReader& body) {
  const double rise = body.number("slope", slope);
  return {ConeStamp{rise}, fmt::format("cone f = {} r", rise)};
}

DescribedShape read_power(const TomlReader& body) {
  const PowerStamp stamp{body.number("coefficient", positive("the coefficient A of f = A r^m, in m^(1-m)")),
                         body.number("exponent", exponent)};
  return {stamp, fmt::format("stamp f = {} r^{}", stamp.coefficient, stamp.exponent)};
}

DescribedShape read_flat_punch(const TomlReader& body) {
  const double radius = body.number("radius", positive("a radius in m"));
  return {FlatPunchStamp{radius}, fmt::format("flat punch of radius {} m", radius)};
}

DescribedShape read_flat_end(const TomlReader& body) {
  const double end = body.number("end_radius", positive("the radius of the flat end in m"));
  if (body.has("radius") == body.has("slope")) {
    body.refuse_table("a flat end goes on with either 'radius' (paraboloid) or 'slope' (cone)");
  }
  if (body.has("slope")) {
    const double rise = body.number("slope", slope);
    return {FlatEndConeStamp{end, rise}, fmt::format("flat end of radius {} m, then a cone of slope {}", end, rise)};
  }
  const double radius = body.number("radius", positive("a radius of curvature in m"));
  return {FlatEndParaboloidStamp{end, radius},
          fmt::format("flat end of radius {} m, then a paraboloid with R = {} m", end, radius)};
}

DescribedShape read_profile_points(const TomlReader& body) {
  constexpr std::string_view allowed = "points [[r, f], ...] in m, from [0, 0] on, r rising and f not falling";
  PointStamp stamp;
  for (const auto& p : read_points(body, body.node("points"), "points")) stamp.points.push_back({p.x, p.y});
  if (stamp.points.size() < 2 || stamp.points.size() > most_points) body.refuse("points", allowed);
  std::string words = fmt::format("profile of {} points", stamp.points.size());
  return {std::move(stamp), std::move(words)};
}

DescribedShape read_stamp(const TomlReader& body) {
  static const std::array<Kind, 6> stamps{{{"sphere", {"radius", "terms"}, read_sphere},
                                           {"cone", {"slope"}, read_cone},
                                           {"power", {"coefficient", "exponent"}, read_power},
                                           {"flat_punch", {"radius"}, read_flat_punch},
                                           {"flat_end", {"end_radius", "radius", "slope"}, read_flat_end},
                                           {"points", {"points"}, read_profile_points}}};
  std::array<std::string_view, stamps.size()> names;
  std::ranges::transform(stamps, names.begin(), &Kind::name);
  const Kind& stamp = stamps[body.choice("stamp", names)];
  refuse_others(body, stamp, "stamp");
  return stamp.read(body);
}

DescribedShape read_mesh(const TomlReader& body) {
  constexpr std::string_view allowed = "a point [x, y, z] of the mesh, in its own unit";
  const toml::array& values = body.array(body.node("point"), "point", allowed);
  if (values.size() != 3) body.refuse("point", allowed);
  MeshSurface mesh{beside_scene(body, "mesh"), {}, 1, body.place("mesh")};
  for (std::size_t i = 0; i < 3; ++i) {
    mesh.point[i] = body.number(values[i], fmt::format("point[{}]", i), any_sign("a coordinate"));
  }
  if (body.has("unit")) mesh.unit = body.number("unit", positive("the unit of the mesh's coordinates in m"));
  std::string words =
      fmt::format("mesh {} at ({}, {}, {})", body.text("mesh"), mesh.point[0], mesh.point[1], mesh.point[2]);
  return {std::move(mesh), std::move(words)};
}

std::shared_ptr<const contact::HeightMap> read_heights(const TomlReader& body) {
  constexpr std::size_t least = contact::Grid::least_cells, most = contact::Grid::most_cells;
  NumberRows rows = read_numbers(body, "height_map");
  for (const std::size_t count : {rows.rows(), rows.columns}) {
    if (count < least || count > most) {
      body.refuse("height_map", fmt::format("{} rows of {} heights: {} to {} of both are needed", rows.rows(),
                                            rows.columns, least, most));
    }
  }
  return std::make_shared<const contact::HeightMap>(
      contact::HeightMap{static_cast<int>(rows.columns), static_cast<int>(rows.rows()), std::move(rows.numbers)});
}

DescribedShape read_height_map(const TomlReader& body) {
  const Sides cell = read_sides(body, "cell");
  const bool periodic = body.flag("periodic");
  return {HeightMapFile{read_heights(body), {cell.along_x, cell.along_y}, periodic, body.place("height_map")},
          fmt::format("height map {}, cells of {} m by {} m{}", body.text("height_map"), cell.along_x, cell.along_y,
                      periodic ? ", periodic" : "")};
}

}  // namespace

DescribedShape read_shape(const TomlReader& body) {
  if (body.has("stamp")) return read_stamp(body);
  static const std::array<Kind, 6> kinds{{{"plane", {}, read_plane},
                                          {"radii", {"direction"}, read_radii},
                                          {"cylinder", {"direction"}, read_cylinder},
                                          {"mesh", {"point", "unit"}, read_mesh},
                                          {"height_map", {"cell", "periodic"}, read_height_map},
                                          {"radius", {"concave"}, read_ball}}};
  const auto kind = std::ranges::find_if(kinds, [&](const Kind& k) { return is_given(body, k.name); });
  if (kind == kinds.end()) {
    body.refuse_table(
        "needs 'radius' (of a ball, or with 'concave = true' of a hollow), 'plane = true', 'radii', "
        "'cylinder', 'stamp', 'mesh' or 'height_map'");
  }
  refuse_others(body, *kind, kind->name);
  return kind->read(body);
}

}  // namespace patchgrip::cli
