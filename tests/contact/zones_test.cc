#include <patchgrip/contact/half_space/zones.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchgrip::contact {
namespace {

std::vector<double> random_cells(const Grid& grid, unsigned seed, double density) {
  std::mt19937_64 engine(seed);
  std::vector<double> field(grid.size());
  for (double& p : field) p = std::uniform_real_distribution<double>(0, 1)(engine) < density ? 1 : 0;
  return field;
}

// Distance in cells, as a king moves.
int apart(const Grid& grid, Surface surface, int i, int j, int k, int l) {
  int dx = std::abs(i - k), dy = std::abs(j - l);
  if (surface == Surface::periodic) dx = std::min(dx, grid.nx - dx), dy = std::min(dy, grid.ny - dy);
  return std::max(dx, dy);
}

// Naively: the distance to the nearest cell of the other kind; beyond the border of a free grid nothing touches.
int layer(const Grid& grid, Surface surface, const std::vector<double>& field, int i, int j) {
  const bool on = field[grid.index(i, j)] > 0;
  int least = 99;
  for (int l = 0; l < grid.ny; ++l) {
    for (int k = 0; k < grid.nx; ++k) {
      if ((field[grid.index(k, l)] > 0) != on) least = std::min(least, apart(grid, surface, i, j, k, l));
    }
  }
  if (on && surface == Surface::free) least = std::min({least, i + 1, j + 1, grid.nx - i, grid.ny - j});
  if (on) return std::min(least, ZoneMap::deepest_layer);
  return least <= 2 ? -least : 0;
}

RC_GTEST_PROP(ZoneMap, LayersAreDistancesToTheEdge, ()) {
  const Grid grid = Grid::of_cells(*rc::gen::inRange(8, 14), *rc::gen::inRange(8, 14), 1, 1);
  for (const Surface surface : {Surface::free, Surface::periodic}) {
    const auto field = random_cells(grid, *rc::gen::arbitrary<unsigned>(), 0.01 * *rc::gen::inRange(1, 100));
    Workers workers(*rc::gen::inRange(1, 3));
    const ZoneMap map = map_zones(grid, surface, field, {workers});
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i)
        RC_ASSERT(int{map.layer[grid.index(i, j)]} == layer(grid, surface, field, i, j));
    }
  }
}

// Against a flood from each cell.
RC_GTEST_PROP(ZoneMap, ZonesAreConnectedAndApart, ()) {
  const Grid grid = Grid::of_cells(*rc::gen::inRange(8, 14), *rc::gen::inRange(8, 14), 1, 1);
  for (const Surface surface : {Surface::free, Surface::periodic}) {
    const auto field = random_cells(grid, *rc::gen::arbitrary<unsigned>(), 0.01 * *rc::gen::inRange(1, 80));
    Workers workers(*rc::gen::inRange(1, 3));
    const ZoneMap map = map_zones(grid, surface, field, {workers});
    std::vector<int> flooded(grid.size(), -1);
    int count = 0;
    const std::function<void(int, int)> flood = [&](int i, int j) {
      for (int l = 0; l < grid.ny; ++l) {
        for (int k = 0; k < grid.nx; ++k) {
          const std::size_t cell = grid.index(k, l);
          if (!(field[cell] > 0) || flooded[cell] >= 0 || apart(grid, surface, i, j, k, l) > 1) continue;
          flooded[cell] = count;
          flood(k, l);
        }
      }
    };
    for (int j = 0; j < grid.ny; ++j) {
      for (int i = 0; i < grid.nx; ++i) {
        const std::size_t cell = grid.index(i, j);
        if (!(field[cell] > 0) || flooded[cell] >= 0) continue;
        flooded[cell] = count;
        flood(i, j);
        ++count;
      }
    }
    RC_ASSERT(map.count == count);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      if (field[cell] > 0) {
        RC_ASSERT(map.zone[cell] == flooded[cell]);
      } else {
        RC_ASSERT((map.zone[cell] >= 0) == (map.layer[cell] < 0));
      }
    }
  }
}

}  // namespace
}  // namespace patchgrip::contact
