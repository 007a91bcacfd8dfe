// A yes or no a cell, and its growth and shrinkage by a layer of cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>

namespace patchgrip::contact {

// 1 or 0 a cell, with a frame of one cell around the grid.
using Mask = std::vector<unsigned char>;

class CellMasks {
 public:
  CellMasks(const Grid& grid, Surface surface)
      : grid_(grid), surface_(surface), stride_(static_cast<std::size_t>(grid.nx) + 2) {}

  std::size_t index(int i, int j) const {
    return (static_cast<std::size_t>(j) + 1) * stride_ + static_cast<std::size_t>(i) + 1;
  }

  Mask pressed(std::span<const double> pressure) const {
    Mask mask(stride_ * (static_cast<std::size_t>(grid_.ny) + 2));
    for (int j = 0; j < grid_.ny; ++j) {
      std::transform(&pressure[grid_.index(0, j)], &pressure[grid_.index(0, j)] + grid_.nx, &mask[index(0, j)],
                     [](double p) { return p > 0; });
    }
    close(mask);
    return mask;
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
    Mask rows(mask.size()), result(mask.size());
    for (std::size_t k = 1; k + 1 < mask.size(); ++k) {
      rows[k] = static_cast<unsigned char>(combine(mask[k - 1], mask[k], mask[k + 1]));
    }
    for (std::size_t k = stride_; k + stride_ < mask.size(); ++k) {
      result[k] = static_cast<unsigned char>(combine(rows[k - stride_], rows[k], rows[k + stride_]));
    }
    close(result);
    return result;
  }

  // The frame: the other side of a periodic surface, nothing around a free one.
  void close(Mask& mask) const {
    const bool wraps = surface_ == Surface::periodic;
    for (int j = 0; j < grid_.ny; ++j) {
      mask[index(-1, j)] = wraps ? mask[index(grid_.nx - 1, j)] : 0;
      mask[index(grid_.nx, j)] = wraps ? mask[index(0, j)] : 0;
    }
    for (int i = -1; i <= grid_.nx; ++i) {
      mask[index(i, -1)] = wraps ? mask[index(i, grid_.ny - 1)] : 0;
      mask[index(i, grid_.ny)] = wraps ? mask[index(i, 0)] : 0;
    }
  }

  const Grid& grid_;
  Surface surface_;
  std::size_t stride_;
};

}  // namespace patchgrip::contact
