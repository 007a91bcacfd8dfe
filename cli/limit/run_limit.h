// `patchgrip limit SCENE`: gauge, margin and slip of every load as JSON and, if asked for, as a table; the limit
// surface for other programs, and a picture of it.
#pragma once

#include <string>

#include <patchgrip/cli/scene/materials.h>

namespace patchgrip::cli {

struct LimitFiles {
  std::string scene;
  std::string output = "-";  // JSON
  std::string table;         // CSV of the loads; empty for none, like those below
  std::string surface;       // .vtk or .csv
  std::string picture;       // .svg
};

// Throws SceneError, Unanswered, OutputError and alike; nothing is written unless all of it can be.
void run_limit(const LimitFiles& files, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
