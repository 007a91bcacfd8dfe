// `patchgrip tabulate`: friction force and moment of a scene's contact over all motions that it asks for, as CSV.
#pragma once

#include <string>
#include <string_view>

#include <patchgrip/cli/output_file.h>
#include <patchgrip/cli/scene/scene.h>

namespace patchgrip::cli {

// Writes the table row by row, in bounded memory; the caller commits. Throws SceneError where a wrench leaves the range
// of a double, Interrupted, and what OutputFile throws.
void tabulate(const Scene& scene, const std::string& scene_path, OutputFile& out);

}  // namespace patchgrip::cli
