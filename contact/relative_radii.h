// Relative radii of curvature of two bodies that touch in a point: the paraboloid x^2/(2 R_large) + y^2/(2 R_small)
// that a rigid plane would have to be to leave the same gap.
//
// With the curvatures k = 1/R of the bodies p and m (seed: + and -), alpha the angle from the R1p to the R1m direction,
// d = k1 - k2 of each body (seed 4.1.3, Johnson 4.3):
//
//     S = k1p + k2p + k1m + k2m
//     D = sqrt((dp + dm)^2 cos^2 alpha + (dp - dm)^2 sin^2 alpha)
//     det = (k1p + k1m)(k2p + k2m) cos^2 alpha + (k1p + k2m)(k2p + k1m) sin^2 alpha
//     R_small = 2 / (S + D),   R_large = (S + D) / (2 det),   1 - R_small / R_large = 2 D / (S + D)
//
// (S^2 - D^2)/4 = det would cancel for nearly parallel cylinders. The direction of the larger relative curvature lies
// at (1/2) atan2(dm sin 2 alpha, dp + dm cos 2 alpha) from the R1p direction; the semi-axis a is perpendicular to it.
//
// Domain   radii positive, infinite (plane) or negative (hollow), as long as det > 0 and S > 0: else the bodies touch
//          along a line or in more places.
// Units    R [m], alpha and angle_a [rad].
// Error    R_small, R_large <= 1.01 units of 2^-53, relative, plus 2^-9 units per unit of the condition
//          (|first| + |second term|) / det, which is 1 unless a saddle or a hollow takes part: both to radius_units;
//          1 - R_small / R_large <= 1.01 units + 2^-9 units (|dp| + |dm|) / D of its size;
//          tests/contact/relative_radii_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain or where a radius would not be
//          representable.
#pragma once

namespace patchgrip::contact {

struct PrincipalRadii {
  double R1;  // [m], infinite: straight; negative: hollow
  double R2;  // [m]
};

struct RelativeRadii {
  static RelativeRadii of_bodies(const PrincipalRadii& p, const PrincipalRadii& m, double alpha);
  // The gap itself, a along the first axis. 0 < small <= large < infinity.
  static RelativeRadii of(double small, double large);
  // Nearly circular: 1 - small / large in [0, 1/2].
  static RelativeRadii of_one_minus_ratio(double one_minus_ratio, double large);

  double small;             // R_small [m], along b
  double large;             // R_large [m], along a
  double one_minus_ratio;   // 1 - R_small / R_large [1]
  double angle_a;           // from the R1p direction to the semi-axis a [rad], in (-pi/2, pi/2]; pi/2 for a circle
  double radius_units = 0;  // bound of the relative error of small and large in units of 2^-53; 0 where they were given
};

}  // namespace patchgrip::contact
