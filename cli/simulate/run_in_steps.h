// Follows a flow (dynamics/trajectory.h) to a time, without stepping over what a load that oscillates does in between.
#pragma once

#include <patchgrip/cli/interrupt.h>

namespace patchgrip::cli {

// `note` and the answer as of Trajectory::run. Throws Interrupted.
template <class Flow, class Note>
bool run_in_steps(Flow& flow, double time, double longest_step, const Note& note) {
  while (time - flow.time() > longest_step) {
    InterruptGuard::check();
    if (flow.run(flow.time() + longest_step, note)) return true;
  }
  return flow.run(time, note);
}

}  // namespace patchgrip::cli
