// A point load as the gauge sees it: the kink that it gives D, and what the rest of the patch does about it.
//
// With the share w in P, D = R + w |v_P|, and B is the sum of the body of R and a disc:
//
//     B = B_R + { forces q through P, |q| <= w }
//
// So a gradient of R and any such q make a point of B, and with the pole on P, where v_P = 0, every one of them is a
// subgradient of D. Close to P, at v = (velocity of P, spin), R is smooth where D is not: gradient R = grad D - w v_P /
// |v_P| through P, and the derivatives of its force in v_P are the block H_R below.
//
// Units    [m], [1]; H_R of a spin 1 [1 / m].
#pragma once

#include <vector>

#include <patchgrip/friction/limit_surface/patch_view.h>
#include <patchgrip/friction/point_shares.h>

namespace patchgrip::friction {

// How far from a kink of D, or from a line load, curvatures are taken, in radii of gyration: rounding leaves 2^-53 /
// beside = 1e-10 of them there, and they change by about `beside` of the rest's.
inline constexpr double beside = 1e-6;

// A vector in the plane: a force [1], or the velocity of the point [m/s].
struct Planar {
  double x = 0;
  double y = 0;
};

inline double length_of(const Planar& a) noexcept { return std::hypot(a.x, a.y); }

// Symmetric; of force by velocity.
struct Stiffness {
  double xx = 0;
  double xy = 0;
  double yy = 0;
  double rounding = 0;  // of each

  Planar operator*(const Planar& z) const noexcept { return {xx * z.x + xy * z.y, xy * z.x + yy * z.y}; }
};

// Where a patch slips at unit spin, with the point at the velocity z, and the gradient of R there.
struct NearKink {
  Twist twist;
  Planar z;             // as the twist has it, to rounding
  BoundedWrench whole;  // grad D
  BoundedWrench rest;   // grad R
};

struct Kink {
  PointShare point;
  NearKink at_rest;     // z = 0: the pole on the point
  Stiffness stiffness;  // H_R there

  double moment(const Wrench& t) const noexcept { return t.m - (point.x * t.fy - point.y * t.fx); }  // about the point
  Wrench through_point(const Planar& q) const noexcept { return {q.x, q.y, point.x * q.y - point.y * q.x}; }
  Twist twist(const Planar& z) const noexcept { return {point.y + z.x, z.y - point.x, 1}; }
  Planar velocity(const Twist& v) const noexcept {
    return {std::fma(-v.w, point.y, v.vx), std::fma(v.w, point.x, v.vy)};
  }

  NearKink at(const PatchView& patch, const Twist& v) const noexcept;  // v.w = 1
  NearKink near(const PatchView& patch, const Planar& z) const noexcept { return at(patch, twist(z)); }

  // H_R with the point at a velocity z, |z| no less than about `beside`: rounding leaves 2^-53 / |z| of it.
  Stiffness stiffness_at(const PatchView& patch, const Twist& v) const noexcept;  // v.w = 1
};

// Shares at one point are one. `length` is about the size of the pressure.
std::vector<Kink> kinks_of(const PatchView& patch, std::vector<PointShare> shares, double length);

}  // namespace patchgrip::friction
