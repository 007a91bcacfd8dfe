// `patchgrip simulate SCENE`: events and a summary as JSON and, if asked for, the motion over time as CSV.
#pragma once

#include <string>

#include <patchgrip/cli/scene/materials.h>

namespace patchgrip::cli {

struct SimulateFiles {
  std::string scene;
  std::string output = "-";  // JSON
  std::string table;         // CSV; empty for none
};

// Throws SceneError, OutputError and alike, and then nothing is written. Where it is stopped by a signal (Interrupted)
// or the motion cannot be followed further (Unanswered) what was found until then is written first, and says so.
void run_simulate(const SimulateFiles& files, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
