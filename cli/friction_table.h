// The text of a friction table: comment lines that say what it is, a header with units, one line a motion.
//
// Numbers have 17 significant digits: what is read back is the same double. A zero has no sign.
#pragma once

#include <string>
#include <string_view>

#include <patchgrip/cli/scene/motions.h>
#include <patchgrip/cli/scene/scene.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::cli {

// Comment lines and header; `scene_path` as the user gave it.
std::string table_head(const Scene& scene, std::string_view scene_path);

void append_row(std::string& table, const Motion& motion, const friction::BoundedWrench& wrench);

}  // namespace patchgrip::cli
