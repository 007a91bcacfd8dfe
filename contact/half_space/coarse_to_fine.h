// Between a grid and one of half as many cells a side.
//
// Pressure, coarse to fine: at a smooth edge p ~ sqrt(distance), so p^2 is continued through the two layers of cells
// outside the contact by lines through the two cells behind each of the eight neighbours (their mean, at most 0), then
// interpolated bilinearly; what stays positive is the new p^2. Pressure, fine to coarse: the mean of four cells, which
// keeps the force. Gap, fine to coarse: cubic interpolation at the centre of four cells, kept between the least and the
// largest of them, so that a step in the gap does not overshoot.
#pragma once

#include <span>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact {

Grid coarser(const Grid& fine);  // nx and ny even

Array<double> refine_pressure(const Grid& coarse, Surface surface, std::span<const double> pressure,
                              Resources resources);
Array<double> coarsen_pressure(const Grid& fine, std::span<const double> pressure, Resources resources);
Array<double> coarsen_gap(const Grid& fine, Surface surface, std::span<const double> gap, Resources resources);

}  // namespace patchgrip::contact
