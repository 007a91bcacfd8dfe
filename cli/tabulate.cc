#include <patchgrip/cli/tabulate.h>

#include <fmt/format.h>

#include <cmath>

#include <patchgrip/cli/friction_row.h>
#include <patchgrip/cli/friction_table.h>
#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>
#include <patchgrip/cli/scene/scene_error.h>

namespace patchgrip::cli {
namespace {

constexpr std::size_t block = 1U << 18U;  // bytes a write

bool is_finite(const friction::BoundedWrench& t) {
  return std::isfinite(t.value.fx) && std::isfinite(t.value.fy) && std::isfinite(t.value.m) &&
         std::isfinite(t.force_error) && std::isfinite(t.moment_error);
}

}  // namespace

void tabulate(const Scene& scene, const std::string& scene_path, OutputFile& out) {
  const std::size_t rows = scene.motions.size();
  Progress progress("tabulate", rows, Progress::wanted(out.descriptor()));
  std::string text = table_head(scene, scene_path);
  visit_patch(scene.contact.patch, scene.contact.frame, [&](const auto& patch) {
    for (std::size_t i = 0; i < rows; ++i) {
      InterruptGuard::check();
      const Motion motion = scene.motions[i];
      const friction::BoundedWrench wrench = scene.local ? local_friction_row(scene.contact, scene.law, patch, motion)
                                                         : friction_row(scene.contact, scene.law, patch, motion);
      if (!is_finite(wrench)) {
        throw SceneError(
            scene_path, 0,
            fmt::format("the wrench at the pole ({}, {}) m with the twist ({} m/s, {} m/s, {} rad/s) leaves the range "
                        "of a double",
                        motion.pole.x, motion.pole.y, motion.twist.vx, motion.twist.vy, motion.twist.w));
      }
      append_row(text, motion, wrench);
      if (text.size() >= block) {
        out.write(text);
        text.clear();
      }
      progress.at(i);
    }
  });
  out.write(text);
}

}  // namespace patchgrip::cli
