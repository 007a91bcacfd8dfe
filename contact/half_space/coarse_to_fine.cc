#include <patchgrip/contact/half_space/cell_mask.h>
#include <patchgrip/contact/half_space/coarse_to_fine.h>
#include <patchgrip/contact/half_space/neighbours.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace patchgrip::contact {
namespace {

// p^2, and in two layers outside its continuation, at most 0.
std::vector<double> continued_square(const Grid& grid, Surface surface, std::span<const double> pressure) {
  std::vector<double> square(pressure.size());
  std::ranges::transform(pressure, square.begin(), [](double p) { return p * p; });

  struct Value {
    std::size_t cell;
    double square;
  };
  const CellMasks masks(grid, surface);
  Mask known = masks.pressed(pressure);
  std::vector<Value> layer;
  for (int pass = 0; pass < 2; ++pass) {
    const Mask next = masks.dilated(known);
    layer.clear();
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        if (next[masks.index(i, j)] == known[masks.index(i, j)]) continue;
        double sum = 0;
        int count = 0;
        for (int dj = -1; dj <= 1; ++dj) {
          for (int di = -1; di <= 1; ++di) {
            if (known[masks.index(i + di, j + dj)] == 0) continue;
            visit_cell(grid, surface, i + di, j + dj, [&](std::size_t near) {
              visit_cell(grid, surface, i + 2 * di, j + 2 * dj, [&](std::size_t far) {
                if (!(square[far] > 0)) return;
                sum += 2 * square[near] - square[far];
                ++count;
              });
            });
          }
        }
        if (count > 0) layer.push_back({grid.index(i, j), std::min(sum / count, 0.)});
      }
    }
    for (const auto& [cell, value] : layer) square[cell] = value;
    known = next;
  }
  return square;
}

// Weights of the quarter points of bilinear interpolation between cell centres: 9, 3, 3, 1 sixteenths.
constexpr double near_weight = 0.75, far_weight = 0.25;

int folded(int i, int n, Surface surface) {
  return surface == Surface::periodic ? (i + n) % n : std::clamp(i, 0, n - 1);
}

}  // namespace

Grid coarser(const Grid& fine) { return {fine.nx / 2, fine.ny / 2, 2 * fine.dx, 2 * fine.dy}; }

std::vector<double> refine_pressure(const Grid& coarse, Surface surface, std::span<const double> pressure) {
  const std::vector<double> square = continued_square(coarse, surface, pressure);
  const Grid fine{2 * coarse.nx, 2 * coarse.ny, coarse.dx / 2, coarse.dy / 2};
  std::vector<double> result(fine.size());
  for (int j = 0; j < fine.ny; ++j) {
    const int near_row = j / 2, far_row = folded(j % 2 == 0 ? near_row - 1 : near_row + 1, coarse.ny, surface);
    const double* near = square.data() + coarse.index(0, near_row);
    const double* far = square.data() + coarse.index(0, far_row);
    for (int i = 0; i < fine.nx; ++i) {
      const int in = i / 2, out = folded(i % 2 == 0 ? in - 1 : in + 1, coarse.nx, surface);
      const double value = near_weight * (near_weight * near[in] + far_weight * near[out]) +
                           far_weight * (near_weight * far[in] + far_weight * far[out]);
      result[fine.index(i, j)] = value > 0 ? std::sqrt(value) : 0;
    }
  }
  return result;
}

std::vector<double> coarsen_pressure(const Grid& fine, std::span<const double> pressure) {
  const Grid coarse = coarser(fine);
  std::vector<double> result(coarse.size());
  for (int j = 0; j < coarse.ny; ++j) {
    const double* lower = pressure.data() + fine.index(0, 2 * j);
    const double* upper = pressure.data() + fine.index(0, 2 * j + 1);
    for (int i = 0; i < coarse.nx; ++i) {
      result[coarse.index(i, j)] = (lower[2 * i] + lower[2 * i + 1] + upper[2 * i] + upper[2 * i + 1]) / 4;
    }
  }
  return result;
}

std::vector<double> coarsen_gap(const Grid& fine, Surface surface, std::span<const double> gap) {
  constexpr std::array weights{-0.0625, 0.5625, 0.5625, -0.0625};
  const Grid coarse = coarser(fine);
  std::vector<double> result(coarse.size());
  for (int j = 0; j < coarse.ny; ++j) {
    for (int i = 0; i < coarse.nx; ++i) {
      double value = 0;
      for (int b = 0; b < 4; ++b) {
        const int row = folded(2 * j - 1 + b, fine.ny, surface);
        for (int a = 0; a < 4; ++a) {
          value += weights[static_cast<std::size_t>(a)] * weights[static_cast<std::size_t>(b)] *
                   gap[fine.index(folded(2 * i - 1 + a, fine.nx, surface), row)];
        }
      }
      const auto [least, most] =
          std::minmax({gap[fine.index(2 * i, 2 * j)], gap[fine.index(2 * i + 1, 2 * j)],
                       gap[fine.index(2 * i, 2 * j + 1)], gap[fine.index(2 * i + 1, 2 * j + 1)]});
      result[coarse.index(i, j)] = std::clamp(value, least, most);
    }
  }
  return result;
}

}  // namespace patchgrip::contact
