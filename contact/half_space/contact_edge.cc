#include <patchgrip/contact/half_space/contact_edge.h>
#include <patchgrip/contact/half_space/neighbours.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace patchgrip::contact {
namespace {

constexpr int skipped_layers = 2;
constexpr int least_radius = 4, most_radius = 7;
constexpr int least_cells = 9;
constexpr double least_pivot = 1e-10;

constexpr std::size_t terms = 6;      // 1, u, v, u^2/2, uv, v^2/2
constexpr std::size_t products = 24;  // of two terms, 21, filled up to whole vectors

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

// First unknown of the normal equations, by Cholesky's factors; false if they are nearly singular.
bool solve_first(std::array<double, products> matrix, std::array<double, 8> right, double& first) {
  const auto at = [&](std::size_t r, std::size_t s) -> double& { return matrix[r * (r + 1) / 2 + s]; };
  // From the last term to the first, so that the first unknown needs no substitution back.
  for (std::size_t k = terms; k-- > 1;) {
    if (at(k, k) < least_pivot) return false;
    for (std::size_t r = 0; r < k; ++r) {
      const double factor = at(k, r) / at(k, k);
      for (std::size_t s = 0; s <= r; ++s) at(r, s) -= factor * at(k, s);
      right[r] -= factor * right[k];
    }
  }
  if (at(0, 0) < least_pivot) return false;
  first = right[0] / at(0, 0);
  return true;
}

class LevelSet {
 public:
  LevelSet(const Grid& grid, Surface surface, std::span<const double> pressure, const ZoneMap& map)
      : grid_(grid), surface_(surface), map_(map), square_(grid.size()), phi_(grid.size()) {
    const double peak = *std::ranges::max_element(pressure);
    for (std::size_t cell = 0; cell < grid.size(); ++cell) {
      const double p = pressure[cell] / peak;
      square_[cell] = p > 0 ? p * p : -std::numeric_limits<double>::min();
    }
    phi_ = square_;
  }

  std::vector<ZoneArea> areas(std::span<const double> pressure) {
    std::vector<ZoneArea> result(static_cast<std::size_t>(map_.count), {0, true});
    fit_layer(1, result);
    fit_layer(-1, result);
    fit_layer(2, result);
    fit_layer(-2, result);
    add_squares(result);
    std::vector<double> counted(result.size());
    for (std::size_t cell = 0; cell < grid_.size(); ++cell) {
      if (pressure[cell] > 0) counted[static_cast<std::size_t>(map_.zone[cell])] += grid_.cell_area();
    }
    for (std::size_t zone = 0; zone < result.size(); ++zone) {
      result[zone].area = result[zone].resolved ? result[zone].area * grid_.cell_area() : counted[zone];
    }
    return result;
  }

 private:
  // Fits phi in a layer; in the second layers only where the edge has crossed the first. Where phi cannot be fitted, or does
  // not fall to zero within the layers outside, the zone is not resolved.
  void fit_layer(int layer, std::vector<ZoneArea>& result) {
    for (int j = 0; j < grid_.ny; ++j) {
      for (int i = 0; i < grid_.nx; ++i) {
        const std::size_t cell = grid_.index(i, j);
        if (map_.layer[cell] != layer) continue;
        bool needed = layer == 1 || layer == -1;
        if (!needed) {
          visit_neighbours(grid_, surface_, i, j, [&](std::size_t near) { needed |= (phi_[near] > 0) != (layer > 0); });
        }
        if (!needed) continue;
        double value = 0;
        const bool fitted = fit(i, j, value);
        if (!fitted || (layer == -2 && value > 0)) result[static_cast<std::size_t>(map_.zone[cell])].resolved = false;
        if (fitted) phi_[cell] = value;
      }
    }
  }

  bool fit(int i, int j, double& value) const {
    static const Disc disc;
    const int zone = map_.zone[grid_.index(i, j)];
    std::array<double, products> matrix{};
    std::array<double, 8> right{};
    int cells = 0;
    const auto add = [&](const Offset& offset, std::size_t cell) {
      if (map_.layer[cell] <= skipped_layers || map_.zone[cell] != zone) return;
      ++cells;
      for (std::size_t k = 0; k < products; ++k) matrix[k] += offset.product[k];
      for (std::size_t k = 0; k < 8; ++k) right[k] += square_[cell] * offset.term[k];
    };
    const bool inside =
        i >= most_radius && j >= most_radius && i + most_radius < grid_.nx && j + most_radius < grid_.ny;
    std::size_t next = 0;
    for (int radius = least_radius; radius <= most_radius; ++radius) {
      for (; next < disc.counts[static_cast<std::size_t>(radius)]; ++next) {
        const Offset& offset = disc.offsets[next];
        if (inside) {
          add(offset, grid_.index(i + offset.u, j + offset.v));
        } else {
          visit_cell(grid_, surface_, i + offset.u, j + offset.v, [&](std::size_t cell) { add(offset, cell); });
        }
      }
      if (cells >= least_cells && solve_first(matrix, right, value)) return true;
    }
    return false;
  }

  // Cells of area in the squares between four cell centres, to the zone of their highest corner.
  void add_squares(std::vector<ZoneArea>& result) const {
    const bool wraps = surface_ == Surface::periodic;
    for (int j = 0; j + (wraps ? 0 : 1) < grid_.ny; ++j) {
      const int above = (j + 1) % grid_.ny;
      for (int i = 0; i + (wraps ? 0 : 1) < grid_.nx; ++i) {
        const int right = (i + 1) % grid_.nx;
        const std::array corners{grid_.index(i, j), grid_.index(right, j), grid_.index(right, above),
                                 grid_.index(i, above)};
        std::size_t highest = corners[0];
        double least = phi_[corners[0]];
        for (const std::size_t corner : corners) {
          if (phi_[corner] > phi_[highest]) highest = corner;
          least = std::min(least, phi_[corner]);
        }
        if (phi_[highest] <= 0 || map_.zone[highest] < 0) continue;
        double& area = result[static_cast<std::size_t>(map_.zone[highest])].area;
        area += least > 0 ? 1 : cut_square(corners);
      }
    }
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
  const ZoneMap& map_;
  std::vector<double> square_, phi_;
};

}  // namespace

std::vector<ZoneArea> zone_areas(const Grid& grid, Surface surface, std::span<const double> pressure,
                                 const ZoneMap& map) {
  if (map.count == 0) return {};
  return LevelSet(grid, surface, pressure, map).areas(pressure);
}

}  // namespace patchgrip::contact
