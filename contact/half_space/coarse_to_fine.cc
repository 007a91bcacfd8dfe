#include <patchgrip/contact/half_space/cell_mask.h>
#include <patchgrip/contact/half_space/coarse_to_fine.h>
#include <patchgrip/contact/half_space/neighbours.h>
#include <patchgrip/contact/half_space/vector_clones.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace patchgrip::contact {
namespace {

// p^2, and in two layers outside its continuation, at most 0.
Array<double> continued_square(const Grid& grid, Surface surface, std::span<const double> pressure,
                               Resources resources) {
  Array<double> square(pressure.size(), resources.memory);
  resources.workers.each_row(grid.ny, [&](int j, int) {
    const double* p = &pressure[grid.index(0, j)];
    std::transform(p, p + grid.nx, &square[grid.index(0, j)], [](double value) { return value * value; });
  });

  const CellMasks masks(grid, surface, resources);
  Mask known = masks.pressed(pressure);
  for (int pass = 0; pass < 2; ++pass) {
    Mask next = masks.dilated(known);
    const auto continue_to = [&](int i, int j) {
      double sum = 0;
      int count = 0;
      for (int dj = -1; dj <= 1; ++dj) {
        for (int di = -1; di <= 1; ++di) {
          if (known[masks.index(i + di, j + dj)] == 0) continue;
          visit_cell(grid, surface, i + di, j + dj, [&](std::size_t near) {
            visit_cell(grid, surface, i + 2 * di, j + 2 * dj, [&](std::size_t far) {
              if (!(pressure[far] > 0)) return;
              sum += 2 * square[near] - square[far];
              ++count;
            });
          });
        }
      }
      if (count > 0) square[grid.index(i, j)] = std::min(sum / count, 0.);
    };
    resources.workers.each_row(grid.ny, [&](int j, int) {
      const unsigned char* before = &known[masks.index(0, j)];
      const unsigned char* after = &next[masks.index(0, j)];
      for (int i = 0; i < grid.nx; ++i) {
        i = static_cast<int>(std::mismatch(before + i, before + grid.nx, after + i).first - before);
        if (i < grid.nx) continue_to(i, j);
      }
    });
    known = std::move(next);
  }
  return square;
}

// Weights of the quarter points of bilinear interpolation between cell centres: 9, 3, 3, 1 sixteenths.
constexpr double near_weight = 0.75, far_weight = 0.25;
// Of cubic interpolation in the middle.
constexpr std::array cubic{-0.0625, 0.5625, 0.5625, -0.0625};

int folded(int i, int n, Surface surface) {
  return surface == Surface::periodic ? (i + n) % n : std::clamp(i, 0, n - 1);
}

// `blend` has a cell more on either side.
PATCHGRIP_VECTOR_CLONES void refine_row(int n, const double* __restrict blend, double* __restrict fine) {
  for (int i = 0; i < n; ++i) {
    const double left = near_weight * blend[i] + far_weight * blend[i - 1];
    const double right = near_weight * blend[i] + far_weight * blend[i + 1];
    fine[2 * i] = std::sqrt(left > 0 ? left : 0);
    fine[2 * i + 1] = std::sqrt(right > 0 ? right : 0);
  }
}

// `blend` has a cell more on either side; the result stays within the four cells of each.
PATCHGRIP_VECTOR_CLONES void coarsen_row(int n, const double* __restrict blend, const double* __restrict lower,
                                         const double* __restrict upper, double* __restrict coarse) {
  for (int i = 0; i < n; ++i) {
    const double value = cubic[0] * blend[2 * i - 1] + cubic[1] * blend[2 * i] + cubic[2] * blend[2 * i + 1] +
                         cubic[3] * blend[2 * i + 2];
    const double a = lower[2 * i], b = lower[2 * i + 1], c = upper[2 * i], d = upper[2 * i + 1];
    const double low_least = a < b ? a : b, low_most = a < b ? b : a;
    const double high_least = c < d ? c : d, high_most = c < d ? d : c;
    const double least = low_least < high_least ? low_least : high_least;
    const double most = low_most < high_most ? high_most : low_most;
    const double raised = value < least ? least : value;
    coarse[i] = raised > most ? most : raised;
  }
}

// A row of n cells for each thread, with a cell more on either side.
class RowBuffers {
 public:
  RowBuffers(int n, Surface surface, Resources resources)
      : n_(n),
        surface_(surface),
        cells_(static_cast<std::size_t>(resources.workers.count()) * stride(), resources.memory) {}

  double* row(int thread) { return &cells_[static_cast<std::size_t>(thread) * stride() + margin]; }
  void close(double* row) const {
    row[-1] = row[folded(-1, n_, surface_)];
    row[n_] = row[folded(n_, n_, surface_)];
  }

 private:
  static constexpr std::size_t margin = 8;
  std::size_t stride() const { return static_cast<std::size_t>(n_) + 2 * margin; }

  int n_;
  Surface surface_;
  Array<double> cells_;
};

}  // namespace

Grid coarser(const Grid& fine) { return {fine.nx / 2, fine.ny / 2, 2 * fine.dx, 2 * fine.dy}; }

Array<double> refine_pressure(const Grid& coarse, Surface surface, std::span<const double> pressure,
                              Resources resources) {
  const Array<double> square = continued_square(coarse, surface, pressure, resources);
  const Grid fine{2 * coarse.nx, 2 * coarse.ny, coarse.dx / 2, coarse.dy / 2};
  Array<double> result(fine.size(), resources.memory);
  RowBuffers buffers(coarse.nx, surface, resources);
  resources.workers.each_row(fine.ny, [&](int j, int thread) {
    const int near_row = j / 2, far_row = folded(j % 2 == 0 ? near_row - 1 : near_row + 1, coarse.ny, surface);
    const double* near = &square[coarse.index(0, near_row)];
    const double* far = &square[coarse.index(0, far_row)];
    double* blend = buffers.row(thread);
    for (int i = 0; i < coarse.nx; ++i) blend[i] = near_weight * near[i] + far_weight * far[i];
    buffers.close(blend);
    refine_row(coarse.nx, blend, &result[fine.index(0, j)]);
  });
  return result;
}

Array<double> coarsen_pressure(const Grid& fine, std::span<const double> pressure, Resources resources) {
  const Grid coarse = coarser(fine);
  Array<double> result(coarse.size(), resources.memory);
  resources.workers.each_row(coarse.ny, [&](int j, int) {
    const double* lower = &pressure[fine.index(0, 2 * j)];
    const double* upper = &pressure[fine.index(0, 2 * j + 1)];
    for (int i = 0; i < coarse.nx; ++i) {
      result[coarse.index(i, j)] = (lower[2 * i] + lower[2 * i + 1] + upper[2 * i] + upper[2 * i + 1]) / 4;
    }
  });
  return result;
}

Array<double> coarsen_gap(const Grid& fine, Surface surface, std::span<const double> gap, Resources resources) {
  const Grid coarse = coarser(fine);
  Array<double> result(coarse.size(), resources.memory);
  RowBuffers buffers(fine.nx, surface, resources);
  resources.workers.each_row(coarse.ny, [&](int j, int thread) {
    const auto row = [&](int k) { return &gap[fine.index(0, folded(2 * j - 1 + k, fine.ny, surface))]; };
    const double *first = row(0), *lower = row(1), *upper = row(2), *last = row(3);
    double* blend = buffers.row(thread);
    for (int i = 0; i < fine.nx; ++i) {
      blend[i] = cubic[0] * first[i] + cubic[1] * lower[i] + cubic[2] * upper[i] + cubic[3] * last[i];
    }
    buffers.close(blend);
    coarsen_row(coarse.nx, blend, lower, upper, &result[coarse.index(0, j)]);
  });
  return result;
}

}  // namespace patchgrip::contact
