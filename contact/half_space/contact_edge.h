// Contact area to a fraction of a cell, from the pressure.
//
// At the edge of a smooth contact p ~ sqrt(distance), so phi = p^2 falls through zero as a straight line there. In the
// two layers of cells on either side of the edge phi is the value of a quadratic, fitted by least squares to p^2 of the
// cells within a radius of 4 (up to 7 where there are fewer than 9) that lie more than two layers inside: the two
// outermost layers carry too much pressure. Where the zone is too narrow for that, one layer is left out instead. The
// area is that of phi > 0, linear on the triangles between cell centres, with the quadratic's mean distance from its
// linear interpolation added.
//
// Of cells that are constant, the solver's pressure has its edge too far out, in the mean over directions, by
//
//     edge_offset + edge_curvature_offset kappa                                  [cells], kappa: of the edge [1/cells]
//
// whatever the contact (near a smooth edge all look alike): the zero of the fit is moved in by as much.
//
// Error    an estimate: perimeter times cell times edge_error, narrow_edge_error (one layer left out) or
//          counted_edge_error, not below least_area_error where there is an edge. True errors are at most three times
//          the estimate, on circles of three cells across or more and ellipses to 10:1, on cells as long as 8 times
//          their width, and often far below. Hertz' contact, radius 0.4 of the grid's width, anywhere on a grid of
//          square cells: within 2.5e-4, 7e-5, 5e-5, 1e-5, 1e-5 of the area at 64, 128, 256, 512, 1024 cells a side.
//          tests/contact/contact_edge_test.cc, press_test.cc.
// Fails    where a zone is too narrow to fit (about 6 cells), and where p does not fall to zero at the edge (a punch).
//          Where that is so along more than half of the edge, the area is that of the cells with p > 0, and resolved is
//          false. Zones closer than five cells disturb each other.
// Units    areas [m^2]; the scale of p does not matter.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/resources.h>
#include <patchgrip/contact/half_space/zones.h>

namespace patchgrip::contact {

// In cells, measured on Hertz' contacts, circles and ellipses to 5:1, on 64 to 1024 square cells a side.
inline constexpr double edge_offset = 0.008;
inline constexpr double edge_curvature_offset = 0.07;  // times the curvature of the edge
inline constexpr double edge_error = 1. / 300;
inline constexpr double narrow_edge_error = 1. / 20;
inline constexpr double counted_edge_error = 1. / 5;
inline constexpr double least_area_error = 0.3;  // cells of area

struct ZoneArea {
  double area;
  double error;   // estimated
  bool resolved;  // to a fraction of a cell
};

// One a zone of the map.
std::vector<ZoneArea> zone_areas(const Grid& grid, Surface surface, std::span<const double> pressure,
                                 const ZoneMap& map, Resources resources);

}  // namespace patchgrip::contact
