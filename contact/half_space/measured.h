// What is read off the pressure on a grid, and its errors from the same on the grid with half as many cells a side.
//
// Error    of a value v: the larger of |v - v_coarse| / 2.4 and c (h / a)^2 v, and the solver's residual times v; a is
//          the radius of a circle of the contact's area, h the longer side of a cell. A round Hertz contact is off by
//          up to 3 c (h / a)^2, also when two grids agree by chance: its peak by 1/4 (h / a)^2 where it lies in the
//          corner of a cell. Infinite for what the coarser grid does not have. tests/contact/press_test.cc.
// Units    of p / E*: forces [m^2], pressures [1]; approach [m], areas [m^2].
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <patchgrip/contact/estimate.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/press.h>
#include <patchgrip/contact/half_space/resources.h>
#include <patchgrip/contact/half_space/zones.h>

namespace patchgrip::contact {

inline constexpr double order_factor = 2.4;  // 2^order - 1 of what is measured on Hertz' contact

struct Measured {
  double force = 0, approach = 0, peak = 0, area = 0, area_error = 0, counted_area = 0;
  ZoneMap map;
  std::vector<ContactZone> zones;
  std::vector<std::size_t> highest;  // cell of each zone
};

struct Totals {
  Estimate force, approach, peak, area;
};

// Of the errors only those of the areas.
Measured measure(const Grid& grid, Surface surface, std::span<const double> pressure, double approach,
                 Resources resources);

// Writes the errors of the zones. Those of the coarser grid belong to the finer one that lies around their highest
// cell.
void estimate_zones(const Grid& grid, Measured& fine, const Measured& coarse, double residual);

Totals estimate_totals(const Grid& grid, const Measured& fine, const Measured& coarse, double residual);

}  // namespace patchgrip::contact
