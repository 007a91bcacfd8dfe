// A body on a patch that is held by bristles, elastoplastic ones (patch_bristle.h) or half a degree of freedom
// (half_freedom_patch.h), under a load: an ordinary differential equation.
//
//     M v' = f(t) + A t,      dkappa/dt and t of the bristles in axes that turn with the zone, by A: phi - kappa_3
//
// State    place (x, y, phi) and twist in axes of space, kappa in those of the zone; then the work of the load and what
//          bristles and dampers have lost, so that  kinetic + kappa . K kappa / 2 = work - loss + what was at first.
// Patch    under the centre of mass.
// Units    m [kg], J [kg m^2], f [N], [N], [N m]; energies [J].
// Fails    stiff: explicit steps of elastoplastic bristles are some 1 / 150 of those of steady sliding in the window of
//          beta, of half a degree of freedom 2.8 D / K at most. The printed form may gain energy: its loss is then
//          negative.
// Throws   std::invalid_argument unless m, J > 0. Nothing afterwards.
#pragma once

#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/patch_axes.h>
#include <patchgrip/dynamics/patch_bristle.h>
#include <patchgrip/dynamics/trajectory.h>

namespace patchgrip::dynamics {

// `Bristle` is PatchBristle or HalfFreedomPatch.
template <class Bristle>
class BristleMotion {
 public:
  using Flow = Trajectory<11>;
  using State = Flow::State;

  BristleMotion(Bristle bristle, double mass, double inertia)
      : bristle_(std::move(bristle)),
        mass_(contact::require_positive("mass", mass)),
        inertia_(contact::require_positive("inertia", inertia)) {}

  const Bristle& bristle() const noexcept { return bristle_; }

  double kinetic_energy(const State& y) const {
    return (mass_ * (y[3] * y[3] + y[4] * y[4]) + inertia_ * y[5] * y[5]) / 2;
  }
  double stored_energy(const State& y) const {
    const Vector3 kappa(y[6], y[7], y[8]);
    return kappa.dot(bristle_.parameters().stiffness.cwiseProduct(kappa)) / 2;
  }

  // On the body, in axes of space.
  Vector3 wrench(const State& y) const { return now(y).wrench; }

  // [N]: the zone slips, or may, where positive.
  double excess(const State& y) const { return bristle_.excess({y[6], y[7], y[8]}, twist_of(y)); }

  // dy/dt
  State operator()(const Vector3& load, const State& y) const {
    const Now b = now(y);
    const Vector3 v(y[3], y[4], y[5]), kappa(y[6], y[7], y[8]);
    const Vector3 springs = bristle_.parameters().stiffness.cwiseProduct(kappa);
    return {y[3],
            y[4],
            y[5],
            (load[0] + b.wrench[0]) / mass_,
            (load[1] + b.wrench[1]) / mass_,
            (load[2] + b.wrench[2]) / inertia_,
            b.rate[0],
            b.rate[1],
            b.rate[2],
            load.dot(v),
            -b.wrench.dot(v) - springs.dot(b.rate)};
  }

 private:
  struct Now {
    Vector3 wrench, rate;
  };

  // In axes of the zone.
  static Vector3 twist_of(const State& y) { return turned({y[3], y[4], y[5]}, y[8] - y[2]); }

  Now now(const State& y) const {
    const BristleRates b = bristle_({y[6], y[7], y[8]}, twist_of(y));
    return {turned(b.wrench, y[2] - y[8]), b.rate};
  }

  Bristle bristle_;
  double mass_, inertia_;
};

}  // namespace patchgrip::dynamics
