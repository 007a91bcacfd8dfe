#include <patchgrip/cli/limit/limit_mesh.h>

#include <numbers>

#include <patchgrip/cli/friction_row.h>
#include <patchgrip/cli/interrupt.h>
#include <patchgrip/cli/progress.h>
#include <patchgrip/cli/scene/direction.h>

namespace patchgrip::cli {

LimitMesh mesh_of(const Contact& contact, const contact::Estimate& resistance, double length, int meridians,
                  int parallels) {
  const friction::AnyPatch patch = any_patch(contact);
  const friction::Law coulomb = friction::Law::coulomb(1);
  const double R = resistance.value;
  LimitMesh mesh{{}, meridians, parallels, length, patch.moments()};
  Progress progress("limit surface", mesh.at(parallels, 0) + 1, Progress::wanted(Progress::no_output));
  const auto add = [&](double along, double across, double spin) {
    InterruptGuard::check();
    const double w = spin / length;
    // The velocity of the frame's origin; that of the centroid is (along, across).
    const friction::Twist v{along + w * mesh.moments.y, across - w * mesh.moments.x, w};
    const friction::BoundedWrench g = patch.bounded_gradient(v);
    const friction::Wrench t{R * g.value.fx, R * g.value.fy, R * g.value.m};
    const WrenchError owed = error_of_contact(contact, coulomb, R, patch, v, {-t.fx, -t.fy, -t.m});
    const double relative = 0x1p-53 + resistance.error / R;
    mesh.points.push_back({{t, R * g.force_error + relative * std::hypot(t.fx, t.fy) + owed.force,
                            R * g.moment_error + relative * std::fabs(t.m) + owed.moment},
                           v});
    progress.at(mesh.points.size());
  };
  add(0, 0, 1);
  for (int i = 1; i < parallels; ++i) {
    const double b = std::numbers::pi * (0.5 - static_cast<double>(i) / parallels);
    const double spin = 2 * i == parallels ? 0 : std::sin(b);
    for (int j = 0; j < meridians; ++j) {
      const Direction a = direction_at(2 * std::numbers::pi * j / meridians);
      add(std::cos(b) * a.x, std::cos(b) * a.y, spin);
    }
  }
  add(0, 0, -1);
  return mesh;
}

}  // namespace patchgrip::cli
