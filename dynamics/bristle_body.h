// One step of a body on a patch, held by bristles: stable at every step length.
//
//     M v' = f - s,      kappa' = v - e,      s = K kappa + D kappa' in L B,      e in the normal cone of L B at s
//
// (the half-degree-of-freedom model of the seed, 4.62 with its signs corrected: f the load, s what the bristles carry,
// e the slip rate; all about the centre of mass). K = diag(k, k, k_r) and kappa are kept in axes of space, in which no
// bristle drifts for the turning of its axes; B turns with the body, by the angle that a stage is predicted to end at
// (a round patch under the centre does not care). An implicit stage of length tau is one return mapping: with
// K' = K + D / tau,
//
//     s = closest wrench to  s* = K_e [K'^-1 K kappa_0 + tau v_0 + tau^2 M^-1 f],     K_e = (K'^-1 + tau^2 M^-1)^-1
//
// in the norm of K_e^-1, the coupling with the body folded into the metric. K infinite: K_e = M / tau^2, rigid time
// stepping. Without slip the stage is solved for the change alone, v = (v_0 + tau M^-1 (f - K kappa_0)) / (1 + tau M^-1
// (tau K + D)), so that equilibrium is a fixed point to the bit.
//
// Methods      implicit Euler    one stage; order 1, damps
//              SDIRK2            gamma = 1 - 1/sqrt 2, weights 1/2: order 2, L-stable and algebraically stable (R.
//                                Alexander, SIAM J. Numer. Anal. 14, 1977; J. C. Butcher): never creates energy
//
// Energy       of both methods exact to rounding, with `numerical` >= 0, whatever L does from stage to stage: friction
//              dissipates s . e = L D(e) in each.
// Creep        none: where every stage sticks the anchor stays bit-identical.
// Limit        L = mu(v) F_N at the end of each stage: `limit(t, v)` is called with the stage's time and a prediction
//              of its twist (Vector3); a falling mu(v) taken implicitly could have several solutions. It answers with L
//              [N], or with L and the size of the patch against the one given, about the origin (Admissible): where a
//              contact grows with its load, as Hertz's by F_N^(1/3) (contact/hertz_circle.h). Nothing above changes:
//              0 is in L B whatever its size. K does not follow: bristles that stiffen under load would create energy.
// Units        m [kg], J [kg m^2], K as round_return_mapping.h, D [N s/m], [N m s]; f [N], [N], [N m]; t, h [s].
// Throws       std::invalid_argument unless m, J, h > 0, K > 0 or infinite, D >= 0 (0 for the rigid patch). step()
//              passes on what `load` and `limit` throw, and refuses a size that is not positive; where load or limit is
//              not finite so is the result.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/patch_axes.h>
#include <patchgrip/dynamics/planar_state.h>
#include <patchgrip/dynamics/return_mapping.h>
#include <patchgrip/dynamics/round_return_mapping.h>
#include <patchgrip/dynamics/stage_energy.h>

namespace patchgrip::dynamics {

enum class Method { implicit_euler, sdirk2 };

// L B of a patch whose lengths are `size` times those given (patch_axes.h).
struct Admissible {
  Admissible(double L, double relative_size = 1) : limit(L), size(relative_size) {}

  double limit;  // L [N]
  double size;   // > 0; without effect where L = 0
};

struct BristleBodyParameters {
  double mass;
  double inertia;  // about the centre of mass
  RoundStiffness stiffness{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  double damping = 0;       // [N s/m]
  double turn_damping = 0;  // [N m s]

  void check() const;
};

// Round about the origin: its friction does not change as it turns.
template <class P>
concept RoundAboutOrigin = requires(const P& patch) {
  patch.kernel();
  patch.radius();
};

template <friction::Patch P>
class BristleBody {
 public:
  BristleBody(P patch, const BristleBodyParameters& p) : mapping_(std::move(patch)), parameters_(p) {
    p.check();
    M_ = {p.mass, p.mass, p.inertia};
    C_ = Vector3(p.stiffness.k, p.stiffness.k, p.stiffness.k_r).cwiseInverse();
    D_ = {p.damping, p.damping, p.turn_damping};
    K_ = is_rigid() ? Vector3::Zero() : Vector3(C_.cwiseInverse());
  }

  const P& patch() const noexcept { return mapping_.patch(); }
  const BristleBodyParameters& parameters() const noexcept { return parameters_; }

  double kinetic_energy(const PlanarState& s) const { return s.twist.dot(M_.cwiseProduct(s.twist)) / 2; }
  double stored_energy(const PlanarState& s) const {
    const Vector3 kappa = s.deflection();
    return kappa.dot(K_.cwiseProduct(kappa)) / 2;
  }

  // From t to t + h; `load(t)` gives a Vector3, `limit(t, twist)` an Admissible or its limit.
  template <class Load, class Limit>
  StepResult step(const PlanarState& from, double t, double h, Method method, const Load& load,
                  const Limit& limit) const {
    contact::require_positive("step h", h);
    const Vector3 kappa = from.deflection();
    if (method == Method::implicit_euler) {
      const Vector3 end = from.twist + h * from.acceleration;
      const Stage one = stage(from.twist, kappa, h, load(t + h), limit(t + h, end), from.place[2] + h * end[2]);
      return combined<1>(from, h, {one}, {1});
    }
    const Vector3 end = from.twist + g * h * from.acceleration;
    const Stage one =
        stage(from.twist, kappa, g * h, load(t + g * h), limit(t + g * h, end), from.place[2] + g * h * end[2]);
    const double rest = (1 - 2 * g) * h;
    const Vector3 other = from.twist + (1 - g) * h * one.acceleration;
    const Stage two =
        stage(from.twist + rest * one.acceleration, kappa + rest * one.deflection_rate(), g * h, load(t + (1 - g) * h),
              limit(t + (1 - g) * h, other), from.place[2] + rest * one.twist[2] + g * h * other[2]);
    return combined<2>(from, h, {one, two}, {0.5, 0.5});
  }

 private:
  // The rates at the end of an implicit stage.
  struct Stage {
    Vector3 load, wrench;  // f, s
    Vector3 twist, acceleration;
    Vector3 slip_rate;  // e
    Vector3 deflection;
    bool slips;

    Vector3 deflection_rate() const { return twist - slip_rate; }
  };

  static constexpr double g = sdirk2_gamma;

  bool is_rigid() const { return C_.isZero(0); }

  // The closest wrench to `trial` that the patch admits, turned by `angle`.
  Returned closest(const Vector3& trial, const Admissible& set, const Vector3& Ke, double angle) const {
    const double size = set.limit == 0 ? 1 : contact::require_positive("size", set.size);
    const friction::Wrench felt = shrunk(trial, size);
    const double k_r = Ke[2] / (size * size);
    Returned r;
    if constexpr (RoundAboutOrigin<P>) {
      r = mapping_(felt, set.limit, {Ke[0], k_r});
    } else {
      const double c = std::cos(angle), s = std::sin(angle);
      r = mapping_({c * felt.fx + s * felt.fy, c * felt.fy - s * felt.fx, felt.m}, set.limit,
                   BristleMetric::diagonal(Ke[0], Ke[1], k_r));
      friction::Wrench& t = r.wrench.value;
      friction::Twist& u = r.slip;
      t = {c * t.fx - s * t.fy, s * t.fx + c * t.fy, t.m};
      u = {c * u.vx - s * u.vy, s * u.vx + c * u.vy, u.w};
    }
    r.wrench.value.m *= size;
    r.wrench.moment_error *= size;
    r.slip.w /= size;
    return r;
  }

  Stage stage(const Vector3& v0, const Vector3& kappa0, double tau, const Vector3& f, const Admissible& limit,
              double angle) const {
    Stage r{f, {}, {}, {}, Vector3::Zero(), kappa0, false};
    const Vector3 Kd = K_ + D_ / tau;  // K'
    const Vector3 Ke = is_rigid() ? Vector3(M_ / (tau * tau))
                                  : Vector3((Kd.cwiseInverse() + tau * tau * M_.cwiseInverse()).cwiseInverse());
    const Vector3 sprung = is_rigid() ? Vector3::Zero() : Vector3(K_.cwiseProduct(kappa0).cwiseQuotient(Kd));
    const Vector3 trial = Ke.cwiseProduct(sprung + tau * v0) + Ke.cwiseProduct(tau * tau * f.cwiseQuotient(M_));
    const Returned found = closest(trial, limit, Ke, angle);
    r.slips = found.slips;
    if (!found.slips) {
      if (is_rigid()) {
        r.twist.setZero();
        r.acceleration = -v0 / tau;
        r.wrench = trial;
        return r;
      }
      const Vector3 out = f - K_.cwiseProduct(kappa0);
      r.twist =
          (v0 + tau * out.cwiseQuotient(M_)).cwiseQuotient(Vector3::Ones() + tau * (tau * K_ + D_).cwiseQuotient(M_));
      r.acceleration = (out - (tau * K_ + D_).cwiseProduct(r.twist)).cwiseQuotient(M_);
      r.deflection = kappa0 + tau * r.twist;
      r.wrench = K_.cwiseProduct(r.deflection) + D_.cwiseProduct(r.twist);
      return r;
    }
    const friction::Wrench& s = found.wrench.value;
    r.wrench = {s.fx, s.fy, s.m};
    r.acceleration = (f - r.wrench).cwiseQuotient(M_);
    r.twist = v0 + tau * r.acceleration;
    r.slip_rate = Vector3(found.slip.vx, found.slip.vy, found.slip.w) / tau;
    r.deflection = is_rigid() ? Vector3::Zero() : Vector3(kappa0 + tau * r.deflection_rate());
    return r;
  }

  template <std::size_t n>
  StepResult combined(const PlanarState& from, double h, const std::array<Stage, n>& stages,
                      const std::array<double, n>& weights) const {
    StepResult r;
    r.state = from;
    StepEnergy& e = r.energy;
    for (std::size_t i = 0; i < n; ++i) {
      const Stage& s = stages[i];
      const double w = h * weights[i];
      r.state.place += w * s.twist;
      r.state.twist += w * s.acceleration;
      if (s.slips) r.state.anchor += w * s.slip_rate;
      r.slip += w * s.slip_rate;
      r.slips = r.slips || s.slips;
      add_stage_energy(e, w, s, D_);
    }
    if (is_rigid()) r.state.anchor = r.state.place;
    r.state.acceleration = stages[n - 1].acceleration;
    r.wrench = -stages[n - 1].wrench;
    e.numerical = numerical_loss(h, stages, M_, K_);
    r.state.work += e.work;
    r.state.dissipated += e.slip + e.damping + e.numerical;
    return r;
  }

  std::conditional_t<RoundAboutOrigin<P>, RoundReturnMapping<P>, ReturnMapping<P>> mapping_;
  BristleBodyParameters parameters_;
  Vector3 M_, C_, K_, D_;  // C = K^-1
};

}  // namespace patchgrip::dynamics
