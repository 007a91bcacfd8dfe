// The edge sums in 80 digits, at the very twist that the double code is given: reference of polygons and rectangles.
// At the distance r of a patch of the size s the moment cancels to (r/s)^4 units, for slender patches to more: at 1e8
// radii 50 digits would not be enough.
#pragma once

#include <array>
#include <vector>

#include <patchgrip/friction/kernels/edge_sum.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

class PolygonReference {
 public:
  using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<80>, boost::multiprecision::et_off>;

  explicit PolygonReference(const std::vector<std::vector<kernels::Vertex>>& rings)
      : boundary_(kernels::make_boundary<Real>(rings)) {
    for (const auto& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto& p = ring[i];
        const auto& q = ring[(i + 1) % ring.size()];
        const Real px = p.x, py = p.y, qx = q.x, qy = q.y;
        const Real cross = px * qy - qx * py;
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
      return {vx / V, vy / V, Real50((x_ * Real(vy) - y_ * Real(vx)) / (area_ * Real(V)))};
    }
    const Real X = -Real(vy) / Real(w);
    const Real Y = Real(vx) / Real(w);
    const auto sum = kernels::edge_sum<kernels::Want::gradient>(boundary_, X, Y);
    const Real k = (w < 0 ? -1 : 1) / area_;
    return {Real50(k * sum.gy), Real50(-k * sum.gx), Real50(k * (sum.S - X * sum.gx - Y * sum.gy))};
  }

  Wrench50 gradient(const Twist& v) const { return gradient(v.vx, v.vy, v.w); }

  Real50 area() const { return Real50(area_); }

  // Centroid x, y and the polar second moment about it.
  std::array<Real50, 3> moments() const {
    const Real x = x_ / area_;
    const Real y = y_ / area_;
    return {Real50(x), Real50(y), Real50(second_ / area_ - x * x - y * y)};
  }

 private:
  kernels::Boundary<Real> boundary_;
  Real area_{0}, x_{0}, y_{0}, second_{0};
};

}  // namespace patchgrip::friction
