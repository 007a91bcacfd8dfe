#include <patchgrip/contact/half_space/contact_edge.h>
#include <patchgrip/contact/half_space/neighbours.h>
#include <patchgrip/contact/half_space/pieces.h>
#include <patchgrip/contact/half_space/vector_clones.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace patchgrip::contact {
namespace {

constexpr int skipped_layers = 2, narrow_skipped_layers = 1;
constexpr int least_radius = 4, most_radius = 7;
constexpr int least_cells = 9;
constexpr double least_pivot = 1e-10;
constexpr double area_units = 0x1p38;  // of a cell: integers add up to the same in any order, and to 2^24 cells

constexpr std::size_t terms = 6;      // 1, u, v, u^2/2, uv, v^2/2
constexpr std::size_t products = 24;  // of two terms, 21, filled up to whole vectors

constexpr std::size_t most_offsets = 225;  // (2 most_radius + 1)^2, more than there are in the disc

struct Offset {
  int u, v;
  std::array<double, 8> term{};
  std::array<double, products> product{};  // lower triangle, row by row
};

// The cells within the largest radius, in order of distance; within radius R lie the first counts[R].
struct Disc {
  std::vector<Offset> offsets;
  std::array<std::size_t, most_radius + 1> counts{};

  Disc() {
    for (int radius = 0; radius <= most_radius; ++radius) {
      for (int v = -radius; v <= radius; ++v) {
        for (int u = -radius; u <= radius; ++u) {
          const int square = u * u + v * v;
          const bool before = radius > 0 && square <= radius * (radius - 1);
          if (square <= radius * (radius + 1) && !before) offsets.push_back(of(u, v));
        }
      }
      counts[static_cast<std::size_t>(radius)] = offsets.size();
    }
  }

  static Offset of(int u, int v) {
    Offset offset{u, v};
    offset.term = {1., 1. * u, 1. * v, 0.5 * u * u, 1. * u * v, 0.5 * v * v};
    std::size_t k = 0;
    for (std::size_t r = 0; r < terms; ++r) {
      for (std::size_t s = 0; s <= r; ++s) offset.product[k++] = offset.term[r] * offset.term[s];
    }
    return offset;
  }
};

struct Sample {
  const Offset* offset;
  double value;
};

// Normal equations of the fit.
struct Normal {
  std::array<double, products> matrix{};
  std::array<double, 8> right{};
};

PATCHGRIP_VECTOR_CLONES void add_samples(std::size_t count, const Sample* samples, Normal& normal) {
  Normal sum = normal;
  for (std::size_t n = 0; n < count; ++n) {
    const Offset& offset = *samples[n].offset;
    for (std::size_t k = 0; k < products; ++k) sum.matrix[k] += offset.product[k];
    for (std::size_t k = 0; k < 8; ++k) sum.right[k] += samples[n].value * offset.term[k];
  }
  normal = sum;
}

// The fitted phi, edge_offset farther out, and with the mean of what lies between a quadratic and its linear
// interpolation on the triangles, a twelfth of its Laplacian; false if the normal equations are nearly singular.
bool solve(Normal normal, double& phi) {
  std::array<double, products>& matrix = normal.matrix;
  std::array<double, 8>& right = normal.right;
  const auto at = [&](std::size_t r, std::size_t s) -> double& { return matrix[r * (r + 1) / 2 + s]; };
  for (std::size_t k = terms; k-- > 0;) {
    if (at(k, k) < least_pivot) return false;
    for (std::size_t r = 0; r < k; ++r) {
      const double factor = at(k, r) / at(k, k);
      for (std::size_t s = 0; s <= r; ++s) at(r, s) -= factor * at(k, s);
      right[r] -= factor * right[k];
    }
  }
  std::array<double, terms> of_term{};
  for (std::size_t k = 0; k < terms; ++k) {
    double rest = right[k];
    for (std::size_t s = 0; s < k; ++s) rest -= at(k, s) * of_term[s];
    of_term[k] = rest / at(k, k);
  }
  const auto [value, along, across, along2, mixed, across2] = of_term;
  const double slope2 = along * along + across * across;
  const double bend =
      along2 * across * across - 2 * mixed * along * across + across2 * along * along;  // -slope^3 kappa
  const double rounded = slope2 > 0 ? edge_curvature_offset * bend / slope2 : 0;
  phi = value - edge_offset * std::sqrt(slope2) + rounded - (along2 + across2) / 12;
  return true;
}

class LevelSet {
 public:
  LevelSet(const Grid& grid, Surface surface, std::span<const double> pressure, const ZoneMap& map, Resources resources)
      : grid_(grid),
        surface_(surface),
        pressure_(pressure),
        map_(map),
        workers_(resources.workers),
        zones_(static_cast<std::size_t>(map.count)),
        phi_(grid.size(), resources.memory) {
    Pieces pieces(grid.size(), workers_);
    per_peak_ = 1 / pieces
                        .total([&](std::size_t begin, std::size_t count) {
                          const auto piece = pressure.subspan(begin, count);
                          return Tally{.largest = std::max(0., *std::ranges::max_element(piece))};
                        })
                        .largest;
    pieces.each([&](std::size_t begin, std::size_t count) {
      for (std::size_t cell = begin; cell < begin + count; ++cell) {
        phi_[cell] = pressure[cell] > 0 ? square(cell) : -std::numeric_limits<double>::min();
      }
    });
  }

  std::vector<ZoneArea> areas() {
    fit_layer(1);
    fit_layer(-1);
    fit_layer(2);
    fit_layer(-2);
    add_squares();
    for (const auto& [begin, end, row, zone] : map_.runs) zones_[static_cast<std::size_t>(zone)].cells += end - begin;
    std::vector<ZoneArea> result(zones_.size());
    for (std::size_t k = 0; k < result.size(); ++k) {
      const Zone& zone = zones_[k];
      const int edge_cells = zone.edge_cells, unfitted = std::min<int>(zone.unfitted, edge_cells);
      const int narrow = std::min<int>(zone.narrow, edge_cells - unfitted), wide = edge_cells - unfitted - narrow;
      result[k].resolved = 2 * unfitted <= edge_cells;
      const double edge = result[k].resolved
                              ? edge_error * wide + narrow_edge_error * narrow + counted_edge_error * unfitted
                              : counted_edge_error * edge_cells;
      constexpr double per_edge_cell = std::numbers::pi / 4;  // a circle of r cells has 8 r cells in its outer layer
      result[k].area =
          grid_.cell_area() * (result[k].resolved ? static_cast<double>(zone.area) / area_units : zone.cells);
      result[k].error = edge_cells > 0 ? grid_.cell_area() * std::max(per_edge_cell * edge, least_area_error) : 0;
    }
    return result;
  }

 private:
  double square(std::size_t cell) const noexcept {
    const double p = per_peak_ * pressure_[cell];
    return p * p;
  }

  // Fits phi in a layer; in the second layers only where the edge has crossed the first. Where that fails, or phi does
  // not fall to zero within the layers outside, phi stays what it was: the edge is then that of the cells.
  void fit_layer(int layer) {
    const bool second = layer == 2 || layer == -2;
    const auto is_crossed = [&](int i, int j) {
      bool crossed = false;
      visit_neighbours(grid_, surface_, i, j, [&](std::size_t near) {
        crossed |= map_.layer[near] == layer / 2 && (phi_[near] > 0) != (layer > 0);
      });
      return crossed;
    };
    workers_.each_row(grid_.ny, [&](int j, int) {
      map_.each_in_layer(grid_, j, layer, [&](int i) {
        const std::size_t cell = grid_.index(i, j);
        Zone& zone = zones_[static_cast<std::size_t>(map_.zone[cell])];
        if (layer == 1) ++zone.edge_cells;
        if (second && !is_crossed(i, j)) return;
        double value = 0;
        const bool is_wide = fit(i, j, skipped_layers, value);
        if ((is_wide || fit(i, j, narrow_skipped_layers, value)) && !(layer == -2 && value > 0)) {
          phi_[cell] = value;
          if (!is_wide) ++zone.narrow;
        } else {
          ++zone.unfitted;
        }
      });
    });
  }

  bool fit(int i, int j, int skipped, double& value) const {
    static const Disc disc;
    const int zone = map_.zone[grid_.index(i, j)];
    std::array<Sample, most_offsets> samples;
    Normal normal{};
    std::size_t next = 0;
    int cells = 0;
    const bool inside =
        i >= most_radius && j >= most_radius && i + most_radius < grid_.nx && j + most_radius < grid_.ny;
    for (int radius = least_radius; radius <= most_radius; ++radius) {
      std::size_t count = 0;
      const auto add = [&](const Offset& offset, std::size_t cell) {
        if (map_.layer[cell] > skipped && map_.zone[cell] == zone) samples[count++] = {&offset, square(cell)};
      };
      for (; next < disc.counts[static_cast<std::size_t>(radius)]; ++next) {
        const Offset& offset = disc.offsets[next];
        if (inside) {
          add(offset, grid_.index(i + offset.u, j + offset.v));
        } else {
          visit_cell(grid_, surface_, i + offset.u, j + offset.v, [&](std::size_t cell) { add(offset, cell); });
        }
      }
      add_samples(count, samples.data(), normal);
      cells += static_cast<int>(count);
      if (cells >= least_cells && solve(normal, value)) return true;
    }
    return false;
  }

  // Area in the squares between four cell centres, to the zone of their highest corner.
  void add_squares() {
    const bool wraps = surface_ == Surface::periodic;
    const int columns = wraps ? grid_.nx : grid_.nx - 1;
    workers_.each_row(wraps ? grid_.ny : grid_.ny - 1, [&](int j, int) {
      const int above = (j + 1) % grid_.ny;
      int zone = -1;
      std::int64_t area = 0;
      const auto add = [&](int to, double cells) {
        if (to != zone) {
          if (area != 0) zones_[static_cast<std::size_t>(zone)].area += area;
          zone = to;
          area = 0;
        }
        area += std::llround(cells * area_units);
      };
      for (int i = 0; i < columns; ++i) {
        const int right = (i + 1) % grid_.nx;
        const std::array corners{grid_.index(i, j), grid_.index(right, j), grid_.index(right, above),
                                 grid_.index(i, above)};
        if (map_.layer[corners[0]] == 0) continue;
        if (std::ranges::all_of(corners, [&](std::size_t corner) { return map_.layer[corner] > skipped_layers; })) {
          add(map_.zone[corners[0]], 1);
          continue;
        }
        std::size_t highest = corners[0];
        double least = phi_[corners[0]];
        for (const std::size_t corner : corners) {
          if (phi_[corner] > phi_[highest]) highest = corner;
          least = std::min(least, phi_[corner]);
        }
        if (phi_[highest] > 0 && map_.zone[highest] >= 0) add(map_.zone[highest], least > 0 ? 1 : cut_square(corners));
      }
      add(-1, 0);
    });
  }

  double cut_square(const std::array<std::size_t, 4>& corners) const {
    double centre = 0;
    for (const std::size_t corner : corners) centre += phi_[corner] / 4;
    double area = 0;
    for (std::size_t k = 0; k < 4; ++k) area += triangle(phi_[corners[k]], phi_[corners[(k + 1) % 4]], centre) / 4;
    return area;
  }

  // Fraction of a triangle where the linear function with these values at the corners is positive.
  static double triangle(double a, double b, double c) {
    const int positive = (a > 0) + (b > 0) + (c > 0);
    if (positive == 0) return 0;
    if (positive == 3) return 1;
    const bool most = positive == 2;
    if (most) a = -a, b = -b, c = -c;
    // Now the highest corner is alone above zero: it comes to the front.
    if (b > a) std::swap(a, b);
    if (c > a) std::swap(a, c);
    const double corner = a / (a - b) * (a / (a - c));
    return most ? 1 - corner : corner;
  }

  const Grid& grid_;
  Surface surface_;
  std::span<const double> pressure_;
  const ZoneMap& map_;
  Workers& workers_;
  double per_peak_ = 0;
  struct Zone {
    int cells = 0;
    std::atomic<int> edge_cells = 0, narrow = 0, unfitted = 0;
    std::atomic<std::int64_t> area = 0;  // in 1 / area_units of a cell
  };
  std::vector<Zone> zones_;
  Array<double> phi_;
};

}  // namespace

std::vector<ZoneArea> zone_areas(const Grid& grid, Surface surface, std::span<const double> pressure,
                                 const ZoneMap& map, Resources resources) {
  if (map.count == 0) return {};
  return LevelSet(grid, surface, pressure, map, resources).areas();
}

}  // namespace patchgrip::contact
