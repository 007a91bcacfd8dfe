// Friction of a uniform pressure on a polygon, with holes or without.
//
//     p = F_N / area
//
// Distance integrals are sums over the edges (kernels/edge_sum.h). They are exact at every pole, on edges and vertices
// too, but far from the patch the moment is a small difference of large terms. So three ways of one accuracy:
//
//     r <  2 to 3 radii             edge sums in double (slender patches: less, or not at all)
//     r <  6 radii                  edge sums in 64 bits, on the axis of slender patches in 113
//     beyond, and translations      a polynomial in the inverse pole about the centroid (kernels/far_field.h)
//
// with r the distance of the pole from the centroid and the radius that of the farthest vertex.
//
// Domain   simple rings in either orientation; holes inside the outer ring, disjoint, not touching.
// Units    vertices [m] in the contact frame; the moment is about its origin.
// Error    force <= 1e-13 of mu F_N, moment <= 1e-13 of mu F_N a_K for aspect ratios up to 100 and an origin within
//          the patch; the moment of far poles <= 1e-12 of itself. bounded_gradient() carries the bound of each case:
//          `bounds --kind polygon`.
// Throws   std::invalid_argument, naming ring and vertices, where the domain is left.
#pragma once

#include <memory>
#include <vector>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

namespace kernels {
template <class Real>
struct Boundary;
}

struct Point {
  double x = 0;  // [m]
  double y = 0;  // [m]
};

class Polygon {
 public:
  static Polygon uniform(const std::vector<Point>& outer, const std::vector<std::vector<Point>>& holes = {});

  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const;  // throws std::domain_error at rest
  PressureMoments moments() const noexcept;
  double area_radius() const noexcept;

  std::size_t edges() const noexcept;
  const kernels::Boundary<double>& boundary() const noexcept;  // kernels/edge_sum.h

 private:
  struct Data;
  explicit Polygon(std::shared_ptr<const Data> data) noexcept : data_(std::move(data)) {}

  std::shared_ptr<const Data> data_;
};

}  // namespace patchgrip::friction
