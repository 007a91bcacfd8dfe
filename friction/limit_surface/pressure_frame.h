// A patch as the gauge sees it: its derivatives without its type, and what is known of its pressure beforehand.
//
// Centroid c, second moments about it, and a lower bound of the least moment min S that a rotation meets: S is convex
// with slopes <= 1 and S(M) >= |M - c|, whence min S >= S(c) max(1/2, 1 - |grad S(c)|).
//
// Units    [m], [m^2].
#pragma once

#include <stdexcept>

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

// What start and certificate need to know of the pressure.
struct PressureFrame {
  // Throws std::invalid_argument unless the polar moment is positive: a single point load holds no moment.
  PressureFrame(const PatchView& patch, const PressureMoments& moments);

  // All pressure lies on one line.
  bool is_line() const noexcept { return xx * yy - xy * xy <= 1e-12; }

  double x, y;          // centroid [m]
  double length;        // radius of gyration about it [m]
  double xx, xy, yy;    // second moments about it, in units of length^2
  double least_moment;  // lower bound of min S [m]
};

}  // namespace patchgrip::friction
