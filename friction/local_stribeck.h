// Friction of a patch whose coefficient falls with the speed of each of its points: Stribeck's law locally.
//
//     t = -int mu(|v_P|) (v_P / |v_P|) [1; P x] p dA,    mu(v) = mu_k + (mu_s - mu_k) exp(-v^2 / v_S^2)
//
// (4.45 to 4.47 with the coefficient under the integral). Stribeck in the mean (law.h, seed 4.48) takes mu at the mean
// speed v_m instead and lets the patch keep the shape of its limit surface; both agree in translations, and where v_m
// is far from v_S. plots/local_stribeck.py shows how far apart they are elsewhere.
//
// Coulomb friction with mu_k is exact (law.h); what is integrated is the excess, with u = v / v_S
//
//     E(u) = int exp(-|u_P|^2) (u_P / |u_P|) [1; P x] p / F_N dA,    t = t_k - (mu_s - mu_k) F_N E
//
// On ellipses and discs E is a mean over directions n of the pressure's projection q on the lines across n, each with
// the wave g of kernels/stribeck_wave.h; it is the same at every pole, inside, on the rim, outside and at infinity:
//
//     E = (1 / 2 pi) int dphi [n; W s] int_-1^1 q(s) g(u . n + w W s) ds,   q = (1 - s^2)^n / B(1/2, n + 1)
//
// with W the half width of the zone; where no point is slower than u = 6.1, E is less than a rounding, and 0. On
// polygons the triangles between the pole and the edges are integrated along their rays in closed form, beyond two
// radii those between centroid and edges by points. Lines and rings are integrated along themselves (line_stribeck.cc,
// ring_stribeck.cc). XydasKaoDisc and StampDisc have no such law.
//
// Units    as law.h.
// Error    carried: that of t_k, that of v / v_S (below), and an estimate for E, mostly some 1e-15: of the quadrature
//          (kernels/vector_quadrature.h) and of rounding, which is counted, in units of 2^-53:
//
//          Ellipses and discs. The wave g jumps by pi where it changes sign, at s = u . n / w W. Its place takes 8
//          roundings, 5 on discs, where W takes none. They move it by so many units k of itself: the pole at x radii,
//
//              |dE| <= k units C(x),   C = int dphi s q(s),  s = x cos phi
//
//          C <= 1 for n >= 0. A projection that is infinite at the rim (n < 0, discs alone) has
//
//              C <= min(1 / (n + 1/2), ln((1 + x) / |1 - x|) + 1) / B(1/2, n + 1)
//
//          (the ring's is ln(...) / pi, any q is below pi / B of the ring's; 1 for the mean across the singularity),
//          where |1 - x| is no less than the k units. Elsewhere w W s and the sum, 6 units, 3 on discs, move g by as
//          many of |t g'(t)| <= min(1.336, 3 pi / 2 t^2); g is known to 4 units of pi/2 (kernels/stribeck_wave.h). On
//          ellipses n is rounded, too, by 4 units, which move W by 4 a / W of itself, of which the mean is 2 K / pi <=
//          1 + 2 ln(a / b) / pi: 4 units more, so many times, for the place and for t. What is in proportion to the
//          integrand is integrated with it (ellipse_stribeck.cc). Rings have no C: they are not integrated so.
//
//          Polygons (polygon_stribeck.cc): in proportion to the triangles, whose sizes exceed their sum where the pole
//          is beside a slender patch, by about its aspect.
//
//          tests/friction/local_stribeck_error_test.cc, `bounds --kind local_ring` and others of local_*.
// Cost     some milliseconds.
#pragma once

#include <cmath>

#include <patchgrip/friction/hessian_beside.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/stribeck_excess.h>

namespace patchgrip::friction {

// t_k - (mu_s - mu_k) F_N E
BoundedWrench with_stribeck_excess(const BoundedWrench& kinetic, double excess_force,
                                   const BoundedWrench& excess) noexcept;

// E with what the rounding of u = v / v_S can move it by. With V the speed at the origin |w| |P| <= V + |u_P|, so that
// |du_P| <= e (V + |w| |P|) <= e (2 V + |u_P|), e = 2^-53. Across u_P it turns the integrand by |du_P| / |u_P|, of which
// hessian_beside.h has the means, T and S. Along u_P the integrand changes by 2 |u_P| exp(-u_P^2) |du_P|, which is less,
// with an arm of r at root mean square:
//
//     |dE_f| <= e (2 V T + 1),   |dE_m| <= e [2 V (S + r sqrt(0.58 T / v_S)) + 2 r]
//
// (4 s^3 exp(-2 s^2) <= 0.58).
template <Patch P>
BoundedWrench with_rounding_of_speeds(BoundedWrench E, const P& patch, const Twist& v, double v_S) noexcept {
  constexpr double unit = 0x1p-53;
  const double V = std::hypot(v.vx, v.vy);
  const PressureMoments s = patch.moments();
  const double r = std::sqrt(s.polar);
  double force = unit, moment = 2 * unit * r;
  if (V > 0) {
    const auto [T, S] = reciprocal_speeds(patch, v);
    force += 2 * unit * V * T;
    moment += 2 * unit * V * (S + r * std::sqrt(0.58 * T / v_S));
  }
  return with_change(E, s, force, moment);
}

// Friction wrench at the twist v with the coefficient of each point; `normal_force` F_N [N], >= 0.
template <LocalPatch P>
BoundedWrench local_friction_wrench(const Law& law, double normal_force, const P& patch, const Twist& v) noexcept {
  Law kinetic = law;
  kinetic.mu_static = law.mu_kinetic;
  const BoundedWrench t = friction_wrench(kinetic, normal_force, patch, v);
  if (law.mu_static == law.mu_kinetic) return t;
  const double v_S = law.stribeck_velocity;
  const BoundedWrench E = stribeck_excess(patch, {v.vx / v_S, v.vy / v_S, v.w / v_S});
  return with_stribeck_excess(t, (law.mu_static - law.mu_kinetic) * normal_force,
                              with_rounding_of_speeds(E, patch, v, v_S));
}

}  // namespace patchgrip::friction
