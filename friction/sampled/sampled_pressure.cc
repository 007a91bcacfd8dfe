#include <patchgrip/friction/sampled/sampled_pressure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace patchgrip::friction::kernels {
namespace {

constexpr double unit = 0x1p-53;

std::size_t size_of(int n) { return static_cast<std::size_t>(n); }

// The loads of a box from those of a box within it: sum over its points of l_i(x) l_j(y).
void carry(const double* from, const Box& inner, double* to, const Box& outer, int order) {
  const std::size_t n = size_of(order);
  const auto points = load_points(order);
  std::vector<double> x(n * n), y(n * n), rows(n * n);
  const auto along = [&](double centre, double half, double outer_centre, double outer_half, std::vector<double>& l) {
    for (std::size_t k = 0; k < n; ++k)
      lagrange(order, (centre - outer_centre + half * points[k]) / outer_half, {&l[k * n], n});
  };
  along(inner.x, inner.hx, outer.x, outer.hx, x);
  along(inner.y, inner.hy, outer.y, outer.hy, y);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t m = 0; m < n; ++m) {
      const double q = from[k * n + m];
      for (std::size_t i = 0; i < n; ++i) rows[k * n + i] += q * x[m * n + i];
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t j = 0; j < n; ++j) {
      const double l = y[k * n + j];
      for (std::size_t i = 0; i < n; ++i) to[j * n + i] += l * rows[k * n + i];
    }
  }
}

void require_levels(const std::vector<PressureNode>& nodes) {
  std::vector<std::uint32_t> level(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto& [box, first_child, children, leaf] = nodes[k];
    if (children > PressureNode::most_children || (children > 0 && level[k] == PressureNode::most_levels)) {
      throw std::length_error("tree node " + std::to_string(k) + " with " + std::to_string(children) +
                              " children on level " + std::to_string(level[k]) + " is not allowed: at most " +
                              std::to_string(PressureNode::most_children) + " children, and none on level " +
                              std::to_string(PressureNode::most_levels));
    }
    for (std::uint32_t i = 0; i < children; ++i) level[first_child + i] = level[k] + 1;
  }
}

}  // namespace

struct SampledPressure::Local {
  Twist v;       // at the origin of the frame, of order 1
  int exponent;  // the twist is 2^exponent times that
  bool at_rest;
};

SampledPressure::SampledPressure(const PressureFrame& frame, std::vector<PressureNode> nodes,
                                 std::unique_ptr<const Pieces> pieces, double tolerance)
    : frame_(frame),
      tolerance_(tolerance),
      rule_(load_rule(tolerance)),
      nodes_(std::move(nodes)),
      pieces_(std::move(pieces)) {
  require_levels(nodes_);
  kernels_ = load_kernels(rule_.order, widest_lanes());
  const Box& root = nodes_[0].box;
  radius_ = std::hypot(std::fabs(root.x) + root.hx, std::fabs(root.y) + root.hy);
  fill_loads();
  far_ = far_field();
}

void SampledPressure::fill_loads() {
  const std::size_t block = size_of(rule_.order) * size_of(rule_.order);
  loads_.resize(nodes_.size() * block);
  errors_.resize(nodes_.size());
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const PressureNode& node = nodes_[k];
    double* loads = &loads_[k * block];
    if (node.leaf != PressureNode::none) {
      pieces_->add_loads(node.leaf, node.box, rule_, loads);
      errors_[k].roughness = pieces_->roughness(node.leaf);
    }
    for (std::size_t child = node.first_child; child < node.first_child + node.children; ++child)
      carry(&loads_[child * block], nodes_[child].box, loads, node.box, rule_.order);
    for (std::size_t i = 0; i < block; ++i) errors_[k].share += std::fabs(loads[i]);
  }
}

FarField SampledPressure::far_field() const {
  const Box& root = nodes_[0].box;
  const auto points = load_points(rule_.order);
  std::vector<PointLoad> samples;
  const double* q = loads_.data();
  for (const double y : points) {
    for (const double x : points) {
      samples.push_back(
          {root.x + static_cast<long double>(root.hx) * x, root.y + static_cast<long double>(root.hy) * y, *q++});
    }
  }
  return {samples, radius_, frame_.offset_x / frame_.scale, frame_.offset_y / frame_.scale};
}

SampledPressure::Local SampledPressure::local(const Twist& twist) const noexcept {
  Twist v = finite_or_nan(twist);
  const double size = std::max({std::fabs(v.vx), std::fabs(v.vy), std::fabs(v.w) * frame_.scale});
  if (size == 0) return {v, 0, true};
  const int e = std::isfinite(size) ? std::ilogb(size) : 0;
  v = {std::scalbn(v.vx, -e), std::scalbn(v.vy, -e), std::scalbn(v.w, -e)};
  v = {std::fma(-v.w, frame_.y, v.vx), std::fma(v.w, frame_.x, v.vy), v.w * frame_.scale};
  return {v, e, false};
}

// Calls far(node index) and near(node index) for boxes that together are the patch.
template <class Far, class Near>
void SampledPressure::visit(const Twist& v, Far&& far, Near&& near) const noexcept {
  // A level leaves all but one of its children behind.
  std::array<std::uint32_t, 1 + (PressureNode::most_children - 1) * PressureNode::most_levels> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  const double w2 = v.w * v.w * rule_.reach * rule_.reach;
  while (depth > 0) {
    const std::uint32_t k = stack[--depth];
    const PressureNode& node = nodes_[k];
    const double vx = v.vx - v.w * node.box.y;
    const double vy = v.vy + v.w * node.box.x;
    if (vx * vx + vy * vy >= w2 * (node.box.hx * node.box.hx + node.box.hy * node.box.hy)) {
      far(k);
    } else if (node.children == 0) {
      near(k);
    } else {
      for (std::uint32_t i = 0; i < node.children; ++i) stack[depth++] = node.first_child + i;
    }
  }
}

Wrench SampledPressure::centred_gradient(const Twist& v) const noexcept {
  if (far_.reaches(std::hypot(v.vx, v.vy), v.w)) return far_.gradient(v);
  const std::size_t block = size_of(rule_.order) * size_of(rule_.order);
  const double X = -v.vy / v.w;
  const double Y = v.vx / v.w;
  LoadSums distant;
  DistanceSums sums;
  visit(
      v, [&](std::size_t k) { kernels_.gradient(&loads_[k * block], nodes_[k].box, v, distant); },
      [&](std::size_t k) { pieces_->add(nodes_[k].leaf, X, Y, Derivatives::first, sums); });
  const double sense = v.w < 0 ? -1 : 1;
  const Wrench& g = distant.gradient;
  return {g.fx + sense * sums.gy, g.fy - sense * sums.gx, g.m + sense * (sums.S - X * sums.gx - Y * sums.gy)};
}

BoundedWrench SampledPressure::centred_bound(const Twist& v) const noexcept {
  const Box& root = nodes_[0].box;
  const double V = std::hypot(v.vx, v.vy);
  const double W = std::fabs(v.w);
  if (far_.reaches(V, v.w)) {
    BoundedWrench g = far_.bounded_gradient(v);
    const double truncation = W > 0 ? load_error(rule_.order, V / (W * root.half_diagonal())) : 0;
    g.force_error += errors_[0].share * truncation;
    g.moment_error += errors_[0].share * radius_ * (2 * truncation + 16 * unit * radius_ * W / V) +
                      frame_.centroid_error / frame_.scale;
    return g;
  }
  const double X = -v.vy / v.w;
  const double Y = v.vx / v.w;
  const double r_pole = std::hypot(X, Y);
  // Rounding moves the velocity by some units of V + radius W, and force and moment by |Hess D| times that. The Hessian
  // is at most that of a disc with the highest pressure all over.
  const double turn = unit * 4 * (r_pole + radius_) * 2 * std::sqrt(std::numbers::pi * frame_.highest);
  double force_error = turn, moment_error = radius_ * turn;
  visit(
      v,
      [&](std::size_t k) {
        const Box& box = nodes_[k].box;
        const double R = std::hypot(X - box.x, Y - box.y) / box.half_diagonal();
        const double error = errors_[k].share * (load_error(rule_.order, R) + 16 * unit);
        force_error += error;
        moment_error += error * (box.half_diagonal() + std::hypot(box.x, box.y));
      },
      [&](std::size_t k) {
        const Box& box = nodes_[k].box;
        const auto [jumps, bends] = errors_[k].roughness;
        const double r = std::hypot(X - box.x, Y - box.y) + box.half_diagonal();
        const double error = unit * r * (2 * jumps + bends * r);
        force_error += error;
        moment_error += error * (r + r_pole);
      });
  const Wrench g = centred_gradient(v);
  const double force = std::hypot(g.fx, g.fy);
  force_error += 4 * unit * force;
  moment_error += 4 * unit * (std::fabs(g.m) + 2 * r_pole * force);
  return {g, force_error, moment_error};
}

Hessian SampledPressure::centred_hessian(const Twist& v) const noexcept {
  if (far_.reaches(std::hypot(v.vx, v.vy), v.w)) return far_.hessian(v);
  const std::size_t block = size_of(rule_.order) * size_of(rule_.order);
  const double X = -v.vy / v.w;
  const double Y = v.vx / v.w;
  LoadSums distant;
  DistanceSums s;
  visit(
      v, [&](std::size_t k) { kernels_.hessian(&loads_[k * block], nodes_[k].box, v, distant); },
      [&](std::size_t k) { pieces_->add(nodes_[k].leaf, X, Y, Derivatives::second, s); });
  // Of D = |w| S(M): B Hess S B^T / |w|, B = [0 1; -1 0; -X -Y].
  const double k = 1 / std::fabs(v.w);
  const double zx = X * s.xx + Y * s.xy;
  const double zy = X * s.xy + Y * s.yy;
  const Hessian& h = distant.hessian;
  return {h.xx + k * s.yy, h.xy - k * s.xy, h.xw - k * zy,
          h.yy + k * s.xx, h.yw + k * zx,   h.ww + k * (X * zx + Y * zy)};
}

double SampledPressure::dissipation(const Twist& twist) const noexcept {
  const Local l = local(twist);
  if (l.at_rest) return 0;
  const double V = std::hypot(l.v.vx, l.v.vy);
  const double D = far_.reaches(V, l.v.w) ? far_.dissipation(l.v) : power(centred_gradient(l.v), l.v);
  return std::scalbn(D, l.exponent);
}

Wrench SampledPressure::gradient(const Twist& twist) const noexcept {
  const Local l = local(twist);
  if (l.at_rest) return {};
  const Wrench g = centred_gradient(l.v);
  return {g.fx, g.fy, frame_.scale * g.m + (frame_.x * g.fy - frame_.y * g.fx)};
}

BoundedWrench SampledPressure::bounded_gradient(const Twist& twist) const noexcept {
  const Local l = local(twist);
  if (l.at_rest) return {};
  BoundedWrench g = centred_bound(l.v);
  const double arm = std::fabs(frame_.x) + std::fabs(frame_.y);
  g.value.m = frame_.scale * g.value.m + (frame_.x * g.value.fy - frame_.y * g.value.fx);
  g.moment_error = frame_.scale * g.moment_error +
                   arm * (g.force_error + 2 * unit * std::hypot(g.value.fx, g.value.fy)) + unit * std::fabs(g.value.m);
  return g;
}

Hessian SampledPressure::hessian(const Twist& twist) const {
  const Local l = local(twist);
  if (l.at_rest) throw std::domain_error("twist = 0 is not allowed: the Hessian of D exists only in motion");
  Hessian h = centred_hessian(l.v);
  const double k = std::scalbn(1.0, -l.exponent);
  const double a = frame_.scale, x = frame_.x, y = frame_.y;
  h = {k * h.xx, k * h.xy, k * a * h.xw, k * h.yy, k * a * h.yw, k * a * a * h.ww};
  // u = A v with A = [1 0 -y; 0 1 x; 0 0 1] at the centroid: A^T H A.
  const double xw = h.xw - y * h.xx + x * h.xy;
  const double yw = h.yw - y * h.xy + x * h.yy;
  return {h.xx, h.xy, xw, h.yy, yw, h.ww - y * (h.xw + xw) + x * (h.yw + yw)};
}

}  // namespace patchgrip::friction::kernels
