// Heights on a grid from a text file: the gap of a measured surface.
//
//     # any number of comments, and empty lines
//     1.2e-6, 0.8e-6, 1.1e-6
//     0.9e-6, 1.0e-6, 0.7e-6
//
// One line a row of the grid (constant y, the first line the least), numbers separated by commas; blanks around them
// are ignored, as is a byte order mark. All rows are of the same length. Heights in metres.
//
// Domain   8 to 8192 rows and columns, 2^24 numbers in all, each finite.
// Throws   std::invalid_argument, naming file, line, column and what is wrong.
#pragma once

#include <istream>
#include <string_view>
#include <vector>

#include <patchgrip/contact/half_space/grid.h>

namespace patchgrip::contact {

struct HeightMap {
  // `name` is for messages.
  static HeightMap read(std::istream& in, std::string_view name);

  // The grid of its cells, dx by dy each.
  Grid grid(double dx, double dy) const { return Grid::of_cells(nx, ny, dx, dy); }
  // Gap of a flat counter body that rests on the highest point: highest height - height.
  std::vector<double> gap_below_flat() const;

  int nx, ny;
  std::vector<double> heights;  // [m], row by row
};

}  // namespace patchgrip::contact
