#include <patchgrip/cli/grasp/grasp_files.h>

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <patchgrip/cli/csv_number.h>
#include <patchgrip/version.h>

namespace patchgrip::cli {
namespace {

using grasp::Vector3;

void append(std::string& text, const Vector3& v) {
  for (const double x : v) {
    append_number(text, x);
    text += ' ';
  }
  text.back() = '\n';
}

}  // namespace

std::string to_vtk(const GraspAnswer& answer, const GraspScene& scene) {
  const std::vector<grasp::Contact> contacts = contacts_of(scene.contacts);
  const std::size_t n = contacts.size();
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\npatchgrip {} grasp\nASCII\nDATASET POLYDATA\nPOINTS {} double\n", version, n);
  for (const grasp::Contact& c : contacts) append(text, c.position());
  text += fmt::format("VERTICES {} {}\n", n, 2 * n);
  for (std::size_t i = 0; i < n; ++i) text += fmt::format("1 {}\n", i);
  text += fmt::format("POINT_DATA {}\nVECTORS normal double\n", n);
  for (const grasp::Contact& c : contacts) append(text, c.normal());
  if (answer.loads.empty()) return text;
  const GraspLoadAnswer& load = answer.loads.front();
  if (load.verdict == grasp::Verdict::holds) {
    text += "VECTORS force double\n";
    for (std::size_t i = 0; i < n; ++i) {
      const grasp::ContactAnswer& c = load.grip.contacts[i];
      append(text, contacts[i].wrench(c.normal_force, c.friction).head<3>());
    }
  }
  text += "VECTORS escape double\n";
  const grasp::Vector6 W = load.grip.escape_twist / pace_of(load, scene);
  const Vector3 v = W.head<3>(), omega = W.tail<3>();
  for (const grasp::Contact& c : contacts) append(text, v + omega.cross(c.position()));
  return text;
}

}  // namespace patchgrip::cli
