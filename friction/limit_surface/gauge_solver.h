// Maximises t . v / D(v) for a patch that is known by its derivatives alone.
//
// Twist and load are taken about the centroid c of the pressure, spins times the radius of gyration. The maximum of
//
//     phi(v) = t . v - D(v)^2 / 2,    max phi = g(t)^2 / 2
//
// is found by Newton's method: (D H + grad D grad D^T) dv = t - D grad D, an ellipsoid in a single step. D is
// homogeneous, so each v is scaled to its best length, D(v) = t . v / D(v), for which t - D grad D is the residual r
// of the certificate
//
//     t . v / D(v)  <=  g(t)  <=  lambda + |r_F| + |r_M| / min S,    r = t - lambda grad D(v),  any lambda >= 0,
//
// since grad D, every unit force through c and the pure moment min S hold exactly. S(M) >= |M - c| and S is convex
// with slopes <= 1, so that min S >= S(c) max(1/2, 1 - |grad S(c)|).
//
// A step that overshoots is shortened to where the slope along it vanishes. Where D has a kink (a point load at the
// pole) no single gradient balances the load: then those of both sides of the kink do, in convex combination.
#pragma once

#include <stdexcept>

#include <patchgrip/friction/limit_surface/gauge.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

// A patch without its type.
struct PatchView {
  const void* patch;
  BoundedWrench (*gradient)(const void* patch, const Twist& v) noexcept;
  bool (*hessian)(const void* patch, const Twist& v, Hessian& h) noexcept;  // false where it is infinite
};

template <Patch P>
PatchView view(const P& patch) noexcept {
  return {&patch, [](const void* p, const Twist& v) noexcept { return static_cast<const P*>(p)->bounded_gradient(v); },
          [](const void* p, const Twist& v, Hessian& h) noexcept {
            try {
              h = static_cast<const P*>(p)->hessian(v);
            } catch (const std::domain_error&) {
              return false;
            }
            return true;
          }};
}

// What the certificate needs to know of the pressure.
struct PressureFrame {
  PressureFrame(const PatchView& patch, const PressureMoments& moments) noexcept;

  double x, y;          // centroid [m]
  double length;        // radius of gyration about it [m]
  double least_moment;  // lower bound of min S [m]
};

Gauge maximise(const PatchView& patch, const PressureFrame& frame, const Wrench& load,
               const GaugeSettings& settings) noexcept;

}  // namespace patchgrip::friction
