// Pressure that is constant over each cell of a rectangular grid: distance integrals as sums over the grid's corners.
//
// With the second difference of the pressure at a corner, c = p_ij - p_(i-1)j - p_i(j-1) + p_(i-1)(j-1), and a = x_i -
// X, b = y_j - Y, d = sqrt(a^2 + b^2),
//
//     S      =  sum c (2 a b d + a^3 asinh(b/|a|) + b^3 asinh(a/|b|)) / 6
//     grad S = -sum c (b d + a^2 asinh(b/|a|), a d + b^2 asinh(a/|b|)) / 2
//     Hess S =  sum c (a asinh(b/|a|), d; d, b asinh(a/|b|))
//
// the corner sums of rectangle.h, those of neighbours taken together: two logarithms a cell. asinh(b/|a|) = sgn b
// [ln(|b| + d) - ln|a|]; the second logarithm is common to a column.
//
// Error    u the unit of rounding, r >= every d: grad S to about u sum |c| r^2, S to u sum |c| r^3: a rough pressure on
//          many cells loses digits. Proved nowhere, measured in sampled_grid_test.cc.
#pragma once

#include <cstddef>

#include <patchgrip/friction/sampled/distance_sums.h>
#include <patchgrip/friction/sampled/lanes.h>

namespace patchgrip::friction::kernels {

struct CornerSpan {
  std::size_t begin, end;  // multiples of the vectors' width are fastest
};

// Corners row after row, x running fastest; each row and x padded to a multiple of 8 with corners of no weight.
struct CornerBlock {
  const double* x;
  const double* y;
  const double* c;
  const CornerSpan* spans;  // of each row, c = 0 outside
  std::size_t columns;      // a multiple of 8
  std::size_t rows;
};

// Adds to `sums`.
using CornerKernel = void (*)(const CornerBlock& block, double X, double Y, DistanceSums& sums) noexcept;

CornerKernel corner_kernel(Derivatives derivatives, Lanes lanes) noexcept;

}  // namespace patchgrip::friction::kernels
