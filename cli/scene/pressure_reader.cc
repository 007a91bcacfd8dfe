#include <patchgrip/cli/scene/pressure_reader.h>

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/csv_reader.h>
#include <patchgrip/cli/scene/mesh_lines.h>
#include <patchgrip/cli/scene/outline_reader.h>
#include <patchgrip/cli/scene/pressure_cells.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/contact/triangle_mesh.h>
#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/sampled/overlap.h>
#include <patchgrip/friction/sampled/pressure_grid.h>
#include <patchgrip/friction/sampled/pressure_mesh.h>
#include <patchgrip/friction/sampled/scattered.h>

namespace patchgrip::cli {
namespace {

using friction::AnyPatch;

double read_unit(const TomlReader& table) {
  return table.has("unit") ? table.number("unit", positive("the unit of x and y in the file in m")) : 1;
}

void require_pressure(const TomlReader& table, std::string_view key, const NumberRows& rows, std::size_t row,
                      std::size_t column) {
  const double p = rows[row][column];
  if (p >= 0) return;
  refuse_line(table, key, rows.lines[row],
              rows.has_header ? fmt::format("pressure_Pa = {}: must be >= 0", p)
                              : fmt::format("column {}: a pressure of {}: must be >= 0", column + 1, p));
}

AnyPatch linear_between(const friction::Triangulation& mesh, const std::vector<double>& pressures) {
  return friction::PressureMesh::linear_within(friction::PressureMesh::default_tolerance, mesh, pressures);
}

// In the middle of the contact frame, unless a header says where x and y are.
friction::PressureCells read_cells(const TomlReader& table) {
  const NumberRows rows = read_numbers(table, "pressures", pressure_columns);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    for (std::size_t k = rows.has_header ? 2 : 0; k < rows.columns; ++k)
      require_pressure(table, "pressures", rows, i, k);
  }
  if (rows.has_header) {
    if (table.has("cell")) table.refuse("cell", "not used here: the file has columns x_m and y_m, which say it");
    return cells_of(rows, table, "pressures");
  }
  const auto [dx, dy] = read_sides(table, "cell");
  friction::PressureCells cells{rows.columns, rows.rows(), dx, dy, 0, 0, rows.numbers};
  cells.x0 = -0.5 * static_cast<double>(cells.nx) * dx;
  cells.y0 = -0.5 * static_cast<double>(cells.ny) * dy;
  return cells;
}

// "triangle 3 (line 30 of pad.stl) with a corner in (1.5, 2)": counted from 0, in the unit of the file.
std::string in_words(std::size_t triangle, const contact::TriangleMesh& surface, const std::filesystem::path& file) {
  const std::size_t line = line_of_triangle(file, triangle);
  const auto& corner = surface.vertices()[surface.triangles()[triangle][0]];
  return fmt::format("triangle {}{} with a corner in ({}, {})", triangle,
                     line == 0 ? "" : fmt::format(" (line {} of {})", line, printable(file.filename().string())),
                     corner[0], corner[1]);
}

}  // namespace

DescribedPatch read_pressure_grid(const TomlReader& table) {
  const friction::PressureCells cells = read_cells(table);
  return {
      made(table, "pressures",
           [&] { return AnyPatch(friction::PressureGrid::within(friction::PressureGrid::default_tolerance, cells)); }),
      fmt::format("pressures {}, {} by {} cells of {} m by {} m", table.text("pressures"), cells.nx, cells.ny, cells.dx,
                  cells.dy)};
}

// A surface over the contact plane whose height is the pressure.
DescribedPatch read_pressure_mesh(const TomlReader& table) {
  const std::filesystem::path file = beside_scene(table, "mesh");
  const double unit = read_unit(table);
  return made(table, "mesh", [&]() -> DescribedPatch {
    const auto surface = contact::TriangleMesh::read(file.string());
    friction::Triangulation mesh{{}, surface.triangles()};
    std::vector<double> pressures;
    for (const auto& [x, y, p] : surface.vertices()) {
      mesh.points.push_back({unit * x, unit * y});
      pressures.push_back(p);
    }
    if (const auto pair = friction::overlapping_triangles(mesh)) {
      throw std::invalid_argument(fmt::format("{} and {} lie over each other: the pressure must be one number a point",
                                              in_words(pair->first, surface, file),
                                              in_words(pair->second, surface, file)));
    }
    return {linear_between(mesh, pressures),
            fmt::format("pressure over the mesh {}, {} triangles", table.text("mesh"), mesh.triangles.size())};
  });
}

DescribedPatch read_pressure_points(const TomlReader& table) {
  const double unit = read_unit(table);
  const Outline outline = read_outline(table, "vertices", "holes");
  const NumberRows rows = read_numbers(table, "points", pressure_columns);
  if (rows.has_header && table.has("unit"))
    table.refuse("unit", "not used here: the file has columns x_m and y_m, in m");
  if (rows.columns != 3)
    table.refuse("points", fmt::format("needs 3 columns, x, y and pressure, not {}", rows.columns));
  std::vector<friction::Point> points;
  std::vector<double> pressures;
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const std::span<const double> row = rows[i];
    require_pressure(table, "points", rows, i, 2);
    points.push_back({unit * row[0], unit * row[1]});
    pressures.push_back(row[2]);
  }
  return made(table, "points", [&]() -> DescribedPatch {
    const auto mesh = friction::triangulate_between(points, outline.outer, outline.holes);
    pressures.resize(mesh.points.size(), 0);
    return {linear_between(mesh, pressures),
            fmt::format("pressures {} at {} points, outer vertices {}, holes {}", table.text("points"), points.size(),
                        outline.outer.size(), outline.holes.size())};
  });
}

}  // namespace patchgrip::cli
