// Contact area to a fraction of a cell, from the pressure.
//
// At the edge of a smooth contact p ~ sqrt(distance), so phi = p^2 falls through zero as a straight line there. In the two
// layers of cells on either side of the edge phi is the value of a quadratic, fitted by least squares to p^2 of the cells
// within a radius of 4 (up to 7 where there are fewer than 9) that lie more than two layers inside: the two outermost
// layers carry too much pressure. The area is that of phi > 0, linear on the triangles between cell centres.
//
// Error    Hertz, contact radius 0.4 of the grid's width: 7e-4, 3.5e-4, 2.5e-4, 1e-4 at 64, 128, 256, 512 cells a side;
//          counted cells: 1e-2, 4e-3, 1.5e-3, 1e-3.
// Fails    where a zone is too narrow to fit (about 8 cells), and where p does not fall to zero at the edge (a punch):
//          its area is then that of the cells with p > 0, and resolved is false. Zones closer than five cells disturb each
//          other.
// Units    areas [m^2]; the scale of p does not matter.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/zones.h>

namespace patchgrip::contact {

struct ZoneArea {
  double area;
  bool resolved;  // to a fraction of a cell
};

// One a zone of the map.
std::vector<ZoneArea> zone_areas(const Grid& grid, Surface surface, std::span<const double> pressure,
                                 const ZoneMap& map);

}  // namespace patchgrip::contact
