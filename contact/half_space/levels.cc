#include <patchgrip/contact/half_space/coarse_to_fine.h>
#include <patchgrip/contact/half_space/levels.h>

#include <algorithm>
#include <utility>

namespace patchgrip::contact {
namespace {

constexpr int coarsest_cells = 32;

// How often the sides can be halved, or must be.
int halvings(const Grid& grid) {
  int count = 0;
  for (int n = std::min(grid.nx, grid.ny) / 2; n >= coarsest_cells; n /= 2) ++count;
  return std::max(count, 1);
}

int round_up(int n, int unit) { return (n + unit - 1) / unit * unit; }

Level extended(const Grid& grid, std::span<const double> gap, double least, int unit, Resources resources) {
  const Grid large{round_up(grid.nx, unit), round_up(grid.ny, unit), grid.dx, grid.dy};
  Array<double> field(large.size(), resources.memory);
  resources.workers.each_row(large.ny, [&](int j, int) {
    const double* from = &gap[grid.index(0, std::min(j, grid.ny - 1))];
    double* to = &field[large.index(0, j)];
    for (int i = 0; i < grid.nx; ++i) to[i] = from[i] - least;
    std::fill(to + grid.nx, to + large.nx, to[grid.nx - 1]);
  });
  return {large, std::move(field)};
}

}  // namespace

std::vector<Level> make_levels(const Grid& grid, Surface surface, std::span<const double> gap, double least,
                               Resources resources) {
  std::vector<Level> levels;
  int count = halvings(grid);
  if (surface == Surface::periodic) {
    while (grid.nx % (1 << count) != 0 || grid.ny % (1 << count) != 0) --count;
  }
  levels.push_back(extended(grid, gap, least, 1 << count, resources));
  for (; count > 0; --count) {
    const Level& fine = levels.back();
    levels.push_back({coarser(fine.grid), coarsen_gap(fine.grid, surface, fine.gap, resources)});
  }
  std::ranges::reverse(levels);
  return levels;
}

}  // namespace patchgrip::contact
