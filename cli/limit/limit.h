// Does friction hold the loads of a scene? The answers, load by load.
#pragma once

#include <patchgrip/cli/limit/limit_answer.h>
#include <patchgrip/cli/limit/limit_scene.h>
#include <patchgrip/cli/limit/load_answer.h>

namespace patchgrip::cli {

// What friction can bear, by mu F_N or by the parts' own coefficients.
Capacity capacity_of(const LimitScene& scene);

// Throws SceneError where a gauge leaves the range of a double, and Interrupted.
LimitAnswer answer_limit(const LimitScene& scene);

}  // namespace patchgrip::cli
