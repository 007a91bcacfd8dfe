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
  const grasp::GripAnswer& grip = answer.loads.front().grip;
  text += "VECTORS force double\n";
  for (std::size_t i = 0; i < n; ++i) {
    append(text, contacts[i].wrench(grip.contacts[i].normal_force, grip.contacts[i].friction).head<3>());
  }
  text += "VECTORS escape double\n";
  const Vector3 v = grip.escape_twist.head<3>(), omega = grip.escape_twist.tail<3>();
  for (const grasp::Contact& c : contacts) append(text, v + omega.cross(c.position()));
  return text;
}

}  // namespace patchgrip::cli
