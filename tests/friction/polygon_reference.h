// The edge sums in 50 digits, at the very twist that the double code is given: reference of polygons and rectangles.
#pragma once

#include <array>
#include <vector>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

class PolygonReference {
 public:
  explicit PolygonReference(const std::vector<std::vector<kernels::Vertex>>& rings)
      : boundary_(kernels::make_boundary<Real50>(rings)) {
    for (const auto& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& p = ring[i];
        const auto& q = ring[(i + 1) % ring.size()];
        const Real50 px = p.x, py = p.y, qx = q.x, qy = q.y;
        const Real50 cross = px * qy - qx * py;
        area_ += cross / 2;
        x_ += cross * (px + qx) / 6;
        y_ += cross * (py + qy) / 6;
        second_ += cross * (px * px + px * qx + qx * qx + py * py + py * qy + qy * qy) / 12;
      }
    }
  }

  // Not at rest. The sums lose 3 digits per decade of the pole's distance.
  Wrench50 gradient(const Real50& vx, const Real50& vy, const Real50& w) const {
    if (w == 0) {
      const Real50 V = sqrt(vx * vx + vy * vy);
      return {vx / V, vy / V, (x_ * vy - y_ * vx) / (area_ * V)};
    }
    const Real50 X = -vy / w;
    const Real50 Y = vx / w;
    const auto sum = kernels::edge_sum<kernels::Want::gradient>(boundary_, X, Y);
    const Real50 k = (w < 0 ? -1 : 1) / area_;
    return {k * sum.gy, -k * sum.gx, k * (sum.S - X * sum.gx - Y * sum.gy)};
  }

  Wrench50 gradient(const Twist& v) const { return gradient(v.vx, v.vy, v.w); }

  const Real50& area() const { return area_; }

  // Centroid x, y and the polar second moment about it.
  std::array<Real50, 3> moments() const {
    const Real50 x = x_ / area_;
    const Real50 y = y_ / area_;
    return {x, y, second_ / area_ - x * x - y * y};
  }

 private:
  kernels::Boundary<Real50> boundary_;
  Real50 area_{0}, x_{0}, y_{0}, second_{0};
};

}  // namespace patchgrip::friction
