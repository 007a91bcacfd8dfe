// What patches of a sampled pressure have in common: PressureGrid and PressureMesh are made of it.
//
// Their pressure is scaled to the normal force 1: only its distribution counts.
//
// Exact     (tolerance 0) every piece is summed in closed form while the pole is near, point loads that agree to rounding
//           stand for it beyond 2.3 half diagonals, a polynomial in the inverse pole beyond 6 (kernels/far_field.h).
// Tolerance the pieces are gathered in boxes of boxes and only those next to the pole are summed exactly
//           (sampled_pressure.h): the time grows with the logarithm of their number. Force and moment are good to
//           `tolerance` of mu F_N and of mu F_N times twice the patch's radius; D jumps by as much where boxes change.
//
// Domain   every pole, also on nodes, edges and corners, and at infinity (w = 0).
// Error    carried by bounded_gradient(); an exact patch of up to 1000 pieces and a pressure that is not rough about
//          1e-14 of mu F_N. Rough pressures lose digits with their number (corner_sums.h, edge_jumps.h).
#pragma once

#include <cstddef>
#include <memory>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

namespace kernels {
class SampledPressure;
}

class SampledPatch {
 public:
  static constexpr double default_tolerance = 1e-12;
  // Patches of no more pieces are exact whatever the tolerance.
  static constexpr std::size_t few_pieces = 256;

  double dissipation(const Twist& v) const noexcept;
  Wrench gradient(const Twist& v) const noexcept;
  BoundedWrench bounded_gradient(const Twist& v) const noexcept;
  Hessian hessian(const Twist& v) const;  // throws std::domain_error at rest
  PressureMoments moments() const noexcept;
  double area_radius() const noexcept;  // of the pieces that carry pressure

  double tolerance() const noexcept;  // 0: exact

 protected:
  explicit SampledPatch(std::shared_ptr<const kernels::SampledPressure> pressure) noexcept;

 private:
  std::shared_ptr<const kernels::SampledPressure> pressure_;
};

}  // namespace patchgrip::friction
