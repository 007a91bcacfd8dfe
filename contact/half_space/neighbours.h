// The cells around a cell: across the sides of a periodic surface, none beyond the sides of a free one.
#pragma once

#include <cstddef>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>

namespace patchgrip::contact {

// Calls visit(index) for the cell (i, j), unless it lies beyond the side of a free surface. |i|, |j| < 2 n.
template <class Visit>
void visit_cell(const Grid& grid, Surface surface, int i, int j, const Visit& visit) {
  if (i < 0 || j < 0 || i >= grid.nx || j >= grid.ny) {
    if (surface == Surface::free) return;
    i = (i + 2 * grid.nx) % grid.nx;
    j = (j + 2 * grid.ny) % grid.ny;
  }
  visit(grid.index(i, j));
}

// The eight cells around (i, j).
template <class Visit>
void visit_neighbours(const Grid& grid, Surface surface, int i, int j, const Visit& visit) {
  for (int dj = -1; dj <= 1; ++dj) {
    for (int di = -1; di <= 1; ++di) {
      if (di != 0 || dj != 0) visit_cell(grid, surface, i + di, j + dj, visit);
    }
  }
}

}  // namespace patchgrip::contact
