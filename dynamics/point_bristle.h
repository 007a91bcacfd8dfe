// Dynamic friction of a point: the deflection kappa of a bristle as a state (seed 4.2.2).
//
//     force     R = c_0 kappa + c_1 dkappa/dt + c_2 V(v)                                              (4.36a, 4.37a)
//
//     Dahl, LuGre         dkappa/dt = -v (1 - c_0 kappa / S(v))                      Dahl: c_1 = 0
//     elastoplastic       dkappa/dt = -v (1 - beta c_0 kappa / S(v))                 Dupont et al.      (4.37b)
//     with nu_0           dkappa/dt = -(1 - beta [1 - nu_0]) v + beta nu_0 v c_0 kappa / S(v)           (4.38b)
//     half degree of      dkappa/dt = u - v,  c_1 u - S(u) - V(u) = c_1 v - c_0 kappa where its size is more
//     freedom, exact      than mu_s F_N, else u = 0: the zone's own velocity                              (4.34)
//     linearised          dkappa/dt = -v (1 - alpha [1 - nu (1 - c_0 kappa / (S + V))])
//                         nu = [mu(v) + mu_V |v|] F_N / (c_1 |v| - |v| d(S + V)/dv)                     (4.36b)
//
//     beta   0 where the bristle relaxes (kappa v >= 0) or |kappa| <= kappa_1, 1 beyond kappa_2 = |S(v)| / c_0, and
//            (|kappa| - kappa_1)^2 (3 kappa_2 - kappa_1 - 2 |kappa|) / (kappa_2 - kappa_1)^3 between
//     alpha  a_v + a_F - a_v a_F, a_v = ramp(|v + dkappa/dt| / dv), a_F = ramp(|c_0 kappa + c_1 dkappa/dt| / mu_s F_N),
//            ramp(x) from 0 at x = 1 to 1 at 1.01                                                       (4.35);
//            it hangs on the rate that it is to give, so a motion takes a_F of what the bristle would carry if its zone
//            stood still, alpha = ramp(|c_0 kappa - c_1 v| / mu_s F_N): the zone slides where the exact one does
//
// Boundary layer: the zone has a mass e and the velocity u = v + dkappa/dt, its friction smoothed as the seed does,
//
//     e (dv/dt + d^2kappa/dt^2) = tanh(a |u|) S(u) + V(u) - c_0 kappa - c_1 dkappa/dt                     (4.33)
//
// and e -> 0 is half a degree of freedom.
//
// The seed's beta asks for sgn kappa = sgn v; with its dkappa/dt = -v (...) a bristle that is being stretched has the
// other sign. As printed example 4.7 never slides. Its nu has the bracket of mu(v) in the wrong place.
//
// Domain   any state. nu is singular, and negative below, where c_1 + mu_V F_N = 0.857764 (mu_s - mu_k) F_N / v_S at
//          some v: there the half degree of freedom has no one solution; below, one of several is found. A bristle
//          dissipates if r = c_1 |v| / |S| is at most rho^2 / (rho - 1), rho = mu_s / mu_k < 2, or 4 beyond; with nu_0
//          if nu_0 <= 1 / (1 - kappa_1 / kappa_2); linearised if 0 <= nu (1 - c_0 kappa / S) <= 1. Dahl and LuGre creep
//          under a load that oscillates below the limit; elastoplastic does not.
// Unpressed    where mu_s F_N = 0 a bristle stays as it is and carries nothing, R = c_2 V: yielding to S -> 0 it is
//              straight as soon as it slides. A motion lets it go there, kappa = 0, and loses what it had stored.
// Units    c_0 [N/m], c_1 [N s/m]; kappa [m]; v [m/s]; R [N].
// Error    a few units of rounding of the largest term; tests/dynamics/point_law_test.cc.
// Throws   PointBristle::check std::invalid_argument, naming the parameter. Nothing else.
#pragma once

#include <patchgrip/dynamics/point_law.h>

namespace patchgrip::dynamics {

struct PointBristle {
  double c0;                   // [N/m], > 0
  double c1 = 0;               // [N s/m], >= 0
  double viscous_share = 0;    // c_2 [1], in [0, 1]
  double elastic_share = 0.9;  // kappa_1 / kappa_2, in [0, 1)
  double nu0 = 1;              // > 0

  void check() const;
};

// beta [1]; `stribeck` S(v) [N].
double plastic_share(const PointBristle& bristle, double stribeck, double kappa, double v) noexcept;

// dkappa/dt [m/s]
double dahl_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa, double v) noexcept;
double elastoplastic_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa,
                          double v) noexcept;
double extended_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa, double v) noexcept;

// nu(|v|) [1], v != 0.
double half_freedom_gain(const PointBristle& bristle, const Law& law, double normal_force, double v) noexcept;
double half_freedom_rate(const PointBristle& bristle, const Law& law, double normal_force, double alpha, double kappa,
                         double v) noexcept;

// In motion, alpha by what the zone would carry at rest; c_1 > 0.
double half_freedom_linearised_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa,
                                    double v) noexcept;

// By the root, instead of nu; c_1 > 0.
double half_freedom_exact_rate(const PointBristle& bristle, const Law& law, double normal_force, double kappa,
                               double v) noexcept;

struct BoundaryLayer {
  double mass;       // e [kg], > 0
  double steepness;  // a [s/m], > 0
};

// Friction on the zone at its own velocity u [N].
double boundary_layer_force(const BoundaryLayer& zone, const Law& law, double normal_force, double u) noexcept;

// ramp(x): 0 up to 1, 1 from 1.01.
double switch_ramp(double x) noexcept;

// c_0 kappa + c_1 dkappa/dt [N]: between body and zone, pressed or not.
double bristle_pull(const PointBristle& bristle, double kappa, double rate) noexcept;

// R [N], of the support on the body, by a bristle that yields; half a degree of freedom has bristle_pull.
double bristle_force(const PointBristle& bristle, const Law& law, double normal_force, double kappa, double rate,
                     double v) noexcept;

}  // namespace patchgrip::dynamics
