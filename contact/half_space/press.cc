#include <patchgrip/contact/half_space/coarse_to_fine.h>
#include <patchgrip/contact/half_space/levels.h>
#include <patchgrip/contact/half_space/measured.h>
#include <patchgrip/contact/half_space/press.h>
#include <patchgrip/contact/half_space/solver_kernels.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>
#include <iterator>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace patchgrip::contact {
namespace {

constexpr double coarse_tolerance = 30;   // of the one asked for
constexpr double estimate_tolerance = 4;  // the same, of the grid that the errors are estimated from
constexpr double least_magnitude = 1e-100, most_magnitude = 1e100;  // squares neither overflow nor underflow

Array<double> cold_start(const Level& level, Prescribed prescribed, double value, Resources resources) {
  Array<double> pressure(level.grid.size(), resources.memory);
  std::ranges::transform(level.gap, pressure.begin(), [&](double f) {
    return prescribed == Prescribed::load || f < value ? 1. : 0.;  // a load is scaled by the solver
  });
  return pressure;
}

// The first cell in contact on the border of the grid given, or beyond it, is an error.
void check_border(const Grid& grid, const Grid& large, std::span<const double> pressure) {
  for (int j = 0; j < large.ny; ++j) {
    const bool is_inner = j > 0 && j < grid.ny - 1;
    for (int i = 0; i < large.nx; i += is_inner && i == 0 ? grid.nx - 1 : 1) {
      if (!(pressure[large.index(i, j)] > 0)) continue;
      std::ostringstream text;
      text << "contact touches the border of the grid at x = " << grid.x(std::min(i, grid.nx - 1))
           << " m, y = " << grid.y(std::min(j, grid.ny - 1)) << " m: the grid must be larger than the contact";
      throw std::domain_error(text.str());
    }
  }
}

std::vector<double> cropped(const Grid& grid, const Grid& large, std::span<const double> field, double factor) {
  std::vector<double> result;
  result.reserve(grid.size());
  prefer_large_pages(result.data(), grid.size() * sizeof(double));
  for (int j = 0; j < grid.ny; ++j) {
    const double* row = &field[large.index(0, j)];
    std::transform(row, row + grid.nx, std::back_inserter(result), [&](double value) { return factor * value; });
  }
  return result;
}

void check_gap(const Grid& grid, Surface surface, std::span<const double> gap) {
  Grid::of_cells(grid.nx, grid.ny, grid.dx, grid.dy);
  if (gap.size() != grid.size()) refuse("gap.size()", static_cast<double>(gap.size()), "must be nx ny of the grid");
  if (!kernels::within(gap.size(), most_magnitude, gap.data())) {
    for (const double f : gap) require_in("gap", f, -most_magnitude, most_magnitude);
  }
  if (surface == Surface::free) return;
  if (grid.nx % 2 != 0) refuse("nx", grid.nx, "must be even on a periodic surface");
  if (grid.ny % 2 != 0) refuse("ny", grid.ny, "must be even on a periodic surface");
}

void check_press(const Grid& grid, Surface surface, const Press& press, double contact_modulus, double least_gap) {
  if (press.prescribed == Prescribed::load) {
    require_positive("force", press.value);
    require_in("force / (contact_modulus dx dy)", press.value / contact_modulus / grid.cell_area(), least_magnitude,
               most_magnitude);
    return;
  }
  if (surface == Surface::periodic) {
    refuse("approach", press.value, "must not be prescribed on a periodic surface: its mean displacement is infinite");
  }
  if (!(require_finite("approach", press.value) > least_gap)) {
    refuse("approach", press.value, "must exceed the least gap, or nothing touches");
  }
  require_in("approach - least gap", press.value - least_gap, least_magnitude, most_magnitude);
}

void check_start(const Grid& grid, Surface surface, const PressedHalfSpace* start) {
  if (start == nullptr) return;
  if (!(start->grid == grid) || start->surface != surface || start->pressure.size() != grid.size()) {
    throw std::invalid_argument("the start belongs to another grid or surface");
  }
  for (const double p : start->pressure) require_non_negative("pressure of the start", p);
}

// The earlier pressure, p / E*, on the extended grid.
Array<double> extended_start(const Grid& large, const PressedHalfSpace& start, Resources resources) {
  Array<double> pressure(large.size(), resources.memory);
  std::ranges::fill(pressure, 0.);
  for (int j = 0; j < start.grid.ny; ++j) {
    for (int i = 0; i < start.grid.nx; ++i) {
      pressure[large.index(i, j)] = start.pressure[start.grid.index(i, j)] / start.contact_modulus;
    }
  }
  return pressure;
}

// Takes the earlier pressure in place of the one from the coarser grid if its residual is smaller.
void prefer_start(ContactSolver& solver, Prescribed prescribed, double value, Array<double> start,
                  Array<double>& pressure) {
  if (solver.residual_of(prescribed, value, start) < solver.residual_of(prescribed, value, pressure)) {
    pressure = std::move(start);
  }
}

}  // namespace

Press Press::by_force(double force) { return {Prescribed::load, require_positive("force", force)}; }
Press Press::by_approach(double approach) { return {Prescribed::approach, require_finite("approach", approach)}; }

void PressSettings::check() const {
  require_in("tolerance", tolerance, 1e-12, 1e-2);
  require_in("max_iterations", max_iterations, 1, 1e6);
  require_in("threads", threads, 1, Workers::most_threads);
}

int PressSettings::threads_on(const Grid& grid) const {
  constexpr std::size_t least_cells_for_threads = 100 * 100;
  return grid.size() < least_cells_for_threads ? 1 : threads;
}

PressedHalfSpace press_half_space(const Grid& grid, Surface surface, std::span<const double> gap,
                                  double contact_modulus, const Press& press, const PressSettings& settings,
                                  const PressedHalfSpace* start) {
  settings.check();
  require_in("contact_modulus", contact_modulus, least_magnitude, most_magnitude);
  check_gap(grid, surface, gap);
  const double least = kernels::least(gap.size(), gap.data());
  check_press(grid, surface, press, contact_modulus, least);
  check_start(grid, surface, start);

  Workers workers(settings.threads_on(grid)), alone(1);
  PageMemory memory(ContactSolver::bytes_per_cell * grid.size());
  memory.touch(ContactSolver::least_bytes_per_cell * grid.size(), workers);
  std::vector<Level> levels = make_levels(grid, surface, gap, least, {workers, memory});
  if (start != nullptr) levels.erase(levels.begin(), levels.end() - 2);
  const Level& last = levels.back();
  const bool is_load = press.prescribed == Prescribed::load;

  const auto is_shared = [&](const Level& level) { return settings.threads_on(level.grid) > 1; };
  const auto prepare = [&](const Level& level, Resources resources) {
    return std::make_unique<ContactSolver>(level.grid, surface, level.gap, resources);
  };
  // Grids too small for threads leave them time to prepare the first two that are not.
  const auto first_shared = static_cast<std::size_t>(std::ranges::find_if(levels, is_shared) - levels.begin());
  std::vector<std::unique_ptr<ContactSolver>> solvers(levels.size());
  std::future<void> preparation;
  if (first_shared > 0 && first_shared < levels.size()) {
    preparation = std::async(std::launch::async, [&] {
      for (std::size_t k = first_shared; k < std::min(first_shared + 2, levels.size()); ++k) {
        solvers[k] = prepare(levels[k], {workers, memory, alone});
      }
    });
  }

  PressedHalfSpace result{};
  Measured coarse, fine;
  Array<double> pressure;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const Level& level = levels[k];
    const bool finest = k + 1 == levels.size();
    const Resources resources{is_shared(level) ? workers : alone, memory};
    if (k == first_shared && preparation.valid()) preparation.get();
    if (solvers[k] == nullptr) solvers[k] = prepare(level, resources);
    ContactSolver& solver = *solvers[k];
    const double value = is_load ? press.value / contact_modulus / level.grid.cell_area() : press.value - least;

    if (k > 0) {
      pressure = refine_pressure(levels[k - 1].grid, surface, pressure, resources);
    } else if (start != nullptr) {
      pressure = coarsen_pressure(last.grid, extended_start(last.grid, *start, resources), resources);
    } else {
      pressure = cold_start(level, press.prescribed, value, resources);
    }
    if (finest && settings.local_errors) {
      result.coarser_pressure = cropped(grid, last.grid, pressure, contact_modulus);
    }

    // The last but one is half of the error estimate.
    const double factor = finest ? 1 : k + 2 == levels.size() ? estimate_tolerance : coarse_tolerance;
    const double tolerance = factor * settings.tolerance;
    if (k > 0 && start != nullptr) {
      prefer_start(solver, press.prescribed, value, extended_start(last.grid, *start, resources), pressure);
    }
    const SolverStatus status =
        solver.solve(press.prescribed, value, tolerance, settings.max_iterations, settings.observer, pressure);
    solvers[k].reset();
    result.residual = status.residual;
    result.iterations = status.iterations;
    result.all_iterations += status.iterations;
    result.products += status.products * static_cast<double>(level.grid.size()) / static_cast<double>(last.grid.size());
    if (finest && surface == Surface::free) check_border(grid, level.grid, pressure);
    if (k + 2 >= levels.size()) {
      coarse = std::exchange(fine, measure(level.grid, surface, pressure, status.approach, resources));
    }
  }
  estimate_zones(last.grid, fine, coarse, result.residual);
  const Totals total = estimate_totals(last.grid, fine, coarse, result.residual);

  const auto scaled = [&](const Estimate& e) { return Estimate{contact_modulus * e.value, contact_modulus * e.error}; };
  result.grid = grid;
  result.surface = surface;
  result.contact_modulus = contact_modulus;
  result.pressure = cropped(grid, last.grid, pressure, contact_modulus);
  result.force = is_load ? Estimate{press.value, 0} : scaled(total.force);
  result.approach = is_load ? Estimate{total.approach.value + least, total.approach.error} : Estimate{press.value, 0};
  result.peak_pressure = scaled(total.peak);
  result.area = total.area;
  result.counted_area = fine.counted_area;
  result.zones = std::move(fine.zones);
  for (ContactZone& zone : result.zones) {
    zone.force = scaled(zone.force);
    zone.peak_pressure = scaled(zone.peak_pressure);
    zone.x += 0.5 * (last.grid.nx - grid.nx) * grid.dx;
    zone.y += 0.5 * (last.grid.ny - grid.ny) * grid.dy;
  }
  return result;
}

}  // namespace patchgrip::contact
