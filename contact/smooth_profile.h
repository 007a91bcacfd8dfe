// Any smooth stamp of revolution, given by its height and its first two derivatives as functions.
//
//     g  = x int_0^(pi/2) f'(x sin t) dt,   g' = int_0^(pi/2) [f' + x sin t f''](x sin t) dt             (Sneddon 1965)
//     F  = 2 E* a^2 int_0^(pi/2) sin^2 t f'(a sin t) dt
//     p  = (E*/pi) int_0^Z g'(x) / x dz,   x^2 = r^2 + z^2,   Z = sqrt(a^2 - r^2)
//     u_z = (2/pi) int_0^a arcsin(x/r) g'(x) dx,   r > a
//
// by quadrature; p and u_z outside are double integrals. Shapes with a header of their own are a thousand times faster
// there.
//
// Domain   f(0) = 0, f' >= 0, f smooth in 0 < r <= max_radius; a tip is allowed, kinks and flat ends are not. The slope
//          of g must be positive: a dimple beyond which the stamp touches again is not seen.
// Units    f, r [m], f' [1], f'' [1/m]; the rest as in axisymmetric.h.
// Error    no value leaves unless the quadrature's own estimate is below `tolerance` of it; that is what errors()
//          states. tests/contact/smooth_profile_test.cc.
// Fails    where the estimate stays above the tolerance (a kink inside, an inaccurate f), std::runtime_error names it.
// Throws   std::invalid_argument outside the domain.
#pragma once

#include <functional>

#include <patchgrip/contact/axisymmetric.h>

namespace patchgrip::contact {

struct SmoothShape {
  std::function<double(double)> height;     // f
  std::function<double(double)> slope;      // f'
  std::function<double(double)> curvature;  // f''
};

class SmoothProfile {
 public:
  // tolerance is relative, in [1e-11, 1e-3].
  static SmoothProfile of(SmoothShape shape, double max_radius, double tolerance = 1e-11);

  double height(double r) const { return shape_.height(r); }
  double approach(double a) const;
  double approach_slope(double a) const;
  double force(double a) const;
  double pressure(double r, double a) const;
  double displacement(double r, double a) const;

  double radius_of_approach(double approach) const;
  double radius_of_force(double force) const;

  double max_radius() const noexcept { return max_radius_; }

  ProfileErrors errors() const noexcept {
    const double units = tolerance_ * 0x1p53;
    return {units, units, units, units, 2 * units};
  }

 private:
  SmoothProfile(SmoothShape shape, double max_radius, double tolerance)
      : shape_(std::move(shape)), max_radius_(max_radius), tolerance_(tolerance) {}

  SmoothShape shape_;
  double max_radius_;
  double tolerance_;
};

}  // namespace patchgrip::contact
