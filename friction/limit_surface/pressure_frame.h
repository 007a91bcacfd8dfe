// What the gauge knows of a patch beforehand: where its pressure lies, and its kinks.
//
// Centroid c, second moments about it, and a lower bound of the least moment min S that a rotation meets: S is convex
// with slopes <= 1 and S(M) >= |M - c|, whence min S >= S(c) max(1/2, 1 - |grad S(c)|).
//
// Twists and wrenches about the centroid have spins times the radius of gyration and moments over it.
//
// Units    [m], [m^2].
// Throws   std::invalid_argument unless the radius of gyration is positive (a single point load holds no moment), and
//          as CentralMoment, so far from the origin that rounding is all there is of S(c).
#pragma once

#include <vector>

#include <patchgrip/friction/limit_surface/kink.h>
#include <patchgrip/friction/limit_surface/patch_view.h>
#include <patchgrip/friction/limit_surface/vector3.h>
#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

struct PressureFrame {
  PressureFrame(const PatchView& patch, const PressureMoments& moments, std::vector<PointShare> shares);

  // All pressure lies on one line, as far as rounding of the moments tells: no zone of an aspect below about 1e7 does.
  bool is_line() const noexcept { return xx * yy - xy * xy <= spread_error; }

  Vector about_centroid(const Wrench& t) const noexcept { return {t.fx, t.fy, (t.m - (x * t.fy - y * t.fx)) / length}; }
  Vector about_centroid(const Twist& v) const noexcept { return {v.vx - v.w * y, v.vy + v.w * x, v.w * length}; }
  Twist about_origin(const Vector& u) const noexcept;
  Hessian about_centroid(const Hessian& h) const noexcept;

  double x, y;              // centroid [m]
  double length;            // radius of gyration about it [m]
  double xx, xy, yy;        // second moments about it, in units of length^2
  double spread_error;      // of their determinant
  double least_moment;      // lower bound of min S [m]
  std::vector<Kink> kinks;  // at point loads
};

}  // namespace patchgrip::friction
