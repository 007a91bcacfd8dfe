// Rectangular cells over a rectangle of the contact plane, centred on the origin.
//
// Fields (pressure, gap, displacement) are one number a cell, row by row: index j nx + i, the x coordinate running
// fastest. Cell (i, j) has its centre at ((i + 1/2) dx - nx dx / 2, (j + 1/2) dy - ny dy / 2).
//
// Domain   8 <= nx, ny <= 8192 and nx ny <= 2^24 cells; dx, dy in [1e-50, 1e50], one at most 8 times the other.
// Units    dx, dy, x, y [m].
// Throws   std::invalid_argument outside the domain, naming the parameter.
#pragma once

#include <cstddef>
#include <vector>

namespace patchgrip::contact {

struct Grid {
  static constexpr int least_cells = 8;
  static constexpr int most_cells = 8192;
  static constexpr std::size_t most_cells_in_all = std::size_t{1} << 24;

  static Grid of_cells(int nx, int ny, double dx, double dy);
  static Grid square(int cells, double width);

  std::size_t size() const noexcept { return static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny); }
  std::size_t index(int i, int j) const noexcept {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(i);
  }
  double x(int i) const noexcept { return (i + 0.5 - 0.5 * nx) * dx; }
  double y(int j) const noexcept { return (j + 0.5 - 0.5 * ny) * dy; }
  double cell_area() const noexcept { return dx * dy; }

  friend bool operator==(const Grid&, const Grid&) = default;

  int nx, ny;
  double dx, dy;
};

// A function of (x, y) at the centre of every cell.
template <class Function>
std::vector<double> sample(const Grid& grid, const Function& function) {
  std::vector<double> values(grid.size());
  for (int j = 0; j < grid.ny; ++j) {
    for (int i = 0; i < grid.nx; ++i) values[grid.index(i, j)] = function(grid.x(i), grid.y(j));
  }
  return values;
}

}  // namespace patchgrip::contact
