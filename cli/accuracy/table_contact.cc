#include <patchgrip/cli/accuracy/table_contact.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>

namespace patchgrip::cli {
namespace {

using friction::Point;

// A kind of patch over its sizes, which come in the order of `inputs`.
struct Shape {
  using Sizes = std::span<const double>;

  std::vector<Exact> inputs;
  std::function<PatchVariant(Sizes)> build;
  bool round = false;
  bool half_axes = false;       // the sizes are those of an ellipse
  bool partly_covered = false;  // the library has only some members of the family
  std::size_t corners = 0;      // of a polygon or mesh: the first sizes are their coordinates
  std::size_t columns = 0;      // of a grid: the first sizes are its lower left corner and its steps
  std::size_t rows = 0;
  std::vector<Shape> parts = {};  // of a union; behind the sizes of each: centre, normal force, coefficient

  std::vector<double> sizes(Inputs which) const {
    std::vector<double> values;
    for (const Exact& input : inputs) values.push_back(as_double(input, which));
    return values;
  }
};

template <class Disc>
Shape read_disc(TableObject& contact) {
  return {.inputs = {contact.length("radius").metres()},
          .build = [](Shape::Sizes s) -> PatchVariant { return Disc::of_radius(s[0]); },
          .round = true};
}

template <class Disc>
Shape read_disc_of_family(TableObject& contact, std::string_view parameter, double above) {
  const auto radius = contact.length("radius");
  radius.node.positive();
  const TableNode node = contact[parameter];
  const Exact value = node.number();
  if (!(value > above)) node.fail(fmt::format("a number above {} is expected", above));
  return {.inputs = {radius.metres(), value},
          .build = [](Shape::Sizes s) -> PatchVariant { return Disc::of_radius(s[0], s[1]); },
          .round = true,
          .partly_covered = true};
}

Shape read_ellipse(TableObject& contact) {
  return {.inputs = {contact.length("semi_axis_xi").metres(), contact.length("semi_axis_eta").metres()},
          .build = [](Shape::Sizes s) -> PatchVariant { return friction::HertzEllipse::of_semi_axes(s[0], s[1]); },
          .half_axes = true};
}

Shape read_rectangle(TableObject& contact) {
  return {.inputs = {contact.length("l_xi").metres(), contact.length("l_eta").metres()},
          .build = [](Shape::Sizes s) -> PatchVariant { return friction::Rectangle::of_sides(s[0], s[1]); }};
}

std::size_t read_outline(const TableNode& node, const Exact& factor, std::vector<Exact>& coordinates) {
  const auto points = node.filled();
  for (const TableNode& point : points) {
    for (const Exact& coordinate : point.numbers(2)) coordinates.push_back(coordinate * factor);
  }
  return points.size();
}

std::vector<Point> take_outline(Shape::Sizes& sizes, std::size_t count) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({sizes[2 * i], sizes[2 * i + 1]});
  sizes = sizes.subspan(2 * count);
  return points;
}

Shape read_polygon(TableObject& contact) {
  std::vector<Exact> coordinates;
  const auto vertices = contact.length("vertices");
  const std::size_t corners = read_outline(vertices.node, vertices.factor, coordinates);
  std::vector<std::size_t> hole_corners;
  if (const auto holes = contact.find_length("holes")) {
    for (const TableNode& hole : holes->node.items()) {
      hole_corners.push_back(read_outline(hole, holes->factor, coordinates));
    }
  }
  const auto build = [corners, hole_corners](Shape::Sizes sizes) -> PatchVariant {
    const std::vector<Point> outer = take_outline(sizes, corners);
    std::vector<std::vector<Point>> holes(hole_corners.size());
    for (std::size_t i = 0; i < holes.size(); ++i) holes[i] = take_outline(sizes, hole_corners[i]);
    return friction::Polygon::uniform(outer, holes);
  };
  return {.inputs = std::move(coordinates), .build = build, .corners = corners};
}

Shape read_grid(TableObject& contact) {
  std::vector<Exact> sizes;
  for (const char* name : {"x0", "y0", "hx", "hy"}) sizes.push_back(contact.length(name).metres());
  const auto rows = contact["cell_pressure"].filled();
  const std::size_t ny = rows.size(), nx = rows.front().filled().size();
  for (const TableNode& row : rows) {
    for (const Exact& p : row.numbers(nx)) sizes.push_back(p);
  }
  const auto build = [nx, ny](Shape::Sizes s) -> PatchVariant {
    return friction::PressureGrid::exact({nx, ny, s[2], s[3], s[0], s[1], {s.begin() + 4, s.end()}});
  };
  return {.inputs = std::move(sizes), .build = build, .columns = nx, .rows = ny};
}

Shape read_mesh(TableObject& contact) {
  std::vector<Exact> sizes;
  const auto vertices = contact.length("vertices");
  const std::size_t corners = read_outline(vertices.node, vertices.factor, sizes);
  std::vector<std::array<std::size_t, 3>> triangles;
  for (const TableNode& triangle : contact["triangles"].filled()) {
    std::array<std::size_t, 3>& indices = triangles.emplace_back();
    const auto numbers = triangle.numbers(indices.size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const auto index = static_cast<double>(numbers[i]);
      if (!(index >= 0 && index < static_cast<double>(corners) && index == std::floor(index)))
        triangle.fail("indices of vertices are expected");
      indices[i] = static_cast<std::size_t>(index);
    }
  }
  for (const Exact& p : contact["nodal_pressure"].numbers(corners)) sizes.push_back(p);
  const auto build = [corners, triangles](Shape::Sizes s) -> PatchVariant {
    const std::vector<Point> points = take_outline(s, corners);
    return friction::PressureMesh::linear({points, triangles}, {s.begin(), s.end()});
  };
  return {.inputs = std::move(sizes), .build = build, .corners = corners};
}

std::array<Exact, 2> read_centre(TableObject& contact) {
  std::optional<TableObject::Length> centre = contact.find_length("centre");
  if (const auto bare = contact.find("centre")) {
    if (centre) bare->fail("the centre is there twice");
    centre = {*bare, 1};
  }
  if (!centre) return {0, 0};
  const auto xy = centre->node.numbers(2);
  return {xy[0] * centre->factor, xy[1] * centre->factor};
}

std::optional<Shape> read_union(TableObject& contact, bool with_mu);

std::optional<Shape> read_shape(const std::string& type, TableObject& contact) {
  using namespace friction;
  if (type == "hertz_disc") return read_disc<HertzDisc>(contact);
  if (type == "uniform_disc") return read_disc<UniformDisc>(contact);
  if (type == "flat_punch_disc") return read_disc<FlatPunchDisc>(contact);
  if (type == "ring_line_load") return read_disc<Ring>(contact);
  if (type == "power_disc") return read_disc_of_family<PowerDisc>(contact, "n", -0.5);
  if (type == "xydas_kao_disc") return read_disc_of_family<XydasKaoDisc>(contact, "alpha", 0);
  if (type == "hertz_ellipse") return read_ellipse(contact);
  if (type == "rectangle_uniform") return read_rectangle(contact);
  if (type == "polygon_uniform") return read_polygon(contact);
  if (type == "grid_cells") return read_grid(contact);
  if (type == "triangles_linear") return read_mesh(contact);
  if (type == "union") return read_union(contact, false);
  if (type == "union_mu") return read_union(contact, true);
  return std::nullopt;
}

constexpr std::size_t place_and_weight = 4;  // x, y, F_N, mu

// f(part, its sizes, its place and weight)
template <class F>
void for_each_part(const std::vector<Shape>& parts, Shape::Sizes sizes, F&& f) {
  for (const Shape& part : parts) {
    const std::size_t own = part.inputs.size();
    f(part, sizes.first(own), sizes.subspan(own, place_and_weight));
    sizes = sizes.subspan(own + place_and_weight);
  }
}

// Nothing if one of the parts is not covered.
std::optional<Shape> read_union(TableObject& contact, bool with_mu) {
  Shape all;
  for (const TableNode& node : contact["parts"].filled()) {
    TableObject fields(node);
    auto part = read_shape(fields["type"].text(), fields);
    if (!part) return std::nullopt;
    const auto centre = read_centre(fields);
    const Exact force = fields[with_mu ? "F_N" : "share"].positive();
    const Exact mu = with_mu ? fields["mu"].positive() : 1;
    if (!fields.unread().empty()) return std::nullopt;
    all.inputs.insert(all.inputs.end(), part->inputs.begin(), part->inputs.end());
    all.inputs.insert(all.inputs.end(), {centre[0], centre[1], force, mu});
    all.partly_covered |= part->partly_covered;
    all.parts.push_back(*std::move(part));
  }
  all.build = [parts = all.parts](Shape::Sizes sizes) -> PatchVariant {
    std::vector<friction::Several::Part> built;
    for_each_part(parts, sizes, [&](const Shape& part, Shape::Sizes own, Shape::Sizes more) {
      visit_patch(part.build(own), {more[0], more[1]}, [&](const auto& patch) {
        built.push_back({patch, more[2], more[3]});
      });
    });
    return friction::Several::of_parts(std::move(built));
  };
  return all;
}

// Distance of the farthest point of the patch from the centroid of its pressure.
double extent_of(const Shape& shape, Shape::Sizes s, const PatchVariant& patch) {
  if (shape.round) return s[0];
  if (shape.half_axes) return std::max(s[0], s[1]);
  const auto centroid = std::visit([](const auto& p) { return p.moments(); }, patch);
  if (shape.columns > 0) {
    const auto farther = [](double start, double step, std::size_t n, double middle) {
      return std::max(std::fabs(start - middle), std::fabs(start + static_cast<double>(n) * step - middle));
    };
    return std::hypot(farther(s[0], s[2], shape.columns, centroid.x), farther(s[1], s[3], shape.rows, centroid.y));
  }
  double farthest = 0;
  if (!shape.parts.empty()) {
    for_each_part(shape.parts, s, [&](const Shape& part, Shape::Sizes own, Shape::Sizes more) {
      const double away = std::hypot(more[0] - centroid.x, more[1] - centroid.y);
      farthest = std::max(farthest, away + extent_of(part, own, part.build(own)));
    });
    return farthest;
  }
  if (shape.corners == 0) return std::hypot(s[0], s[1]) / 2;
  for (std::size_t i = 0; i < shape.corners; ++i) {
    farthest = std::max(farthest, std::hypot(s[2 * i] - centroid.x, s[2 * i + 1] - centroid.y));
  }
  return farthest;
}

// At the edge of what the library accepts moved sizes may be refused: then they stay.
PatchVariant moved_patch(const Shape& shape, const PatchVariant& patch, Inputs inputs) {
  const std::vector<double> sizes = shape.sizes(inputs);
  if (sizes == shape.sizes(Inputs::rounded)) return patch;
  try {
    return shape.build(sizes);
  } catch (const std::invalid_argument&) {
    return patch;
  }
}

}  // namespace

std::optional<TableContact> TableContact::read(const TableNode& node, std::string_view section,
                                               AccuracyReport& report) {
  TableObject contact(node);
  const std::string type = contact["type"].text();
  const auto shape = read_shape(type, contact);
  if (!shape) {
    report.not_covered(section, fmt::format("contact type '{}'", printable(type)));
    return std::nullopt;
  }
  const auto centre = read_centre(contact);
  const std::vector<std::string> unknown = contact.unread();
  for (const std::string& field : unknown) {
    report.not_covered(section, fmt::format("field '{}' of contact type '{}'", printable(field), type));
  }
  if (!unknown.empty()) return std::nullopt;

  const auto centre_as = [&](Inputs inputs) {
    return friction::Pole{as_double(centre[0], inputs), as_double(centre[1], inputs)};
  };
  try {
    const PatchVariant patch = shape->build(shape->sizes(Inputs::rounded));
    const friction::Pole rounded = centre_as(Inputs::rounded);
    visit_patch(patch, {rounded.x, rounded.y}, [](const auto&) {});
    const bool exact = rounds_to_itself(centre[0]) && rounds_to_itself(centre[1]) &&
                       std::all_of(shape->inputs.begin(), shape->inputs.end(), rounds_to_itself);
    const auto instance = [&](Inputs inputs) -> Instance {
      return {moved_patch(*shape, patch, inputs), centre_as(inputs)};
    };
    return TableContact({type, shape->round, exact, extent_of(*shape, shape->sizes(Inputs::rounded), patch)},
                        {instance(Inputs::rounded), instance(Inputs::narrow_before), instance(Inputs::narrow_beyond),
                         instance(Inputs::wide_before), instance(Inputs::wide_beyond)});
  } catch (const std::invalid_argument& error) {
    if (!shape->partly_covered) node.fail(error.what());
    report.not_covered(section, fmt::format("contact type '{}': {}", type, error.what()));
    return std::nullopt;
  }
}

}  // namespace patchgrip::cli
