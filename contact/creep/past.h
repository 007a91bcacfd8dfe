// The state of the growing contact that a shrinking one has gone back to (Ting 1966).
//
// A contact that shrinks has at time t the radius that it had at an earlier time t_1 < t, while it grew. The measure is
// what sets the radius: X [m^2] under a given force, delta [m] at a given approach. Where the measure jumped at t_1 it
// may be any value within the jump.
#pragma once

namespace patchgrip::contact {

struct Past {
  double time;     // t_1 [s]
  double measure;  // X [m^2] or delta [m] at t_1
};

}  // namespace patchgrip::contact
