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

namespace patchgrip::cli {
namespace {

using friction::Point;

// A kind of patch over its sizes, which come in the order of `inputs`.
struct Shape {
  using Sizes = std::span<const double>;

  std::vector<Exact> inputs;
  std::function<PatchVariant(Sizes)> build;
  bool round = false;
  bool partly_covered = false;  // the library has only some members of the family
  std::size_t corners = 0;      // of a polygon: the first sizes are their coordinates

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

std::optional<Shape> read_shape(const std::string& type, TableObject& contact) {
  using namespace friction;
  if (type == "hertz_disc") return read_disc<HertzDisc>(contact);
  if (type == "uniform_disc") return read_disc<UniformDisc>(contact);
  if (type == "flat_punch_disc") return read_disc<FlatPunchDisc>(contact);
  if (type == "ring_line_load") return read_disc<Ring>(contact);
  if (type == "power_disc") return read_disc_of_family<PowerDisc>(contact, "n", -0.5);
  if (type == "xydas_kao_disc") return read_disc_of_family<XydasKaoDisc>(contact, "alpha", 0);
  if (type == "rectangle_uniform") return read_rectangle(contact);
  if (type == "polygon_uniform") return read_polygon(contact);
  return std::nullopt;
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

// Distance of the farthest point of the patch from the centroid of its pressure.
double extent_of(const Shape& shape, const PatchVariant& patch) {
  const std::vector<double> s = shape.sizes(Inputs::rounded);
  if (shape.round) return s[0];
  if (shape.corners == 0) return std::hypot(s[0], s[1]) / 2;
  const auto centroid = std::visit([](const auto& p) { return p.moments(); }, patch);
  double farthest = 0;
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
    visit_patch(patch, centre_as(Inputs::rounded), [](const auto&) {});
    const bool exact = rounds_to_itself(centre[0]) && rounds_to_itself(centre[1]) &&
                       std::all_of(shape->inputs.begin(), shape->inputs.end(), rounds_to_itself);
    const auto instance = [&](Inputs inputs) -> Instance {
      return {moved_patch(*shape, patch, inputs), centre_as(inputs)};
    };
    return TableContact({type, shape->round, exact, extent_of(*shape, patch)},
                        {instance(Inputs::rounded), instance(Inputs::narrow_before), instance(Inputs::narrow_beyond),
                         instance(Inputs::wide_before), instance(Inputs::wide_beyond)});
  } catch (const std::invalid_argument& error) {
    if (!shape->partly_covered) node.fail(error.what());
    report.not_covered(section, fmt::format("contact type '{}': {}", type, error.what()));
    return std::nullopt;
  }
}

}  // namespace patchgrip::cli
