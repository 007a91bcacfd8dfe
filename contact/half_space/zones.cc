#include <patchgrip/contact/half_space/cell_mask.h>
#include <patchgrip/contact/half_space/neighbours.h>
#include <patchgrip/contact/half_space/zones.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

namespace patchgrip::contact {
namespace {

// Joins the runs of cells to zones by a forest of parents.
class Forest {
 public:
  Forest(const Grid& grid, Surface surface, std::vector<ZoneMap::Run>& runs) : runs_(runs) {
    rows_.reserve(static_cast<std::size_t>(grid.ny) + 1);
    for (std::size_t k = 0; k <= runs.size(); ++k) {
      const auto rows = static_cast<std::size_t>(k < runs.size() ? runs[k].row : grid.ny);
      while (rows_.size() <= rows) rows_.push_back(k);
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

  // Numbers the zones of the runs; returns how many there are.
  int number() {
    std::vector<int> names(runs_.size(), -1);
    int count = 0;
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      int& name = names[root(k)];
      if (name < 0) name = count++;
      runs_[k].zone = name;
    }
    return count;
  }

 private:
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

  std::vector<ZoneMap::Run>& runs_;
  std::vector<std::size_t> rows_;  // first run of each row
  std::vector<std::size_t> parents_;
};

std::vector<ZoneMap::Run> runs_of(const Grid& grid, const CellMasks& masks, const Mask& on) {
  std::vector<ZoneMap::Run> runs;
  for (int j = 0; j < grid.ny; ++j) {
    const unsigned char* row = &on[masks.index(0, j)];
    const auto next = [&](int i, int value) {
      const void* found = std::memchr(row + i, value, static_cast<std::size_t>(grid.nx - i));
      return found == nullptr ? grid.nx : static_cast<int>(static_cast<const unsigned char*>(found) - row);
    };
    for (int begin = next(0, 1); begin < grid.nx;) {
      const int end = next(begin, 0);
      runs.push_back({begin, end, j, -1});
      begin = next(end, 1);
    }
  }
  return runs;
}

}  // namespace

ZoneMap map_zones(const Grid& grid, Surface surface, std::span<const double> pressure, Resources resources) {
  const CellMasks masks(grid, surface, resources);
  const Mask on = masks.pressed(pressure);
  const Mask second = masks.eroded(on), third = masks.eroded(second);
  const Mask around = masks.dilated(on), farther = masks.dilated(around);

  ZoneMap map{.count = 0,
              .runs = runs_of(grid, masks, on),
              .zone = {grid.size(), resources.memory},
              .layer = {grid.size(), resources.memory}};
  map.count = Forest(grid, surface, map.runs).number();
  resources.workers.each_row(grid.ny, [&](int j, int) {
    signed char* layer = &map.layer[grid.index(0, j)];
    for (int i = 0; i < grid.nx; ++i) {
      const std::size_t k = masks.index(i, j);
      const int inside = on[k] + second[k] + third[k], outside = farther[k] + around[k];
      layer[i] = static_cast<signed char>(on[k] != 0 ? inside : outside == 0 ? 0 : outside - 3);
    }
    std::fill_n(&map.zone[grid.index(0, j)], grid.nx, -1);
  });
  resources.workers.each_row(static_cast<int>(map.runs.size()), [&](int k, int) {
    const auto& [begin, end, row, zone] = map.runs[static_cast<std::size_t>(k)];
    std::fill_n(&map.zone[grid.index(begin, row)], end - begin, zone);
  });
  for (const int ring : {-1, -2}) {
    resources.workers.each_row(grid.ny, [&](int j, int) {
      map.each_in_layer(grid, j, ring, [&](int i) {
        int& zone = map.zone[grid.index(i, j)];
        visit_neighbours(grid, surface, i, j, [&](std::size_t near) {
          const int layer = map.layer[near];
          if (zone < 0 && (layer > 0 || layer == ring + 1)) zone = map.zone[near];
        });
      });
    });
  }
  return map;
}

}  // namespace patchgrip::contact
