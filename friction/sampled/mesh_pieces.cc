#include <patchgrip/friction/sampled/mesh_pieces.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <patchgrip/friction/sampled/gauss_rule.h>

namespace patchgrip::friction::kernels {
namespace {

// What meets at an edge, from its lower to its higher point.
struct Jump {
  double at_start = 0, at_end = 0;
  double normal_slope = 0;
};

// Points per side of a product rule that integrates the kernel over a triangle with edges up to `size` half diagonals
// of its box, for poles from the reach on: its singularity is at least reach - 1 away, beside the triangle at the
// worst. What is interpolated is a polynomial: order + 1 points are enough for any.
int points_per_side(double size, const LoadRule& rule) {
  const double away = 2 * (rule.reach - 1) / size;
  const double rho = away + std::sqrt(away * away + 1);
  const double count = std::ceil(std::log(16 / rule.tolerance) / (2 * std::log(rho)));
  return std::clamp(static_cast<int>(count), 2, rule.order + 1);
}

}  // namespace

MeshPieces::MeshPieces(std::vector<double> x, std::vector<double> y, std::vector<LoadedTriangle> triangles)
    : x_(std::move(x)), y_(std::move(y)), triangles_(std::move(triangles)) {
  const Lanes lanes = widest_lanes();
  gradient_ = edge_kernel(Derivatives::first, lanes);
  hessian_ = edge_kernel(Derivatives::second, lanes);
}

Box MeshPieces::box_of(const Range& range) const noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double x0 = infinity, x1 = -infinity, y0 = infinity, y1 = -infinity;
  for (std::size_t t = range.begin; t < range.end; ++t) {
    for (const std::size_t i : triangles_[t].corners) {
      x0 = std::min(x0, x_[i]);
      x1 = std::max(x1, x_[i]);
      y0 = std::min(y0, y_[i]);
      y1 = std::max(y1, y_[i]);
    }
  }
  return {(x0 + x1) / 2, (y0 + y1) / 2, (x1 - x0) / 2, (y1 - y0) / 2};
}

// Cuts the longer side of the box around the triangles' centroids: in the middle, or so that either half has as many.
std::vector<MeshPieces::Range> MeshPieces::halves(const Range& range, Cut way) {
  const auto x = [this](const LoadedTriangle& t) { return x_[t.corners[0]] + x_[t.corners[1]] + x_[t.corners[2]]; };
  const auto y = [this](const LoadedTriangle& t) { return y_[t.corners[0]] + y_[t.corners[1]] + y_[t.corners[2]]; };
  const auto begin = triangles_.begin() + static_cast<std::ptrdiff_t>(range.begin);
  const auto end = triangles_.begin() + static_cast<std::ptrdiff_t>(range.end);
  const auto [left, right] = std::ranges::minmax_element(begin, end, {}, x);
  const auto [low, high] = std::ranges::minmax_element(begin, end, {}, y);
  const double x0 = x(*left), x1 = x(*right), y0 = y(*low), y1 = y(*high);
  const bool wide = x1 - x0 > y1 - y0;
  auto middle = begin;
  if (way == Cut::middle) {
    middle = wide ? std::partition(begin, end, [&](const auto& t) { return x(t) < (x0 + x1) / 2; })
                  : std::partition(begin, end, [&](const auto& t) { return y(t) < (y0 + y1) / 2; });
  }
  // The median; also of triangles on top of one another.
  if (middle == begin || middle == end) {
    middle = begin + (end - begin) / 2;
    if (wide) {
      std::ranges::nth_element(begin, middle, end, {}, x);
    } else {
      std::ranges::nth_element(begin, middle, end, {}, y);
    }
  }
  const auto cut = static_cast<std::size_t>(middle - triangles_.begin());
  return {{range.begin, cut}, {cut, range.end}};
}

std::vector<PressureNode> MeshPieces::make_tree(std::size_t count) {
  std::vector<PressureNode> nodes;
  std::vector<Range> ranges;
  std::vector<std::uint32_t> levels;
  const auto append = [&](const Range& range, std::uint32_t level) {
    nodes.push_back({.box = box_of(range)});
    ranges.push_back(range);
    levels.push_back(level);
  };
  append({0, triangles_.size()}, 0);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Range whole = ranges[k];
    if (whole.end - whole.begin <= count) {
      nodes[k].leaf = static_cast<std::uint32_t>(leaves_.size());
      add_leaf(whole);
      continue;
    }
    nodes[k].first_child = static_cast<std::uint32_t>(nodes.size());
    const std::uint32_t level = levels[k];
    const Cut way = level < PressureNode::most_levels - 32 ? Cut::middle : Cut::median;
    for (const Range& half : halves(whole, way)) {
      if (half.end - half.begin <= count) {
        append(half, level + 1);
      } else {
        for (const Range& quarter : halves(half, way)) append(quarter, level + 1);
      }
    }
    nodes[k].children = static_cast<std::uint32_t>(nodes.size()) - nodes[k].first_child;
  }
  return nodes;
}

void MeshPieces::add_leaf(const Range& range) {
  std::map<std::pair<std::size_t, std::size_t>, Jump> jumps;
  for (std::size_t k = range.begin; k < range.end; ++k) {
    const auto& [corners, p] = triangles_[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, other = (i + 2) % 3;
      const std::size_t a = corners[i], b = corners[j], c = corners[other];
      const double ex = x_[b] - x_[a], ey = y_[b] - y_[a];
      const double l = std::hypot(ex, ey);
      const double height = (ex * (y_[c] - y_[a]) - ey * (x_[c] - x_[a])) / l;
      const double foot = (ex * (x_[c] - x_[a]) + ey * (y_[c] - y_[a])) / (l * l);  // of the other corner
      // Outwards; against the edge's own direction everything changes its sign but the slope, which does so twice.
      const double slope = -((p[other] - p[i]) - (p[j] - p[i]) * foot) / height;
      const double sign = a < b ? 1 : -1;
      Jump& jump = jumps[std::minmax(a, b)];
      jump.at_start += sign * (a < b ? p[i] : p[j]);
      jump.at_end += sign * (a < b ? p[j] : p[i]);
      jump.normal_slope += slope;
    }
  }
  Leaf leaf{range, {edges_.size(), 0}, {}};
  for (const auto& [ends, jump] : jumps) {
    if (jump.at_start == 0 && jump.at_end == 0 && jump.normal_slope == 0) continue;
    const auto [a, b] = ends;
    const double l = std::hypot(x_[b] - x_[a], y_[b] - y_[a]);
    edges_.add(x_[a], y_[a], x_[b], y_[b], jump.at_start, jump.normal_slope, (jump.at_end - jump.at_start) / l);
    leaf.roughness.jumps += l * std::max(std::fabs(jump.at_start), std::fabs(jump.at_end));
    leaf.roughness.bends += l * std::fabs(jump.normal_slope) + std::fabs(jump.at_end - jump.at_start);
  }
  edges_.pad();
  leaf.edges.end = edges_.size();
  leaves_.push_back(leaf);
}

void MeshPieces::add(std::size_t k, double X, double Y, Derivatives derivatives, DistanceSums& sums) const noexcept {
  const Range& edges = leaves_[k].edges;
  (derivatives == Derivatives::first ? gradient_ : hessian_)(edges_, edges.begin, edges.end, X, Y, sums);
}

void MeshPieces::add_excess(std::size_t k, const Twist& u, StribeckSums& sums) const noexcept {
  const Range& range = leaves_[k].triangles;
  for (std::size_t t = range.begin; t < range.end; ++t) {
    const auto& [c, p] = triangles_[t];
    const double ax = x_[c[1]] - x_[c[0]], ay = y_[c[1]] - y_[c[0]];
    const double bx = x_[c[2]] - x_[c[0]], by = y_[c[2]] - y_[c[0]];
    const double twice_area = ax * by - ay * bx, pa = p[1] - p[0], pb = p[2] - p[0];
    const LoadedPiece triangle{
        {x_[c[0]], x_[c[1]], x_[c[2]]},   {y_[c[0]], y_[c[1]], y_[c[2]]}, 3, p[0], (pa * by - pb * ay) / twice_area,
        (pb * ax - pa * bx) / twice_area, std::max({p[0], p[1], p[2]})};
    kernels::add_excess(triangle, u, sums);
  }
}

Roughness MeshPieces::roughness(std::size_t k) const { return leaves_[k].roughness; }

void MeshPieces::add_loads(std::size_t k, const Box& box, const LoadRule& rule, double* loads) const {
  const auto n = static_cast<std::size_t>(rule.order);
  std::vector<double> across(n), along(n);
  const Range& range = leaves_[k].triangles;
  for (std::size_t t = range.begin; t < range.end; ++t) {
    const auto& [corners, p] = triangles_[t];
    const double x = x_[corners[0]], y = y_[corners[0]];
    const double ax = x_[corners[1]] - x, ay = y_[corners[1]] - y;
    const double bx = x_[corners[2]] - x, by = y_[corners[2]] - y;
    const double twice_area = ax * by - ay * bx;
    const double size =
        std::sqrt(std::max({ax * ax + ay * ay, bx * bx + by * by, (ax - bx) * (ax - bx) + (ay - by) * (ay - by)}));
    const auto& gauss = gauss_rule(points_per_side(size / box.half_diagonal(), rule));
    // From the first corner: P = corner + s ((1 - r) a + r b), dA = 2 A s ds dr.
    for (const auto& [s_at, s_weight] : gauss) {
      const double s = (1 + s_at) / 2;
      for (const auto& [r_at, r_weight] : gauss) {
        const double r = (1 + r_at) / 2;
        const double pressure = (1 - s) * p[0] + s * ((1 - r) * p[1] + r * p[2]);
        const double load = twice_area * pressure * s * s_weight * r_weight / 4;
        lagrange(rule.order, (x + s * ((1 - r) * ax + r * bx) - box.x) / box.hx, across);
        lagrange(rule.order, (y + s * ((1 - r) * ay + r * by) - box.y) / box.hy, along);
        for (std::size_t j = 0; j < n; ++j) {
          const double weight = load * along[j];
          for (std::size_t i = 0; i < n; ++i) loads[j * n + i] += weight * across[i];
        }
      }
    }
  }
}

}  // namespace patchgrip::friction::kernels
