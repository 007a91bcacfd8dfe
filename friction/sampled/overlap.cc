#include <patchgrip/friction/sampled/overlap.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace patchgrip::friction {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// As for PressureMesh: thinner triangles have no area in double.
constexpr double least_height = 1e-14;

// Depths that are forgiven: of the least height, and of the longest edge.
constexpr double of_height = 1e-3, of_edge = 1e-6;

struct Box {
  void include(const Box& other) noexcept {
    low.x = std::min(low.x, other.low.x);
    low.y = std::min(low.y, other.low.y);
    high.x = std::max(high.x, other.high.x);
    high.y = std::max(high.y, other.high.y);
  }

  bool meets(const Box& other) const noexcept {
    return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
  }

  Point low{infinity, infinity}, high{-infinity, -infinity};
};

// Counter-clockwise, with the unit normals of its edges, outwards.
struct Shape {
  std::array<Point, 3> corners;
  std::array<Point, 3> normals;
  double longest = 0;  // edge
  double height = 0;   // the least; 0 without area
};

Shape shape_of(const Triangulation& mesh, std::size_t index) noexcept {
  const auto& t = mesh.triangles[index];
  Shape shape{{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]}, {}};
  auto& [a, b, c] = shape.corners;
  double twice_area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (twice_area < 0) std::swap(b, c);
  twice_area = std::fabs(twice_area);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &from = shape.corners[i], &to = shape.corners[(i + 1) % 3];
    const double x = to.x - from.x, y = to.y - from.y;
    const double length = std::hypot(x, y);
    shape.normals[i] = {y / length, -x / length};
    shape.longest = std::max(shape.longest, length);
  }
  if (twice_area > least_height * shape.longest * shape.longest) shape.height = twice_area / shape.longest;
  return shape;
}

// The widest gap that an edge of `one` leaves to `other`; below 0 how deep they are in each other.
double gap(const Shape& one, const Shape& other) noexcept {
  double widest = -infinity;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &n = one.normals[i], &at = one.corners[i];
    double nearest = infinity;
    for (const Point& p : other.corners) nearest = std::min(nearest, n.x * (p.x - at.x) + n.y * (p.y - at.y));
    widest = std::max(widest, nearest);
  }
  return widest;
}

// Boxes of triangles in a binary tree: halves of the triangles along the longer side of their box.
class BoxTree {
 public:
  using Pair = std::pair<std::size_t, std::size_t>;

  explicit BoxTree(const Triangulation& mesh) : order_(mesh.triangles.size()), boxes_(order_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      shapes_.push_back(shape_of(mesh, i));
      for (const Point& corner : shapes_[i].corners) boxes_[i].include({corner, corner});
    }
    build(0, order_.size());
  }

  std::optional<Pair> overlap() const { return within(0); }

 private:
  struct Node {
    Box box;
    std::size_t begin, end;             // of order_
    std::size_t first = 0, second = 0;  // halves; a leaf has none
  };

  std::size_t build(std::size_t begin, std::size_t end) {
    constexpr std::size_t leaf = 4;
    const std::size_t index = nodes_.size();
    nodes_.push_back({{}, begin, end});
    Box box;
    for (std::size_t i = begin; i < end; ++i) box.include(boxes_[order_[i]]);
    nodes_[index].box = box;
    if (end - begin <= leaf) return index;
    const bool along_x = box.high.x - box.low.x > box.high.y - box.low.y;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
      const Box &p = boxes_[a], &q = boxes_[b];
      return along_x ? p.low.x + p.high.x < q.low.x + q.high.x : p.low.y + p.high.y < q.low.y + q.high.y;
    });
    const std::size_t first = build(begin, middle);
    const std::size_t second = build(middle, end);
    nodes_[index].first = first;
    nodes_[index].second = second;
    return index;
  }

  std::optional<Pair> within(std::size_t index) const {
    const Node& node = nodes_[index];
    if (node.first == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i) {
        for (std::size_t j = i + 1; j < node.end; ++j) {
          if (const auto found = pair(order_[i], order_[j])) return found;
        }
      }
      return std::nullopt;
    }
    if (const auto found = within(node.first)) return found;
    if (const auto found = within(node.second)) return found;
    return between(node.first, node.second);
  }

  std::optional<Pair> between(std::size_t one, std::size_t other) const {
    const Node &p = nodes_[one], &q = nodes_[other];
    if (!p.box.meets(q.box)) return std::nullopt;
    if (p.first == 0 && q.first == 0) {
      for (std::size_t i = p.begin; i < p.end; ++i) {
        for (std::size_t j = q.begin; j < q.end; ++j) {
          if (const auto found = pair(order_[i], order_[j])) return found;
        }
      }
      return std::nullopt;
    }
    const bool halve_one = q.first == 0 || (p.first != 0 && p.end - p.begin >= q.end - q.begin);
    const std::size_t rest = halve_one ? other : one;
    const Node& halved = halve_one ? p : q;
    if (const auto found = between(halved.first, rest)) return found;
    return between(halved.second, rest);
  }

  std::optional<Pair> pair(std::size_t i, std::size_t j) const {
    if (!boxes_[i].meets(boxes_[j])) return std::nullopt;
    const Shape &p = shapes_[i], &q = shapes_[j];
    if (p.height == 0 || q.height == 0) return std::nullopt;
    const double depth = -std::max(gap(p, q), gap(q, p));
    const double least = std::min(p.height, q.height), longest = std::max(p.longest, q.longest);
    if (!(depth > std::max(of_height * least, of_edge * longest))) return std::nullopt;
    return Pair{std::min(i, j), std::max(i, j)};
  }

  std::vector<std::size_t> order_;
  std::vector<Box> boxes_;
  std::vector<Shape> shapes_;
  std::vector<Node> nodes_;
};

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> overlapping_triangles(const Triangulation& mesh) {
  if (mesh.triangles.empty()) return std::nullopt;
  return BoxTree(mesh).overlap();
}

}  // namespace patchgrip::friction
