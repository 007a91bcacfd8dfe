#include <patchgrip/friction/sampled/pressure_grid.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/friction/sampled/grid_pieces.h>
#include <patchgrip/friction/sampled/sampled_pressure.h>

namespace patchgrip::friction {
namespace {

using kernels::CellRange;
using kernels::GridPieces;
using kernels::PressureFrame;
// Far poles see the centroid's last digits.
using Wide = boost::multiprecision::cpp_bin_float_quad;

void require_cells(const PressureCells& cells) {
  contact::require_positive("dx", cells.dx);
  contact::require_positive("dy", cells.dy);
  contact::require_finite("x0", cells.x0);
  contact::require_finite("y0", cells.y0);
  if (cells.nx == 0 || cells.ny == 0 || cells.nx > PressureGrid::most_cells / cells.ny) {
    throw std::invalid_argument("nx, ny = " + std::to_string(cells.nx) + ", " + std::to_string(cells.ny) +
                                " are not allowed: there must be from 1 to 2^24 cells");
  }
  if (cells.pressures.size() != cells.nx * cells.ny) {
    throw std::invalid_argument("pressures has " + std::to_string(cells.pressures.size()) +
                                " numbers: nx ny = " + std::to_string(cells.nx * cells.ny) + " are expected");
  }
  for (std::size_t k = 0; k < cells.pressures.size(); ++k) {
    const double p = cells.pressures[k];
    if (!(p >= 0) || !std::isfinite(p)) contact::require_non_negative("pressures[" + std::to_string(k) + "]", p);
  }
  if (std::ranges::none_of(cells.pressures, [](double p) { return p > 0; }))
    throw std::invalid_argument("pressures are all 0: at least one must be positive");
}

// The smallest range that holds all the pressure.
CellRange loaded_range(const PressureCells& cells) {
  CellRange r{cells.nx, 0, cells.ny, 0};
  for (std::size_t j = 0; j < cells.ny; ++j) {
    for (std::size_t i = 0; i < cells.nx; ++i) {
      if (cells.pressures[j * cells.nx + i] == 0) continue;
      r = {std::min(r.i0, i), std::max(r.i1, i + 1), std::min(r.j0, j), std::max(r.j1, j + 1)};
    }
  }
  return r;
}

struct CellMoments {
  Wide force{0};    // in cells
  Wide x{0}, y{0};  // centroid about the grid's lower left corner [m]
  Wide polar{0};    // [m^2]
  std::size_t loaded = 0;
};

CellMoments cell_moments(const PressureCells& cells) {
  CellMoments m;
  const Wide dx = cells.dx, dy = cells.dy;
  for (std::size_t j = 0; j < cells.ny; ++j) {
    Wide force = 0, first = 0, second = 0;
    for (std::size_t i = 0; i < cells.nx; ++i) {
      const double p = cells.pressures[j * cells.nx + i];
      if (p == 0) continue;
      ++m.loaded;
      const double x = static_cast<double>(i) + 0.5;
      const Wide px = Wide(p) * x;
      force += p;
      first += px;
      second += px * x;
    }
    const Wide y = static_cast<double>(j) + 0.5;
    m.force += force;
    m.x += first;
    m.y += force * y;
    m.polar += dx * dx * (second + force / 12) + dy * dy * force * (y * y + Wide(1) / 12);
  }
  m.x *= dx / m.force;
  m.y *= dy / m.force;
  m.polar = m.polar / m.force - m.x * m.x - m.y * m.y;
  return m;
}

std::shared_ptr<const kernels::SampledPressure> make(const PressureCells& cells, double tolerance) {
  require_cells(cells);
  const CellMoments m = cell_moments(cells);
  const CellRange range = loaded_range(cells);
  const Wide x = cells.x0 + m.x, y = cells.y0 + m.y;

  PressureFrame frame;
  frame.x = static_cast<double>(x);
  frame.y = static_cast<double>(y);
  frame.offset_x = static_cast<long double>(x - frame.x);
  frame.offset_y = static_cast<long double>(y - frame.y);
  frame.polar = contact::require_representable("polar moment", static_cast<double>(m.polar));
  frame.area = contact::require_representable("area", static_cast<double>(m.loaded) * cells.dx * cells.dy);
  const double diagonal =
      std::hypot(static_cast<double>(range.columns()) * cells.dx, static_cast<double>(range.rows()) * cells.dy);
  frame.scale = std::scalbn(1.0, std::ilogb(diagonal));
  frame.centroid_error = 0x1p-100 * diagonal;

  const auto lines = [&](double start, const Wide& centroid, double step, std::size_t first, std::size_t last) {
    const auto origin = static_cast<long double>((start - Wide(static_cast<double>(centroid))) / frame.scale);
    std::vector<double> all;
    for (std::size_t i = first; i <= last; ++i)
      all.push_back(static_cast<double>(origin + static_cast<long double>(i) * step / frame.scale));
    return all;
  };
  // So that the force is 1.
  const Wide per_cell = m.force * (Wide(cells.dx) / frame.scale) * (Wide(cells.dy) / frame.scale);
  const auto factor = static_cast<long double>(1 / per_cell);
  std::vector<double> pressures;
  for (std::size_t j = range.j0; j < range.j1; ++j) {
    for (std::size_t i = range.i0; i < range.i1; ++i)
      pressures.push_back(static_cast<double>(cells.pressures[j * cells.nx + i] * factor));
  }
  frame.highest = *std::ranges::max_element(pressures);
  auto pieces = std::make_unique<GridPieces>(lines(cells.x0, x, cells.dx, range.i0, range.i1),
                                             lines(cells.y0, y, cells.dy, range.j0, range.j1), std::move(pressures));
  // Leaves about as wide as high, of about 15 x 15 cells: 16 corners fill whole vectors.
  std::size_t columns = range.columns(), rows = range.rows();
  if (tolerance > 0) {
    const double shape = std::clamp(std::sqrt(cells.dy / cells.dx), 1.0 / 15, 15.0);
    columns = std::max<std::size_t>(1, static_cast<std::size_t>(16 * shape) / 8 * 8 + 7);
    rows = std::max<std::size_t>(1, static_cast<std::size_t>(15 / shape));
  }
  auto nodes = pieces->make_tree(columns, rows);
  return std::make_shared<const kernels::SampledPressure>(frame, std::move(nodes), std::move(pieces), tolerance);
}

}  // namespace

PressureGrid PressureGrid::exact(const PressureCells& cells) { return PressureGrid(make(cells, 0)); }

PressureGrid PressureGrid::within(double tolerance, const PressureCells& cells) {
  return PressureGrid(make(cells, contact::require_in("tolerance", tolerance, 1e-14, 1e-3)));
}

}  // namespace patchgrip::friction
