// The motion of a body on a patch, by the method that its scene names.
#pragma once

#include <patchgrip/cli/simulate/motion_record.h>
#include <patchgrip/cli/simulate/simulate_scene.h>

namespace patchgrip::cli {

// Adds to `record` as it goes: what is there stays when it throws. The `second` run takes half of the step, or a
// hundred times the tolerance. Throws SceneError, Interrupted, and std::runtime_error where steps come to nothing.
void simulate_patch(const SimulateScene& scene, bool second, MotionRecord& record);

// The same for a body on another one (scene.upper).
void simulate_stack(const SimulateScene& scene, bool second, MotionRecord& record);

// The same for a point mass.
void simulate_point(const SimulateScene& scene, bool second, MotionRecord& record);

}  // namespace patchgrip::cli
