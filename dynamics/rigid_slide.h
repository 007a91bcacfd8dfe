// A body sliding on a rigid patch until it comes to rest: the set-valued law of Coulomb and Contensou, without bristles.
//
//     M v' = f + t(v),    t(v) = -mu(v_m) F_N grad D(v)  (friction/law.h)
//
// Near rest the direction of v turns ever faster, and no step of t is short enough. With p = M^(1/2) v = rho n, |n| = 1,
// and the stretched time ds = dt / rho
//
//     dn/ds = G - n (n . G),   d ln rho / ds = n . G,   dt/ds = rho,   dx/ds = rho v,       G = M^(-1/2) (f + t)
//
// is regular through the stop: rho falls exponentially, t converges. At the end n is the pole's limit, the root of
// f(x) = q x m(x) for a puck. If n . G is positive at the end the body does not stop and speeds up again.
//
// Method       Dormand and Prince, order 5(4), steps by their error (Boost.Odeint), in stretched time all the way.
// Patch        under the centre of mass; turns with the body.
// Domain       any start in motion; constant load, normal force and law, where the body comes to rest. A load that
//              friction does not stop: `stopped` is false when time reaches `longest`.
// Units        m [kg], J [kg m^2]; load [N], [N], [N m]; F_N [N]; t [s].
// Error        of time and place: what a hundredfold tolerance changes. Stop time and distance of pucks to 1e-13 at the
//              tolerance 1e-13; tests/dynamics/rigid_slide_test.cc.
// Throws       std::invalid_argument unless m, J, tolerance and longest are positive, F_N >= 0 and the start moves.
#pragma once

#include <utility>

#include <patchgrip/contact/require.h>
#include <patchgrip/dynamics/planar_state.h>
#include <patchgrip/friction/law.h>

namespace patchgrip::dynamics {

struct SlideSettings {
  double tolerance = 1e-12;  // of ln rho and n in a step, in [1e-14, 1e-2]
  double longest = 1e6;      // [s]

  void check() const;
};

struct Slide {
  PlanarState state;  // twist: 0 if it stopped
  double time = 0;    // from the start [s]
  bool stopped = false;
  Vector3 last_direction = Vector3::Zero();  // twist / rho at the end: its pole is the one that it stops about
  double time_error = 0;                     // [s]
  Vector3 place_error = Vector3::Zero();     // [m], [m], [rad]
  long evaluations = 0;                      // of the wrench
};

// Friction wrench at a twist, in the axes of the patch.
class SlideForce {
 public:
  virtual ~SlideForce() = default;
  virtual friction::Wrench operator()(const friction::Twist& v) const noexcept = 0;
};

struct SlideProblem {
  Vector3 mass;  // (m, m, J)
  Vector3 load;  // in space axes
  const SlideForce* friction;
};

Slide slide_to_rest(const SlideProblem& problem, const PlanarState& from, const SlideSettings& settings);

template <friction::Patch P>
class RigidSlide {
 public:
  RigidSlide(P patch, double mass, double inertia, const friction::Law& law, double normal_force)
      : force_(std::move(patch), law, contact::require_non_negative("normal_force", normal_force)),
        mass_(contact::require_positive("mass", mass), mass, contact::require_positive("inertia", inertia)) {}

  Slide operator()(const PlanarState& from, const Vector3& load = Vector3::Zero(),
                   const SlideSettings& settings = {}) const {
    return slide_to_rest({mass_, load, &force_}, from, settings);
  }

 private:
  struct Force final : SlideForce {
    Force(P p, const friction::Law& l, double F_N) : patch(std::move(p)), law(l), normal_force(F_N) {}
    friction::Wrench operator()(const friction::Twist& v) const noexcept override {
      return friction::friction_wrench(law, normal_force, patch, v).value;
    }
    P patch;
    friction::Law law;
    double normal_force;
  };

  Force force_;
  Vector3 mass_;
};

}  // namespace patchgrip::dynamics
