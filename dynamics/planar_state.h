// State and energy of a body that moves in the contact plane on bristles.
//
// The place (x, y, turn) and twist are those of the centre of mass, the anchor is the place minus the deflection kappa
// of the bristles: it changes only where the patch slips, so that rounding cannot move what sticks.
//
// Units    x, y [m], turn [rad]; twist as friction/twist.h; energies [J].
#pragma once

#include <patchgrip/dynamics/bristle_metric.h>

namespace patchgrip::dynamics {

struct PlanarState {
  Vector3 place = Vector3::Zero();
  Vector3 twist = Vector3::Zero();
  Vector3 anchor = Vector3::Zero();
  Vector3 acceleration = Vector3::Zero();  // of the last step: predictions rest on it
  double work = 0;                         // of the load, since the start [J]
  double dissipated = 0;                   // by friction, dampers and the method, since the start [J]

  Vector3 deflection() const { return place - anchor; }  // kappa
};

// Of one step. work = change of kinetic + change of stored + slip + damping + numerical.
struct StepEnergy {
  double work = 0;       // of the load
  double slip = 0;       // dissipated by friction, >= 0
  double damping = 0;    // by the dampers of the bristles, >= 0
  double numerical = 0;  // lost by the method, >= 0
};

struct StepResult {
  PlanarState state;
  Vector3 wrench = Vector3::Zero();  // of friction on the body, at the end of the step
  Vector3 slip = Vector3::Zero();    // of the contact zone in the step
  bool slips = false;
  StepEnergy energy;
};

}  // namespace patchgrip::dynamics
