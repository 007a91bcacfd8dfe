#include <patchgrip/cli/press/press_height_map.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/press/press_ellipse.h>
#include <patchgrip/cli/press/rounding.h>
#include <patchgrip/cli/progress.h>
#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/height_map.h>
#include <patchgrip/contact/half_space/local_pressure.h>

namespace patchgrip::cli {
namespace {

using contact::Grid;
using contact::PressedHalfSpace;

// Height of the other body above its lowest point, to second order.
double height_of(const CurvedSurface& surface, double x, double y) {
  const double c = std::cos(surface.direction);
  const double s = std::sin(surface.direction);
  const double first = c * x + s * y;
  const double second = c * y - s * x;
  return first * first / (2 * surface.radii[0]) + second * second / (2 * surface.radii[1]);
}

struct Gap {
  Grid grid;
  std::vector<double> values;
};

Gap gap_of(const HeightMapFile& file, const CurvedSurface& other) {
  Gap gap{file.map->grid(file.cell[0], file.cell[1]), file.map->gap_below_flat()};
  for (int j = 0; j < gap.grid.ny; ++j) {
    for (int i = 0; i < gap.grid.nx; ++i) {
      gap.values[gap.grid.index(i, j)] += height_of(other, gap.grid.x(i), gap.grid.y(j));
    }
  }
  const double least = *std::ranges::min_element(gap.values);
  for (double& g : gap.values) g -= least;
  return gap;
}

// Whole cells only: what is left over at the upper ends is dropped on both sides.
Gap averaged(Gap gap, int coarser) {
  if (coarser == 1) return gap;
  const Grid& fine = gap.grid;
  const Grid grid = Grid::of_cells(fine.nx / coarser, fine.ny / coarser, fine.dx * coarser, fine.dy * coarser);
  std::vector<double> values(grid.size());
  const int left = fine.nx % coarser / 2, below = fine.ny % coarser / 2;
  for (int j = 0; j < grid.ny * coarser; ++j) {
    for (int i = 0; i < grid.nx * coarser; ++i) {
      values[grid.index(i / coarser, j / coarser)] += gap.values[fine.index(left + i, below + j)] / (coarser * coarser);
    }
  }
  return {grid, std::move(values)};
}

contact::Press press_of(const StaticLoad& load) {
  if (load.kind == LoadKind::contact_radius) {
    load.place.refuse("a height map takes 'normal_force' or 'approach'");
  }
  return load.kind == LoadKind::normal_force ? contact::Press::by_force(load.value)
                                             : contact::Press::by_approach(load.value);
}

bool peak_is_resolved(const PressedHalfSpace& p) {
  const auto highest =
      std::ranges::max_element(p.zones, {}, [](const contact::ContactZone& zone) { return zone.peak_pressure.value; });
  return highest != p.zones.end() && highest->edge_resolved;
}

LawAnswer answer_of(const PressedHalfSpace& p, double modulus) {
  const auto estimated = [](const char* name, const Estimate& e, const char* of) {
    return Result{name, e.value, e.error, of};
  };
  LawAnswer answer{
      "half_space",
      {estimated("normal_force", p.force, "N"),
       estimated("approach", p.approach, "m"),
       estimated("contact_area", p.area, "m^2"),
       within("contact_modulus", modulus, 1.01, "Pa"),
       {"residual", p.residual, 0, "1"}},
      fmt::format("numerical half-space on {} x {} cells, {} iterations; errors are estimates by refinement", p.grid.nx,
                  p.grid.ny, p.iterations)};
  if (peak_is_resolved(p)) answer.results.push_back(estimated("peak_pressure", p.peak_pressure, "Pa"));
  answer.results.push_back({"zones", static_cast<double>(p.zones.size()), 0, "1"});
  return answer;
}

Table map_of(const PressedHalfSpace& p) {
  Table map{{"x_m", "y_m", "pressure_Pa", "pressure_error_Pa"}, {}};
  map.rows.reserve(p.grid.size());
  for (int j = 0; j < p.grid.ny; ++j) {
    for (int i = 0; i < p.grid.nx; ++i) {
      const double x = p.grid.x(i), y = p.grid.y(j);
      map.rows.push_back({x, y, p.pressure[p.grid.index(i, j)], contact::local_pressure(p, x, y)->error});
    }
  }
  return map;
}

}  // namespace

const HeightMapFile* height_map_of(const BodyPair& pair) {
  if (const auto* map = std::get_if<HeightMapFile>(&pair.first.shape)) return map;
  return std::get_if<HeightMapFile>(&pair.second.shape);
}

Steepness steepness_of(const PressedHalfSpace& p, double modulus) {
  return peak_is_resolved(p) ? Steepness::of_pressure(p.peak_pressure.value, modulus)
                             : Steepness::of_cells(p.peak_pressure.value, modulus);
}

PressedHalfSpace press_map(const BodyPair& pair, double modulus, const StaticLoad& load, const Place& bodies,
                           int coarser) {
  const HeightMapFile& file = *height_map_of(pair);
  const bool first = std::holds_alternative<HeightMapFile>(pair.first.shape);
  const auto other = curved_surface(first ? pair.second.shape : pair.first.shape);
  if (!other) bodies.refuse("a height map presses on a plane, a ball or a curved body");
  if (file.periodic && !std::holds_alternative<Plane>(first ? pair.second.shape : pair.first.shape)) {
    bodies.refuse("a periodic height map presses on a plane");
  }
  const auto surface = file.periodic ? contact::Surface::periodic : contact::Surface::free;
  const Gap gap = averaged(at(file.place, [&] { return gap_of(file, *other); }), coarser);

  contact::PressSettings settings;
  settings.local_errors = true;
  Progress progress("press", 100, Progress::wanted(Progress::no_output));
  settings.observer = [&](const contact::SolverProgress& at) {
    InterruptGuard::check();
    const double digits = std::log(at.residual) / std::log(settings.tolerance);
    progress.at(static_cast<std::size_t>(100 * std::clamp(digits, 0., 1.)));
  };
  try {
    return contact::press_half_space(gap.grid, surface, gap.values, modulus, press_of(load), settings);
  } catch (const std::domain_error& error) {
    file.place.refuse(fmt::format("the map is too small for the contact: {}", error.what()));
  }
}

Pressed press_height_map(const BodyPair& pair, double modulus, const PressScene& scene) {
  const auto pressed = std::make_shared<const PressedHalfSpace>(
      press_map(pair, modulus, std::get<StaticLoad>(scene.load), scene.subject_place));
  const Grid& grid = pressed->grid;

  if (std::isinf(pressed->area.error)) {
    throw std::domain_error(fmt::format(
        "contact of {:.0f} cells: a grid with half as many cells a side has none, so the errors are unknown; "
        "the grid must be finer or the approach larger",
        pressed->counted_area / pressed->grid.cell_area()));
  }
  Pressed result{{answer_of(*pressed, modulus), {}, {}},
                 std::min(grid.nx * grid.dx, grid.ny * grid.dy) / 4,
                 [pressed](double x, double y) -> SurfacePoint {
                   const auto p = contact::local_pressure(*pressed, x, y);
                   return {p.value_or(Estimate{not_known, not_known})};
                 }};
  result.knows_displacement = false;
  result.map = map_of(*pressed);
  const auto coarse = std::ranges::count_if(pressed->zones, [](const auto& zone) { return !zone.edge_resolved; });
  if (coarse > 0) {
    result.answer.warnings.push_back(fmt::format(
        "{} of {} zones are too small for the grid: their area is that of their cells", coarse, pressed->zones.size()));
  }
  if (!peak_is_resolved(*pressed)) {
    result.answer.warnings.emplace_back("the highest zone is too small for the grid: no peak pressure");
  }
  warn_if_steep(result.answer, steepness_of(*pressed, modulus));
  return result;
}

}  // namespace patchgrip::cli
