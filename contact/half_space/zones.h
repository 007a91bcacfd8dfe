// Connected zones of contact on a grid, and how many layers of cells lie between a cell and the edge.
//
// Two cells belong to one zone if they touch along a side or in a corner. Zones are numbered in the order of their
// first cell, row by row.
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact {

struct ZoneMap {
  static constexpr int deepest_layer = 3;

  // Cells of a row in contact, side by side.
  struct Run {
    int begin, end, row, zone;
  };

  int count = 0;             // zones
  std::vector<Run> runs;     // row by row
  Array<int> zone;           // of each cell; within two layers outside that of a neighbour; else -1
  Array<signed char> layer;  // 1, 2, 3 or more inwards from the edge; -1, -2 outwards; else 0

  // act(i) for the cells of row j in a layer.
  template <class Act>
  void each_in_layer(const Grid& grid, int j, int which, const Act& act) const {
    const signed char* row = &layer[grid.index(0, j)];
    const signed char* const end = row + grid.nx;
    for (const signed char* cell = row; cell != end; ++cell) {
      cell = static_cast<const signed char*>(
          std::memchr(cell, static_cast<unsigned char>(which), static_cast<std::size_t>(end - cell)));
      if (cell == nullptr) return;
      act(static_cast<int>(cell - row));
    }
  }
};

ZoneMap map_zones(const Grid& grid, Surface surface, std::span<const double> pressure, Resources resources);

}  // namespace patchgrip::contact
