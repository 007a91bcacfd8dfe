// `patchgrip grasp SCENE`: what is asked of a grasp as JSON and, if asked for, as a table; a picture, and vectors for
// other programs.
#pragma once

#include <string>

#include <patchgrip/cli/scene/materials.h>

namespace patchgrip::cli {

struct GraspFiles {
  std::string scene;
  std::string output = "-";  // JSON
  std::string table;         // CSV of the loads or the family; empty for none, like those below
  std::string vectors;       // .vtk
  std::string picture;       // .svg
  std::string inequalities;  // .dat-s: the least grip of the first load as linear matrix inequalities (grasp/lmi.h)
};

// Throws SceneError, OutputError and alike; nothing is written unless all of it can be.
void run_grasp(const GraspFiles& files, const std::string& question, const MaterialLibrary& materials);

}  // namespace patchgrip::cli
