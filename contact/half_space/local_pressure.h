// Pressure in a point of a pressed grid, and how far it may be off there.
//
//     p(x, y)      bilinear between the four centres around the point
//     error        max |p - p_coarser| / 2.4 + peak.error / peak p                          of the grid
//                  + (max |p_i-1 - 2 p_i + p_i+1| + max |p_j-1 - 2 p_j + p_j+1|) / 8        of the interpolation,
//                  or + max p, where one of the cells is out of contact, as p ~ sqrt(distance) at an edge
//
// the largest of the 4 x 4 cells around the point. So it is local: next to nothing inside of a wide zone, the height of
// the last cells at its edge, 0 where neither this grid nor the coarser one touches.
//
// Domain   the pressure of press_half_space with local_errors. A free surface ends with its grid: nothing beyond. A
//          periodic one repeats.
// Units    x, y [m], p [Pa].
// Error    true errors of Hertz contacts of 3 cells across or more, laid anyhow: up to 0.6 times the estimate; of a
//          rough surface against a grid four times as fine: up to 3 times; tests/contact/local_pressure_test.cc.
// Fails    what neither grid sees.
// Throws   std::invalid_argument without local_errors, or where x or y is not finite.
#pragma once

#include <optional>

#include <patchgrip/contact/half_space/press.h>

namespace patchgrip::contact {

std::optional<Estimate> local_pressure(const PressedHalfSpace& pressed, double x, double y);

}  // namespace patchgrip::contact
