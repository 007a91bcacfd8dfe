// `patchgrip press SCENE`: the answer as JSON and, if asked for, a table as CSV.
#pragma once

#include <string>

#include <patchgrip/cli/scene/materials.h>

namespace patchgrip::cli {

struct PressFiles {
  std::string scene;
  std::string output = "-";  // JSON
  std::string table;         // CSV; empty for none
};

// Throws SceneError, Unanswered, OutputError and alike; nothing is written unless all of it can be.
void run_press(const PressFiles& files, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
