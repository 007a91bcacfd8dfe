// Viscoelastic bodies, or any that are loaded over time: radius, approach, force and pressure at the times of the
// scene.
#pragma once

#include <patchgrip/cli/press/pressed.h>
#include <patchgrip/cli/table.h>

namespace patchgrip::cli {

struct PressedOverTime {
  Answer answer;                  // at the last time
  Table table;                    // the history or, where the scene asks for profile.times, the surface at these times
  std::vector<std::string> head;  // for the table
};

// Throws std::invalid_argument where the scene asks for what is not covered, std::runtime_error where something does
// not converge.
PressedOverTime press_over_time(const PressScene& scene);

}  // namespace patchgrip::cli
