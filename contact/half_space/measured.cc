#include <patchgrip/contact/half_space/coarse_to_fine.h>
#include <patchgrip/contact/half_space/contact_edge.h>
#include <patchgrip/contact/half_space/measured.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace patchgrip::contact {
namespace {

// Errors of Hertz' contact over (h / a)^2, at least. For each zone, or all zones in the mean over their forces.
constexpr double force_floor = 0.05, approach_floor = 0.035, peak_floor = 0.1;
constexpr double unknown = std::numeric_limits<double>::infinity();

// Of the cells of a run.
struct RunSums {
  double pressure = 0, moment = 0;  // about the first one
  int highest = 0;
};

RunSums sums_of(std::span<const double> run) {
  RunSums sums;
  for (std::size_t k = 0; k < run.size(); ++k) {
    sums.pressure += run[k];
    sums.moment += static_cast<double>(k) * run[k];
    if (run[k] > run[static_cast<std::size_t>(sums.highest)]) sums.highest = static_cast<int>(k);
  }
  return sums;
}

// (h / a)^2
double coarseness(const Grid& grid, double area) {
  const double h = std::max(grid.dx, grid.dy);
  return std::numbers::pi * h * h / area;
}

double estimate(double fine, double coarse, double floor, double residual) {
  return std::hypot(std::max(std::abs(fine - coarse) / order_factor, floor * std::abs(fine)), residual * fine);
}

}  // namespace

Measured measure(const Grid& grid, Surface surface, std::span<const double> pressure, double approach,
                 Resources resources) {
  Measured result{
      .approach = approach, .map = map_zones(grid, surface, pressure, resources), .zones = {}, .highest = {}};
  for (const ZoneArea& zone : zone_areas(grid, surface, pressure, result.map, resources)) {
    result.zones.push_back({{0, 0}, {zone.area, zone.error}, {0, 0}, 0, zone.resolved, 0, 0, 0});
    result.area += zone.area;
    result.area_error += zone.error;
  }
  result.highest.resize(result.zones.size());

  const std::vector<ZoneMap::Run>& runs = result.map.runs;
  std::vector<RunSums> sums(runs.size());
  resources.workers.each_row(static_cast<int>(runs.size()), [&](int k, int) {
    const auto& [begin, end, row, zone] = runs[static_cast<std::size_t>(k)];
    sums[static_cast<std::size_t>(k)] =
        sums_of(pressure.subspan(grid.index(begin, row), static_cast<std::size_t>(end - begin)));
  });
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto& [begin, end, row, index] = runs[k];
    ContactZone& zone = result.zones[static_cast<std::size_t>(index)];
    const double force = sums[k].pressure * grid.cell_area();
    zone.force.value += force;
    zone.counted_area += (end - begin) * grid.cell_area();
    zone.x += force * grid.x(begin) + sums[k].moment * grid.cell_area() * grid.dx;
    zone.y += force * grid.y(row);
    const std::size_t highest = grid.index(begin + sums[k].highest, row);
    if (pressure[highest] > zone.peak_pressure.value) {
      zone.peak_pressure.value = pressure[highest];
      result.highest[static_cast<std::size_t>(index)] = highest;
    }
  }
  for (ContactZone& zone : result.zones) {
    zone.x /= zone.force.value;
    zone.y /= zone.force.value;
    result.force += zone.force.value;
    result.counted_area += zone.counted_area;
    result.peak = std::max(result.peak, zone.peak_pressure.value);
  }
  return result;
}

void estimate_zones(const Grid& fine_grid, Measured& fine, const Measured& coarse, double residual) {
  struct Sum {
    double force = 0, area = 0, peak = 0, moment_x = 0, moment_y = 0;
  };
  std::vector<Sum> sums(fine.zones.size());
  const Grid coarse_grid = coarser(fine_grid);
  for (std::size_t k = 0; k < coarse.zones.size(); ++k) {
    const auto columns = static_cast<std::size_t>(coarse_grid.nx);
    const int zone = fine.map.zone[fine_grid.index(2 * static_cast<int>(coarse.highest[k] % columns),
                                                   2 * static_cast<int>(coarse.highest[k] / columns))];
    if (zone < 0) continue;
    Sum& sum = sums[static_cast<std::size_t>(zone)];
    const ContactZone& part = coarse.zones[k];
    sum.force += part.force.value;
    sum.area += part.area.value;
    sum.peak = std::max(sum.peak, part.peak_pressure.value);
    sum.moment_x += part.force.value * part.x;
    sum.moment_y += part.force.value * part.y;
  }
  for (std::size_t k = 0; k < fine.zones.size(); ++k) {
    const Sum& sum = sums[k];
    ContactZone& zone = fine.zones[k];
    if (sum.force > 0) {
      const double floor = coarseness(fine_grid, zone.counted_area);
      zone.force.error = estimate(zone.force.value, sum.force, force_floor * floor, residual);
      zone.area.error = std::max(zone.area.error, std::abs(zone.area.value - sum.area) / order_factor);
      zone.peak_pressure.error = estimate(zone.peak_pressure.value, sum.peak, peak_floor * floor, residual);
      zone.centre_error =
          std::hypot(zone.x - sum.moment_x / sum.force, zone.y - sum.moment_y / sum.force) / order_factor;
      zone.centre_error += residual * std::sqrt(zone.area.value);
    } else {
      zone.force.error = zone.area.error = zone.peak_pressure.error = zone.centre_error = unknown;
    }
  }
}

Totals estimate_totals(const Grid& grid, const Measured& fine, const Measured& coarse, double residual) {
  double mean_coarseness = 0, peak_coarseness = 0;
  for (const ContactZone& zone : fine.zones) {
    const double of_zone = coarseness(grid, zone.counted_area);
    mean_coarseness += zone.force.value / fine.force * of_zone;
    if (zone.peak_pressure.value == fine.peak) peak_coarseness = of_zone;
  }
  if (coarse.zones.empty()) {
    return {{fine.force, unknown}, {fine.approach, unknown}, {fine.peak, unknown}, {fine.area, unknown}};
  }
  const auto estimated = [&](double of_fine, double of_coarse, double floor) {
    return Estimate{of_fine, estimate(of_fine, of_coarse, floor, residual)};
  };
  return {estimated(fine.force, coarse.force, force_floor * mean_coarseness),
          estimated(fine.approach, coarse.approach, approach_floor * mean_coarseness),
          estimated(fine.peak, coarse.peak, peak_floor * peak_coarseness),
          {fine.area, std::max(fine.area_error, std::abs(fine.area - coarse.area) / order_factor)}};
}

}  // namespace patchgrip::contact
