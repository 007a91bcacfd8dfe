#include <patchgrip/cli/friction_table.h>

#include <fmt/format.h>

#include <array>

#include <patchgrip/cli/csv_number.h>
#include <patchgrip/cli/scene/friction_reader.h>
#include <patchgrip/cli/scene/scene_error.h>
#include <patchgrip/version.h>

namespace patchgrip::cli {
namespace {

constexpr std::string_view columns =
    "pole_x_m,pole_y_m,spin,force_x_N,force_y_N,moment_Nm,force_error_N,moment_error_Nm,"
    "vx_m_per_s,vy_m_per_s,w_rad_per_s\n";

constexpr std::string_view meaning =
    "# Friction on body A, which moves against body B with the twist (vx, vy, w) at the origin of the contact frame;\n"
    "# the moment is about that origin. spin is the sign of w; a translation has spin 0 and its pole at infinity.\n"
    "# The exact force is within force_error_N (length of the difference) of the printed one, the exact moment within\n"
    "# moment_error_Nm: exact for the numbers of the scene as doubles, pole and w as printed (translation: vx and "
    "vy).\n";

}  // namespace

std::string table_head(const Scene& scene, std::string_view scene_path) {
  constexpr auto whole = std::string_view::npos;
  std::string head = fmt::format("# patchgrip {} tabulate: friction against the instantaneous pole\n# scene: {}\n",
                                 version, printable(scene_path, whole));
  if (!scene.title.empty()) head += fmt::format("# title: {}\n", scene.title);
  for (const std::string& note : scene.contact.notes) head += fmt::format("# contact: {}\n", note);
  for (const std::string& warning : scene.contact.warnings) head += fmt::format("# warning: {}\n", warning);
  head += fmt::format("# friction: {}\n", in_words(scene.law, scene.local));
  head += meaning;
  head += columns;
  return head;
}

void append_row(std::string& table, const Motion& motion, const friction::BoundedWrench& wrench) {
  const std::array<double, 11> values{motion.pole.x,      motion.pole.y,       static_cast<double>(motion.spin),
                                      wrench.value.fx,    wrench.value.fy,     wrench.value.m,
                                      wrench.force_error, wrench.moment_error, motion.twist.vx,
                                      motion.twist.vy,    motion.twist.w};
  for (const double value : values) {
    append_number(table, value);
    table += ',';
  }
  table.back() = '\n';
}

}  // namespace patchgrip::cli
