// Elastoplastic bristles under a patch: the deflection kappa of a contact zone that is held in its plane by springs and
// dampers (seed 4.2.6).
//
//     t = -(D dkappa/dt + K kappa)                                                                      (4.64a)
//
//     corrected   dkappa/dt = (1 - beta) v - beta r G^-1 N (K kappa + U^T t_S),    r = |U v|_G / |t_S|_{G^-1}
//     printed     dkappa/dt = (1 - beta [1 - U^-1 N U]) v - beta (|U v| / |t_S|) U^-1 N K kappa    (4.63b, 4.64b)
//
// with v the twist of the body and t_S Stribeck's wrench in the mean at U v, U = [1 0 kappa_2; 0 1 -kappa_1; 0 0 1],
// all in axes that turn with the zone; N = diag(nu_0), G = diag(1, 1, L^2); beta rises from 0 to 1 as a smooth step
// where d = g(K kappa) / mu(v_m) F_N goes from `elastic_share` to 1, and is 0 while the springs relax.
//
// Sliding steadily the corrected form tends to t = t_S. The printed one pulls kappa towards the twist instead of the
// wrench: at a pole on the rim of a Hertz disc 31 degrees off, up to 1.325 times the limit; its norms add m/s and
// rad/s, so that its answer depends on the unit of length; its springs relax where kappa . v < 0, which does, too. It
// is here to be compared with. In one direction both are (4.38b).
//
// Length   L = M_0 / F_N, M_0 the moment at the pole in the centroid, keeps dissipation positive also for several
//          patches far apart, which the area radius a_K does not: down to -4.5 times the true power for two of them.
// Domain   any state. The window of d makes it 1 / (1 - elastic_share) times stiffer than sliding. A body held below
//          elastic_share of the limit does not creep.
// Units    v, kappa in (x, y, turn); K [N/m], [N/m], [N m]; D [N s/m], [N s/m], [N m s]; L [m].
// Error    a few units of rounding of the largest term, times the steepness of beta.
//          tests/dynamics/patch_bristle_test.cc.
// Throws   std::invalid_argument, naming the parameter, in the constructor; nothing afterwards.
#pragma once

#include <cmath>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/bristle_metric.h>
#include <patchgrip/friction/law.h>

namespace patchgrip::dynamics {

enum class BristleForm { corrected, printed };

struct PatchBristleParameters {
  Vector3 stiffness;         // diagonal of K, > 0
  Vector3 damping{0, 0, 0};  // of D, >= 0
  double length;             // L of the metric, > 0; without effect on the printed form
  BristleForm form = BristleForm::corrected;
  double elastic_share = 0.99;  // in (0, 1)
  Vector3 nu0{1, 1, 1};         // > 0

  void check() const;
};

struct BristleRates {
  Vector3 rate;    // dkappa/dt
  Vector3 wrench;  // t on the body, about the origin of the body's patch frame, in the zone's axes
  double beta;
};

// dkappa/dt from t_S; `yields` is d.
BristleRates bristle_rates(const PatchBristleParameters& p, const Vector3& kappa, const Vector3& v,
                           const friction::Wrench& stribeck, double yields);

// K kappa, what the springs carry.
friction::Wrench spring_wrench(const PatchBristleParameters& p, const Vector3& kappa) noexcept;

// U v
friction::Twist zone_twist(const Vector3& kappa, const Vector3& v) noexcept;

// True while the springs relax: beta is 0.
bool relaxes(const PatchBristleParameters& p, const Vector3& kappa, const Vector3& v) noexcept;

// `Surface` is RoundLimitSurface or LimitSurface of a patch.
template <class Surface>
class PatchBristle {
 public:
  PatchBristle(Surface surface, const PatchBristleParameters& p, const friction::Law& law, double normal_force)
      : surface_(std::move(surface)),
        parameters_(p),
        law_(law),
        normal_force_(contact::require_non_negative("normal_force", normal_force)) {
    p.check();
  }

  const PatchBristleParameters& parameters() const noexcept { return parameters_; }

  // g(K kappa) beyond `elastic_share` of the limit at the present speed [N]: it may slip where positive.
  double excess(const Vector3& kappa, const Vector3& v) const {
    const double limit = friction::coefficient(law_, surface_.patch().moments(), zone_twist(kappa, v)) * normal_force_;
    return surface_.gauge(spring_wrench(parameters_, kappa)).value - parameters_.elastic_share * limit;
  }

  BristleRates operator()(const Vector3& kappa, const Vector3& v) const {
    const auto& patch = surface_.patch();
    const friction::Twist u = zone_twist(kappa, v);
    if (relaxes(parameters_, kappa, v)) return bristle_rates(parameters_, kappa, v, {}, 0);
    const double limit = friction::coefficient(law_, patch.moments(), u) * normal_force_;
    const double gauge = surface_.gauge(spring_wrench(parameters_, kappa)).value;
    if (gauge <= parameters_.elastic_share * limit) return bristle_rates(parameters_, kappa, v, {}, 0);
    const double yields = limit > 0 ? gauge / limit : 1;
    return bristle_rates(parameters_, kappa, v, friction::friction_wrench(law_, normal_force_, patch, u).value, yields);
  }

 private:
  Surface surface_;
  PatchBristleParameters parameters_;
  friction::Law law_;
  double normal_force_;
};

}  // namespace patchgrip::dynamics
