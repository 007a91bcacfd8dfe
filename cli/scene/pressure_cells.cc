#include <patchgrip/cli/scene/pressure_cells.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace patchgrip::cli {
namespace {

struct Steps {
  std::size_t index(double value) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(values, value) - values.begin());
  }

  std::vector<double> values;
  double step;
};

Steps steps_of(const NumberRows& rows, std::size_t column, const TomlReader& table, std::string_view key) {
  std::vector<double> values;
  for (std::size_t i = 0; i < rows.rows(); ++i) values.push_back(rows[i][column]);
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const std::string_view name = pressure_columns[column];
  if (values.size() < 2) table.refuse(key, fmt::format("all of {} is {}: a line has no cells", name, values.front()));
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!(std::fabs(values[i] - values[i - 1] - step) <= 1e-3 * step)) {
      table.refuse(key, fmt::format("{} of {} and {} follow each other where equal steps of {} are expected; take "
                                    "pressure_points for points that are not on a grid",
                                    name, values[i - 1], values[i], step));
    }
  }
  return {std::move(values), step};
}

}  // namespace

friction::PressureCells cells_of(const NumberRows& rows, const TomlReader& table, std::string_view key) {
  const Steps x = steps_of(rows, 0, table, key), y = steps_of(rows, 1, table, key);
  const std::size_t nx = x.values.size(), ny = y.values.size();
  friction::PressureCells cells{
      nx, ny, x.step, y.step, x.values.front() - 0.5 * x.step, y.values.front() - 0.5 * y.step, {}};
  if (nx > most_numbers / ny) {
    table.refuse(key, fmt::format("{} of x_m and {} of y_m: at most {} cells are allowed", nx, ny, most_numbers));
  }
  std::vector<std::size_t> line(nx * ny, 0);
  cells.pressures.resize(nx * ny, 0);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    const std::size_t cell = y.index(rows[i][1]) * nx + x.index(rows[i][0]);
    if (line[cell] != 0) {
      refuse_line(table, key, rows.lines[i], fmt::format("the cell of line {} once more", line[cell]));
    }
    line[cell] = rows.lines[i];
    cells.pressures[cell] = rows[i][2];
  }
  const auto missing = static_cast<std::size_t>(std::ranges::find(line, std::size_t{0}) - line.begin());
  if (missing < line.size()) {
    table.refuse(key, fmt::format("no row for the cell at ({}, {}) m", x.values[missing % nx], y.values[missing / nx]));
  }
  return cells;
}

}  // namespace patchgrip::cli
