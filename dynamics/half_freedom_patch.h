// Half a degree of freedom under a patch: a contact zone without mass on springs and dampers that rubs by the exact law
// of friction (seed 4.59 to 4.62, with their signs corrected).
//
//     D dkappa/dt + K kappa = s,    t = -s,    s in L B_U, e in its normal cone,    e = v - dkappa/dt
//
// e is the slip rate of the zone, U e = e + (kappa_2, -kappa_1, 0) e_3 its twist about its own origin, L = mu(v_m) F_N
// at U e, B_U what D_U(e) = D(U e) supports. The seed writes that as dkappa/dt = -alpha D^-1 [K kappa + U^T t_S(U e)] +
// (1 - alpha) v, where e stands on both sides; no fixed-point iteration of it converges. It is
//
//     e = argmin of  L D(U e) + e . D e / 2 - s* . e,      s* = K kappa + D v
//
// a return mapping (returned.h) of U^-T s* in the metric U^-T D U^-1: the resolvent of friction, exact and unique. It
// sticks, dkappa/dt = v exactly, if and only if g(U^-T s*) <= mu_s F_N. Where mu falls with v_m, L is the root of
// mu(v_m(e(L))) F_N - L between mu_k F_N and mu_s F_N.
//
// Domain   dampers stronger than friction falls, c = sqrt(2/e) (mu_s - mu_k) F_N / v_S: then that root is one. In one
//          direction D > c; in the plane D > c Q suffices, v . Q v the mean square of v_P (kappa = 0). Weaker dampers
//          make the zone jump: the law has then more than one answer.
// Units    v, kappa in (x, y, turn), in axes that turn with the zone; K [N/m], [N m]; D [N s/m], [N m s]; t [N], [N m].
// Error    s solves the inclusion to some 1e-14 L; dissipation -t . v - K kappa . dkappa/dt = s . e + dkappa/dt . D
//          dkappa/dt is never negative. tests/dynamics/half_freedom_patch_test.cc.
// Stiff    it relaxes with D^-1 K.
// Throws   std::invalid_argument, naming the parameter, in the constructor; nothing afterwards.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/patch_bristle.h>
#include <patchgrip/dynamics/return_mapping.h>

namespace patchgrip::dynamics {

struct HalfFreedomParameters {
  Vector3 stiffness;  // diagonal of K, > 0
  Vector3 damping;    // of D, > 0

  // Also that D > c Q.
  void check(const friction::PressureMoments& moments, const friction::Law& law, double normal_force) const;
};

// c [N s/m]
double least_damping(const friction::Law& law, double normal_force) noexcept;

// U^-T s
friction::Wrench zone_wrench(const Vector3& kappa, const Vector3& s) noexcept;

// U^-T D U^-1
Matrix3 zone_damping(const Vector3& kappa, const Vector3& damping);

template <friction::Patch P>
class HalfFreedomPatch {
 public:
  HalfFreedomPatch(P patch, const HalfFreedomParameters& p, const friction::Law& law, double normal_force)
      : mapping_(std::move(patch)),
        moments_(mapping_.patch().moments()),
        parameters_(p),
        law_(law),
        normal_force_(contact::require_non_negative("normal_force", normal_force)) {
    p.check(moments_, law, normal_force);
  }

  const HalfFreedomParameters& parameters() const noexcept { return parameters_; }

  // g(U^-T s*) - mu_s F_N [N]: slips where positive.
  double excess(const Vector3& kappa, const Vector3& v) const {
    return mapping_.surface().gauge(zone_wrench(kappa, trial(kappa, v))).value - law_.mu_static * normal_force_;
  }

  // beta is alpha: 1 where it slips, else 0.
  BristleRates operator()(const Vector3& kappa, const Vector3& v) const {
    const Vector3 pull = trial(kappa, v);
    const friction::Wrench zone = zone_wrench(kappa, pull);
    const BristleMetric metric(zone_damping(kappa, parameters_.damping));
    const auto returned = [&](double limit) { return mapping_(zone, limit, metric); };
    Returned r = returned(law_.mu_static * normal_force_);
    if (!r.slips) return {v, -pull, 0};
    const auto too_weak = [&](double limit) {
      return friction::coefficient(law_, moments_, returned(limit).slip) * normal_force_ - limit;
    };
    const double lo = law_.mu_kinetic * normal_force_, hi = law_.mu_static * normal_force_;
    if (lo < hi) {
      const double at_lo = too_weak(lo), at_hi = too_weak(hi);
      std::uintmax_t steps = 100;
      double limit = at_lo > 0 ? hi : lo;
      if (at_lo > 0 && at_hi < 0) {
        const auto [a, b] = boost::math::tools::toms748_solve(too_weak, lo, hi, at_lo, at_hi,
                                                              boost::math::tools::eps_tolerance<double>(52), steps);
        limit = (a + b) / 2;
      }
      r = returned(limit);
    }
    const friction::Twist& u = r.slip;  // U e
    const Vector3 e(u.vx - kappa[1] * u.w, u.vy + kappa[0] * u.w, u.w);
    const Vector3 rate = v - e;
    return {rate, -(parameters_.damping.cwiseProduct(rate) + parameters_.stiffness.cwiseProduct(kappa)), 1};
  }

 private:
  Vector3 trial(const Vector3& kappa, const Vector3& v) const {
    return parameters_.stiffness.cwiseProduct(kappa) + parameters_.damping.cwiseProduct(v);
  }

  ReturnMapping<P> mapping_;
  friction::PressureMoments moments_;
  HalfFreedomParameters parameters_;
  friction::Law law_;
  double normal_force_;
};

}  // namespace patchgrip::dynamics
