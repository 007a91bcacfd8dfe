// The grids of a solution from coarse to fine, each with the gap on it.
//
// The last is the grid given, extended where its sides cannot be halved often enough (a free surface; the gap beyond
// the border is that of the border: no contact is allowed there anyway). The sides of the first have 32 cells at least,
// if there is a choice; there are two grids at least.
//
// Units    gap [m], counted from `least`, its least value.
// Domain   a periodic surface: even numbers of cells.
// Throws   std::bad_alloc.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact {

struct Level {
  Grid grid;
  Array<double> gap;
};

std::vector<Level> make_levels(const Grid& grid, Surface surface, std::span<const double> gap, double least,
                               Resources resources);

}  // namespace patchgrip::contact
