// Stribeck's excess of a sampled pressure: far boxes by their loads, pieces near the pole in closed form.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <patchgrip/friction/sampled/sampled_pressure.h>

namespace patchgrip::friction::kernels {
namespace {

constexpr double unit = 0x1p-53;

// Distance of the pole in half diagonals of a box: further away its loads are as good as they get.
constexpr double farthest = 1e6;

}  // namespace

BoundedWrench SampledPressure::stribeck_excess(const Twist& twist) const noexcept {
  Twist u = finite_or_nan(twist);
  if (u.vx == 0 && u.vy == 0 && u.w == 0) return {};
  u = {std::fma(-u.w, frame_.y, u.vx), std::fma(u.w, frame_.x, u.vy), u.w * frame_.scale};
  const std::size_t n = static_cast<std::size_t>(rule_.order), block = n * n;
  const auto points = load_points(rule_.order);
  const double V = std::hypot(u.vx, u.vy), W = std::fabs(u.w);
  StribeckSums sums;
  const auto add_loads = [&](std::size_t k) {
    const Box& box = nodes_[k].box;
    const double* q = &loads_[k * block];
    for (std::size_t j = 0; j < n; ++j) {
      const double y = box.y + box.hy * points[j], ux = u.vx - u.w * y;
      for (std::size_t i = 0; i < n; ++i) {
        const double x = box.x + box.hx * points[i], uy = u.vy + u.w * x;
        const double f = *q++ * excess_per_speed(ux * ux + uy * uy);
        sums.add(f * ux, f * uy, f * (x * uy - y * ux));
      }
    }
  };
  std::array<std::uint32_t, 1 + (PressureNode::most_children - 1) * PressureNode::most_levels> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t k = stack[--depth];
    const PressureNode& node = nodes_[k];
    const Box& box = node.box;
    const double half = box.half_diagonal(), speed = std::hypot(u.vx - u.w * box.y, u.vy + u.w * box.x);
    const double slowest = std::max(0.0, speed - W * half), lever = half + std::hypot(box.x, box.y);
    const double most = std::exp(-slowest * slowest);
    if (most < negligible) {
      sums.add_error(errors_[k].share * most, lever * errors_[k].share * most);
      continue;
    }
    const double R = W > 0 ? std::min(speed / (W * half), farthest) : farthest;
    const double error = R >= rule_.reach ? excess_error(rule_.order, R, W * half) : 1;
    if (error <= 16 * rule_.tolerance) {
      const double kept = errors_[k].share * (error + 16 * unit);
      sums.add_error(kept, lever * kept);
      add_loads(k);
    } else if (node.children == 0) {
      pieces_->add_excess(node.leaf, u, sums);
    } else {
      for (std::uint32_t i = 0; i < node.children; ++i) stack[depth++] = node.first_child + i;
    }
  }
  // Rounding moves each velocity by some units of V + radius W, and its excess by at most 1 / |u_P| times that: as in
  // the gradient near the pole, beyond two radii by their ratio.
  const double near = 2 * std::sqrt(std::numbers::pi * frame_.highest) * (V + radius_ * W) / W;
  const double far = V > 2 * radius_ * W ? (V + radius_ * W) / (V - radius_ * W) : near;
  const double turn = unit * 8 * std::min(near, far);
  BoundedWrench g = sums.total();
  g.force_error += turn;
  g.moment_error += radius_ * turn;
  const double arm = std::fabs(frame_.x) + std::fabs(frame_.y);
  g.value.m = frame_.scale * g.value.m + (frame_.x * g.value.fy - frame_.y * g.value.fx);
  g.moment_error = frame_.scale * g.moment_error + frame_.centroid_error +
                   arm * (g.force_error + 2 * unit * std::hypot(g.value.fx, g.value.fy)) + unit * std::fabs(g.value.m);
  return g;
}

}  // namespace patchgrip::friction::kernels
