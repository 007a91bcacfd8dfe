// Connected zones of contact on a grid, and how many layers of cells lie between a cell and the edge.
//
// Two cells belong to one zone if they touch along a side or in a corner. Zones are numbered in the order of their
// first cell, row by row.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>

namespace patchgrip::contact {

struct ZoneMap {
  static constexpr int deepest_layer = 3;

  int count;                       // zones
  std::vector<int> zone;           // of each cell; within two layers outside that of a neighbour; else -1
  std::vector<signed char> layer;  // 1, 2, 3 or more inwards from the edge; -1, -2 outwards; else 0
};

ZoneMap map_zones(const Grid& grid, Surface surface, std::span<const double> pressure);

}  // namespace patchgrip::contact
