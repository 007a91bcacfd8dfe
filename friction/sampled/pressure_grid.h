// Friction of a pressure that is constant over each cell of a rectangular grid: measured, or of a numerical half-space.
//
//     p(x, y) = pressures[j nx + i]   for   x0 + i dx < x < x0 + (i + 1) dx,   y0 + j dy < y < y0 + (j + 1) dy
//
// The kernel |P - M| is integrated exactly over every cell (sampled/corner_sums.h), so a pole on a corner or beside it
// is like any other; the midpoint rule errs by order dx there. What remains is that the pressure is sampled at centres:
// for a smooth one the wrench converges with order 2, for p ~ sqrt(distance from the rim), as of Hertz, with order 3/2
// or a little better (sampled_order_test.cc).
//
// Domain   pressures finite and >= 0, at least one positive; at most 2^24 cells. Cells without pressure do not belong
//          to the patch.
// Units    dx, dy, x0, y0 [m]; pressures in any unit, they are scaled to the normal force 1.
// Error    sampled_patch.h
// Throws   std::invalid_argument, naming parameter or cell.
#pragma once

#include <cstddef>
#include <vector>

#include <patchgrip/friction/sampled/sampled_patch.h>

namespace patchgrip::friction {

struct PressureCells {
  std::size_t nx = 0;
  std::size_t ny = 0;
  double dx = 0;                  // [m], > 0
  double dy = 0;                  // [m], > 0
  double x0 = 0;                  // [m], lower left corner of the first cell
  double y0 = 0;                  // [m]
  std::vector<double> pressures;  // nx ny numbers, x running fastest
};

class PressureGrid : public SampledPatch {
 public:
  static constexpr std::size_t most_cells = std::size_t{1} << 24;

  static PressureGrid exact(const PressureCells& cells);
  // tolerance in [1e-14, 1e-3]
  static PressureGrid within(double tolerance, const PressureCells& cells);

 private:
  using SampledPatch::SampledPatch;
};

}  // namespace patchgrip::friction
