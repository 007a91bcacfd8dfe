#include <patchgrip/cli/limit/surface_files.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>

#include <patchgrip/cli/csv_number.h>
#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>

namespace patchgrip::cli {
namespace {

constexpr std::size_t longest_title = 255;  // of a legacy VTK file

void append_row(std::string& text, std::initializer_list<double> values) {
  InterruptGuard::check();
  for (const double value : values) {
    append_number(text, value);
    text += ' ';
  }
  text.back() = '\n';
}

// As for the motions of `tabulate`: the limit for a spin that falls to 0 from above.
double pole_coordinate(double velocity, double spin) {
  if (spin != 0) return velocity / spin;
  return velocity == 0 ? 0 : std::copysign(std::numeric_limits<double>::infinity(), velocity);
}

}  // namespace

std::string to_vtk(const LimitMesh& mesh, std::string_view title) {
  std::string text = "# vtk DataFile Version 3.0\n";
  text += std::string(title.substr(0, longest_title)) + "\nASCII\nDATASET POLYDATA\n";
  text += fmt::format("POINTS {} double\n", mesh.points.size());
  Progress progress("surface", 4 * mesh.points.size(), Progress::wanted(Progress::no_output));
  std::size_t done = 0;
  for (const LimitPoint& p : mesh.points) {
    progress.at(done++);
    append_row(text, {p.wrench.value.fx, p.wrench.value.fy, p.wrench.value.m / mesh.length});
  }
  const int caps = 2 * mesh.meridians;
  const int cells = mesh.parallels * mesh.meridians;
  text += fmt::format("POLYGONS {} {}\n", cells, 5 * cells - caps);
  for (int i = 0; i < mesh.parallels; ++i) {
    InterruptGuard::check();
    for (int j = 0; j < mesh.meridians; ++j) {
      const LimitMesh::Cell cell = mesh.cell(i, j);
      const bool triangle = cell[3] == cell[0];
      text += fmt::format("{} {} {} {}", triangle ? 3 : 4, cell[0], cell[1], cell[2]);
      text += triangle ? "\n" : fmt::format(" {}\n", cell[3]);
    }
  }
  text += fmt::format("POINT_DATA {}\nNORMALS normals double\n", mesh.points.size());
  for (const LimitPoint& p : mesh.points) {
    progress.at(done++);
    const double spin = mesh.length * p.slip.w;
    const double size = std::hypot(p.slip.vx, p.slip.vy, spin);
    append_row(text, {p.slip.vx / size, p.slip.vy / size, spin / size});
  }
  text += "VECTORS slip double\n";
  for (const LimitPoint& p : mesh.points) {
    progress.at(done++);
    append_row(text, {p.slip.vx, p.slip.vy, p.slip.w});
  }
  text += "SCALARS pole_share double 1\nLOOKUP_TABLE default\n";
  for (const LimitPoint& p : mesh.points) {
    progress.at(done++);
    append_row(text, {mesh.pole_share(p.slip)});
  }
  return text;
}

Table surface_rows(const LimitMesh& mesh, bool per_friction_force) {
  const std::string force = per_friction_force ? "" : "_N";
  const std::string moment = per_friction_force ? "_m" : "_Nm";
  Table table{{"force_x" + force, "force_y" + force, "moment" + moment, "force_error" + force, "moment_error" + moment,
               "pole_x_m", "pole_y_m", "vx_m_per_s", "vy_m_per_s", "w_rad_per_s"},
              {}};
  table.rows.reserve(mesh.points.size());
  for (const LimitPoint& p : mesh.points) {
    InterruptGuard::check();
    const auto& [value, force_error, moment_error] = p.wrench;
    const friction::Twist& v = p.slip;
    table.rows.push_back({value.fx, value.fy, value.m, force_error, moment_error, pole_coordinate(-v.vy, v.w),
                          pole_coordinate(v.vx, v.w), v.vx, v.vy, v.w});
  }
  return table;
}

}  // namespace patchgrip::cli
