#include <patchgrip/friction/sampled/grid_pieces.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <patchgrip/friction/sampled/gauss_rule.h>

namespace patchgrip::friction::kernels {
namespace {

constexpr std::size_t vector_width = 8;

// Integrals of the Lagrange polynomials of [centre - half, centre + half] over each of n cells; the rule is exact for
// their degree.
std::vector<double> line_loads(const double* lines, std::size_t n, double centre, double half, int order) {
  const auto points = static_cast<std::size_t>(order);
  std::vector<double> loads(n * points), values(points);
  for (std::size_t i = 0; i < n; ++i) {
    const double middle = (lines[i] + lines[i + 1]) / 2 - centre;
    const double h = (lines[i + 1] - lines[i]) / 2;
    for (const auto& [t, weight] : gauss_rule(order / 2)) {
      lagrange(order, (middle + h * t) / half, values);
      for (std::size_t m = 0; m < points; ++m) loads[i * points + m] += h * weight * values[m];
    }
  }
  return loads;
}

// Cuts [begin, end) into one or two, at a multiple of `step` from the beginning.
std::vector<std::pair<std::size_t, std::size_t>> cut(std::size_t begin, std::size_t end, std::size_t step,
                                                     bool in_two) {
  if (!in_two) return {{begin, end}};
  const std::size_t steps = (end - begin + step - 1) / step;
  const std::size_t middle = begin + (steps + 1) / 2 * step;
  return {{begin, middle}, {middle, end}};
}

}  // namespace

GridPieces::GridPieces(std::vector<double> x, std::vector<double> y, std::vector<double> pressures, Lanes lanes)
    : nx_(x.size() - 1),
      ny_(y.size() - 1),
      lanes_(lanes == Lanes::eight  ? 8
             : lanes == Lanes::four ? 4
                                    : 2),
      x_(std::move(x)),
      y_(std::move(y)),
      pressures_(std::move(pressures)) {
  x_.resize(x_.size() + vector_width, x_.back());
  gradient_ = corner_kernel(Derivatives::first, lanes);
  hessian_ = corner_kernel(Derivatives::second, lanes);
}

bool GridPieces::loaded(const CellRange& range) const noexcept {
  for (std::size_t j = range.j0; j < range.j1; ++j) {
    const double* row = &pressures_[j * nx_];
    if (std::any_of(row + range.i0, row + range.i1, [](double p) { return p > 0; })) return true;
  }
  return false;
}

Box GridPieces::box_of(const CellRange& r) const noexcept {
  return {(x_[r.i0] + x_[r.i1]) / 2, (y_[r.j0] + y_[r.j1]) / 2, (x_[r.i1] - x_[r.i0]) / 2, (y_[r.j1] - y_[r.j0]) / 2};
}

std::vector<PressureNode> GridPieces::make_tree(std::size_t columns, std::size_t rows) {
  std::vector<PressureNode> nodes;
  std::vector<CellRange> ranges;
  const auto append = [&](const CellRange& range) {
    nodes.push_back({.box = box_of(range)});
    ranges.push_back(range);
  };
  append({0, nx_, 0, ny_});
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const CellRange r = ranges[k];
    const Box box = nodes[k].box;
    const bool wide = r.columns() > columns, high = r.rows() > rows;
    if (!wide && !high) {
      nodes[k].leaf = static_cast<std::uint32_t>(leaves_.size());
      add_leaf(r);
      continue;
    }
    nodes[k].first_child = static_cast<std::uint32_t>(nodes.size());
    for (const auto& [j0, j1] : cut(r.j0, r.j1, rows, high && (!wide || 2 * box.hy > box.hx))) {
      for (const auto& [i0, i1] : cut(r.i0, r.i1, columns, wide && (!high || 2 * box.hx > box.hy))) {
        if (loaded({i0, i1, j0, j1})) append({i0, i1, j0, j1});
      }
    }
    nodes[k].children = static_cast<std::uint32_t>(nodes.size()) - nodes[k].first_child;
  }
  return nodes;
}

void GridPieces::add_leaf(const CellRange& r) {
  const auto pressure = [&](std::size_t i, std::size_t j) {  // 0 outside of the range; i, j one too large
    return i > r.i0 && i <= r.i1 && j > r.j0 && j <= r.j1 ? pressures_[(j - 1) * nx_ + i - 1] : 0;
  };
  const std::size_t columns = (r.columns() + vector_width) / vector_width * vector_width;
  Leaf leaf{r, columns, corners_.size(), spans_.size(), 0};
  for (std::size_t j = r.j0; j <= r.j1; ++j) {
    CornerSpan span{columns, 0};
    for (std::size_t k = 0; k < columns; ++k) {
      const std::size_t i = r.i0 + k;
      const double c = (pressure(i + 1, j + 1) - pressure(i, j + 1)) - (pressure(i + 1, j) - pressure(i, j));
      corners_.push_back(c);
      leaf.bends += std::fabs(c);
      if (c == 0) continue;
      const std::size_t whole = k / lanes_ * lanes_;
      span = {std::min(span.begin, whole), whole + lanes_};
    }
    span.begin = std::min(span.begin, span.end);
    spans_.push_back(span);
  }
  leaves_.push_back(leaf);
}

void GridPieces::add(std::size_t k, double X, double Y, Derivatives derivatives, DistanceSums& sums) const noexcept {
  const Leaf& leaf = leaves_[k];
  const CornerBlock block{&x_[leaf.range.i0],  &y_[leaf.range.j0], &corners_[leaf.corners],
                          &spans_[leaf.spans], leaf.columns,       leaf.range.rows() + 1};
  (derivatives == Derivatives::first ? gradient_ : hessian_)(block, X, Y, sums);
}

void GridPieces::add_excess(std::size_t k, const Twist& u, StribeckSums& sums) const noexcept {
  const CellRange& r = leaves_[k].range;
  for (std::size_t j = r.j0; j < r.j1; ++j) {
    for (std::size_t i = r.i0; i < r.i1; ++i) {
      const double p = pressures_[j * nx_ + i];
      if (p == 0) continue;
      const LoadedPiece cell{{x_[i], x_[i + 1], x_[i + 1], x_[i]}, {y_[j], y_[j], y_[j + 1], y_[j + 1]}, 4, p, 0, 0, p};
      kernels::add_excess(cell, u, sums);
    }
  }
}

Roughness GridPieces::roughness(std::size_t k) const { return {0, leaves_[k].bends}; }

void GridPieces::add_loads(std::size_t k, const Box& box, const LoadRule& rule, double* loads) const {
  const CellRange& r = leaves_[k].range;
  const auto n = static_cast<std::size_t>(rule.order);
  const std::vector<double> across = line_loads(&x_[r.i0], r.columns(), box.x, box.hx, rule.order);
  const std::vector<double> along = line_loads(&y_[r.j0], r.rows(), box.y, box.hy, rule.order);
  std::vector<double> row(n);
  for (std::size_t j = 0; j < r.rows(); ++j) {
    std::ranges::fill(row, 0);
    for (std::size_t i = 0; i < r.columns(); ++i) {
      const double p = pressures_[(r.j0 + j) * nx_ + r.i0 + i];
      if (p == 0) continue;
      for (std::size_t m = 0; m < n; ++m) row[m] += p * across[i * n + m];
    }
    for (std::size_t l = 0; l < n; ++l) {
      const double weight = along[j * n + l];
      for (std::size_t m = 0; m < n; ++m) loads[l * n + m] += weight * row[m];
    }
  }
}

}  // namespace patchgrip::friction::kernels
