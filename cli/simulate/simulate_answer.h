// What `patchgrip simulate` says, as JSON: events in their order, and a summary.
#pragma once

#include <string>
#include <string_view>

#include <patchgrip/cli/simulate/motion_record.h>
#include <patchgrip/cli/simulate/simulate_scene.h>

namespace patchgrip::cli {

constexpr std::size_t most_events_listed = 1000;

// One JSON object with a line break at the end.
std::string to_json(const MotionRecord& record, const SimulateScene& scene, std::string_view scene_path);

}  // namespace patchgrip::cli
