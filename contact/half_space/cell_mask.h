// A yes or no a cell, and its growth and shrinkage by a layer of cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact {

// 1 or 0 a cell, with a frame of one cell around the grid.
using Mask = Array<unsigned char>;

class CellMasks {
 public:
  CellMasks(const Grid& grid, Surface surface, Resources resources)
      : grid_(grid), surface_(surface), resources_(resources), stride_(static_cast<std::size_t>(grid.nx) + 2) {}

  std::size_t index(int i, int j) const {
    return (static_cast<std::size_t>(j) + 1) * stride_ + static_cast<std::size_t>(i) + 1;
  }

  Mask pressed(std::span<const double> pressure) const {
    return filled([&](int j, unsigned char* row) {
      const double* p = &pressure[grid_.index(0, j)];
      for (int i = 0; i < grid_.nx; ++i) row[i] = p[i] > 0 ? 1 : 0;
    });
  }

  // 1 where all nine cells around are 1.
  Mask eroded(const Mask& mask) const {
    return filtered(mask, [](int a, int b, int c) { return a & b & c; });
  }
  // 1 where one of them is.
  Mask dilated(const Mask& mask) const {
    return filtered(mask, [](int a, int b, int c) { return a | b | c; });
  }

 private:
  template <class Combine>
  Mask filtered(const Mask& mask, const Combine& combine) const {
    return filled([&](int j, unsigned char* result) {
      const unsigned char* row = &mask[index(0, j)];
      const auto of_three = [&](const unsigned char* centre) { return combine(centre[-1], centre[0], centre[1]); };
      for (int i = 0; i < grid_.nx; ++i, ++row) {
        result[i] =
            static_cast<unsigned char>(combine(of_three(row - stride_), of_three(row), of_three(row + stride_)));
      }
    });
  }

  // fill(j, row) every row; the frame becomes the other side of a periodic surface, nothing around a free one.
  template <class Fill>
  Mask filled(const Fill& fill) const {
    const bool wraps = surface_ == Surface::periodic;
    Mask mask(stride_ * (static_cast<std::size_t>(grid_.ny) + 2), resources_.memory);
    resources_.workers.each_row(grid_.ny, [&](int j, int) {
      unsigned char* row = &mask[index(0, j)];
      fill(j, row);
      row[-1] = wraps ? row[grid_.nx - 1] : 0;
      row[grid_.nx] = wraps ? row[0] : 0;
    });
    for (const int j : {-1, grid_.ny}) {
      unsigned char* row = &mask[index(-1, j)];
      if (wraps) {
        std::copy_n(&mask[index(-1, j < 0 ? grid_.ny - 1 : 0)], stride_, row);
      } else {
        std::fill_n(row, stride_, static_cast<unsigned char>(0));
      }
    }
    return mask;
  }

  const Grid& grid_;
  Surface surface_;
  Resources resources_;
  std::size_t stride_;
};

}  // namespace patchgrip::contact
