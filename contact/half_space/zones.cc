#include <patchgrip/contact/half_space/cell_mask.h>
#include <patchgrip/contact/half_space/neighbours.h>
#include <patchgrip/contact/half_space/zones.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace patchgrip::contact {
namespace {

// Runs of cells in a row, joined to zones by a forest of parents.
class Runs {
 public:
  Runs(const Grid& grid, Surface surface, std::span<const double> pressure) : grid_(grid), rows_{0} {
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx;) {
        if (!(pressure[grid.index(i, j)] > 0)) {
          ++i;
          continue;
        }
        const int begin = i;
        while (i < grid.nx && pressure[grid.index(i, j)] > 0) ++i;
        runs_.push_back({begin, i, j});
      }
      rows_.push_back(runs_.size());
    }
    parents_.resize(runs_.size());
    std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    for (int j = 1; j < grid.ny; ++j) join_rows(j - 1, j, 0);
    if (surface == Surface::periodic) {
      join_rows(grid.ny - 1, 0, 0);
      for (int j = 0; j < grid.ny; ++j) {
        for (const int other : {j, (j + 1) % grid.ny, (j + grid.ny - 1) % grid.ny}) join_rows(j, other, grid.nx);
      }
    }
  }

  // Writes the zone of every cell in contact; returns the number of zones.
  int label(std::vector<int>& zones) {
    std::vector<int> names(runs_.size(), -1);
    int count = 0;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      int& name = names[root(k)];
      if (name < 0) name = count++;
      const auto [begin, end, row] = runs_[k];
      std::fill_n(&zones[grid_.index(begin, row)], end - begin, name);
    }
    return count;
  }

 private:
  struct Run {
    int begin, end, row;
  };

  std::size_t root(std::size_t k) {
    while (parents_[k] != k) k = parents_[k] = parents_[parents_[k]];
    return k;
  }

  // Joins the runs of two rows that touch, the second row moved by `shift` cells.
  void join_rows(int first, int second, int shift) {
    const auto at = [&](int row) { return rows_[static_cast<std::size_t>(row)]; };
    std::size_t b = at(second);
    for (std::size_t a = at(first); a < at(first + 1); ++a) {
      while (b < at(second + 1) && runs_[b].end + shift < runs_[a].begin) ++b;
      for (std::size_t c = b; c < at(second + 1) && runs_[c].begin + shift <= runs_[a].end; ++c) {
        parents_[std::max(root(a), root(c))] = std::min(root(a), root(c));
      }
    }
  }

  const Grid& grid_;
  std::vector<Run> runs_;
  std::vector<std::size_t> rows_;  // first run of each row
  std::vector<std::size_t> parents_;
};

}  // namespace

ZoneMap map_zones(const Grid& grid, Surface surface, std::span<const double> pressure) {
  ZoneMap map{0, std::vector<int>(grid.size(), -1), std::vector<signed char>(grid.size(), 0)};
  map.count = Runs(grid, surface, pressure).label(map.zone);

  const CellMasks masks(grid, surface);
  const Mask on = masks.pressed(pressure);
  const Mask second = masks.eroded(on), third = masks.eroded(second);
  const Mask around = masks.dilated(on), farther = masks.dilated(around);
  for (int j = 0; j < grid.ny; ++j) {
    signed char* layer = &map.layer[grid.index(0, j)];
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t k = masks.index(i, j);
      const int inside = on[k] + second[k] + third[k], outside = farther[k] + around[k];
      layer[i] = static_cast<signed char>(on[k] != 0 ? inside : outside == 0 ? 0 : outside - 3);
    }
  }
  for (const int ring : {-1, -2}) {
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        if (map.layer[grid.index(i, j)] != ring) continue;
        int& zone = map.zone[grid.index(i, j)];
        visit_neighbours(grid, surface, i, j, [&](std::size_t near) {
          const int layer = map.layer[near];
          if (zone < 0 && (layer > 0 || layer == ring + 1)) zone = map.zone[near];
        });
      }
    }
  }
  return map;
}

}  // namespace patchgrip::contact
