// Kernel of a round pressure that is known by its table.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include <patchgrip/friction/kernels/round_table.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction::kernels {

class TableKernel {
 public:
  explicit TableKernel(std::shared_ptr<const RoundTable> table) noexcept : table_(std::move(table)) {}

  static bool pole_inside(const RoundTwist& t) noexcept {
    return near_rim(t) ? rim_excess(t.vx, t.vy, t.w, t.radius) <= 0 : t.V2 <= t.W2;
  }

  RoundGradient gradient(const RoundTwist& t) const noexcept {
    const Place p(t);
    const Pair g = table_->gradient(p.inside, p.d, p.x);
    return {p.k * g[0], select(p.inside, 1, t.W * p.k) * g[1]};
  }

  double slope(const RoundTwist& t) const noexcept {
    const Place p(t);
    return table_->slope(p.inside, p.d, p.x);
  }

  CurvePoint inside(double x) const noexcept {
    const Pair g = table_->gradient(true, 1 - x, x);
    return {x * g[0], g[1], table_->slope(true, 1 - x, x)};
  }

  CurvePoint outside(double u) const noexcept {
    const Pair g = table_->gradient(false, 1 - u, 1);
    return {g[0], u * g[1], table_->slope(false, 1 - u, 1)};
  }

 private:
  struct Place {
    explicit Place(const RoundTwist& t) noexcept {
      const double V = std::sqrt(t.V2);
      inside = t.V2 <= t.W2;
      k = 1 / std::max(V, t.W);
      d = std::fabs(V - t.W) * k;
      x = V * k;
      // Where V and W nearly agree their own rounding would be all that is left of the difference.
      if (near_rim(t)) [[unlikely]] {
        const double excess = rim_excess(t.vx, t.vy, t.w, t.radius);
        inside = excess <= 0;
        d = std::fabs(excess) / (V + t.W) * k;
      }
    }

    bool inside;
    double k;  // 1 / max(V, W)
    double d;  // 1 - x inside, 1 - u outside
    double x;  // V k: x inside
  };

  static bool near_rim(const RoundTwist& t) noexcept { return std::fabs(t.V2 - t.W2) < 0x1p-6 * t.W2; }

  std::shared_ptr<const RoundTable> table_;
};

}  // namespace patchgrip::friction::kernels
