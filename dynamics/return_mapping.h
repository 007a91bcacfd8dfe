// Return mapping of any patch in any metric (returned.h).
//
// With K = R^T R and unit vectors nu = R n the closest point is where
//
//     psi(nu) = s* . n - L D(n)
//
// is greatest; s = L grad D(n), u = psi n. As D is homogeneous psi has on the sphere the gradient
// P (R^-T (s* - L grad D)), P = 1 - nu nu^T, and the Hessian -(L R^-T H R^-1 + psi P): negative definite where psi > 0.
// Newton's method with halving from any n with psi(n) > 0 cannot fail. It starts from the closest point of the
// ellipsoid |f|^2 + (m / S(c))^2 = L^2 about the centroid c; where psi is not positive there the gauge says whether the
// trial sticks at all, and if not its slip has psi = g - L > 0.
//
// Domain   every trial and limit L >= 0, any K. Stick is proven by the gauge's bracket.
// Units    trial [N], [N], [N m] about the origin of the patch's frame, in which K is given, too.
// Error    carried: what the last step and rounding leave, doubled: some 1e-15 of L times the condition of K.
//          tests/dynamics/return_mapping_test.cc.
// Cost     6.6 (disc) to 9.0 (two discs) evaluations of D, its gradient and Hessian in the mean over overshoot from
//          1e-9 to 1e3 and metrics of a condition up to 1e4.
// Throws   std::invalid_argument as LimitSurface, also of a single point load (there s = L s* / |s*|); nothing
//          afterwards: a trial or a limit that is not finite, or a negative limit, gives not-a-number and an infinite
//          error.
// Fails    where the slip turns about a point load (several.h) Newton's method has no Hessian: the error says so.
#pragma once

#include <utility>

#include <patchgrip/dynamics/bristle_metric.h>
#include <patchgrip/dynamics/returned.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>

namespace patchgrip::dynamics {

// What the search needs of the patch beforehand.
struct ReturnFrame {
  explicit ReturnFrame(const friction::PatchView& patch, const friction::PressureFrame& frame);

  double x, y;        // centroid [m]
  double spin_scale;  // S(c) [m]
};

Returned return_mapping(const friction::PatchView& patch, const friction::PressureFrame& pressure,
                        const ReturnFrame& frame, const friction::GaugeSettings& settings,
                        const friction::Wrench& trial, double limit, const BristleMetric& metric) noexcept;

template <friction::Patch P>
class ReturnMapping {
 public:
  explicit ReturnMapping(P patch)
      : surface_(std::move(patch)), frame_(friction::view(surface_.patch()), surface_.frame()) {}

  const P& patch() const noexcept { return surface_.patch(); }
  const friction::LimitSurface<P>& surface() const noexcept { return surface_; }

  // The closest point of L B to `trial`; `limit` L = mu F_N [N].
  Returned operator()(const friction::Wrench& trial, double limit, const BristleMetric& metric) const noexcept {
    return return_mapping(friction::view(surface_.patch()), surface_.frame(), frame_, surface_.settings(), trial, limit,
                          metric);
  }

 private:
  friction::LimitSurface<P> surface_;
  ReturnFrame frame_;
};

}  // namespace patchgrip::dynamics
