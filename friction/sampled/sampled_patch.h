// What patches of a sampled pressure have in common: PressureGrid and PressureMesh are made of it.
//
// Their pressure is scaled to the normal force 1: only its distribution counts.
//
// Exact     (tolerance 0) every piece is summed in closed form while the pole is near, point loads that agree to
//           rounding stand for all beyond 2.3 half diagonals, a polynomial in the inverse pole beyond 6 radii
//           (kernels/far_field.h).
// Tolerance the pieces are gathered in boxes of boxes and only those next to the pole are summed exactly
//           (sampled_pressure.h): the time grows with the logarithm of their number. Force and moment about the
//           centroid are good to `tolerance` of mu F_N and of mu F_N times the diagonal, the Hessian to 100 times that
//           of its size; D jumps by as much where boxes change. Typical errors are 1e-3 of that.
//
// Domain   every pole, also on nodes, edges and corners, and at infinity (w = 0).
// Error    carried by bounded_gradient(): about 1e-14 of mu F_N for an exact patch of 400 pieces. Rough pressures on
//          many pieces lose digits (corner_sums.h, edge_jumps.h). `bounds --kind sampled_grid`, sampled_tree_test.cc.
#pragma once

#include <memory>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

namespace kernels {
class SampledPressure;
}

class SampledPatch {
 public:
  static constexpr double default_tolerance = 1e-12;

  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const;  // throws std::domain_error at rest
  PressureMoments moments() const noexcept;
  double area_radius() const noexcept;  // of the pieces that carry pressure

  double tolerance() const noexcept;  // 0: exact

  friend BoundedWrench stribeck_excess(const SampledPatch& patch, const Twist& u) noexcept;

 protected:
  explicit SampledPatch(std::shared_ptr<const kernels::SampledPressure> pressure) noexcept;

 private:
  std::shared_ptr<const kernels::SampledPressure> pressure_;
};

}  // namespace patchgrip::friction
