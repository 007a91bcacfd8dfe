#include <patchgrip/contact/mesh_contact.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace patchgrip::contact {
namespace {

Eigen::Vector3d at(const Vector& v) { return {v[0], v[1], v[2]}; }

}  // namespace

MeshContact MeshContact::between(const TriangleMesh& p, const TriangleMesh& m, const Vector& contact_point) {
  return between(curvature_near(p, contact_point), curvature_near(m, contact_point));
}

MeshContact MeshContact::with_ball(const TriangleMesh& p, double ball_radius, const Vector& contact_point) {
  return with_ball(curvature_near(p, contact_point), ball_radius);
}

MeshContact MeshContact::with_ball(const MeshCurvature& first, double ball_radius) {
  const double k = 1 / require_radius("ball_radius", ball_radius);
  PrincipalCurvatures ball = first.curvatures;
  ball.k_max = ball.k_min = k;
  for (double& component : ball.normal) component = -component;
  return between(first, {ball, 0, first.point, 0});
}

MeshContact MeshContact::between(const MeshCurvature& first, const MeshCurvature& second) {
  const Eigen::Vector3d normal = at(first.curvatures.normal), opposite = at(second.curvatures.normal);
  require_in("angle_between_normals", std::atan2(normal.cross(opposite).norm(), -normal.dot(opposite)), 0, 0.2);

  // Counter-clockwise about the normal of p.
  const Eigen::Vector3d x = at(first.curvatures.direction_of_k_max), y = normal.cross(x);
  const Eigen::Vector3d other = at(second.curvatures.direction_of_k_max);
  const double turn = std::atan2(other.dot(y), other.dot(x));
  const auto radii = RelativeRadii::of_bodies(first.curvatures.radii(), second.curvatures.radii(), turn);
  const double error = first.curvature_error + second.curvature_error;
  require_in("relative_curvature_error", error * radii.large, 0, 0.5);
  const Eigen::Vector3d a = std::cos(radii.angle_a) * x + std::sin(radii.angle_a) * y;
  return {first, second, turn, radii, error, {a[0], a[1], a[2]}};
}

MeshContact::Pressed MeshContact::under_force(double normal_force, double contact_modulus) const {
  const auto ellipse = HertzEllipse::under_force(normal_force, radii, contact_modulus);
  Pressed pressed{ellipse, 0, 0, 0, 0};
  for (const double small_error : {-curvature_error, curvature_error}) {
    for (const double large_error : {-curvature_error, curvature_error}) {
      const double one = 1 / (1 / radii.small + small_error), other = 1 / (1 / radii.large + large_error);
      const auto corner = HertzEllipse::under_force(
          normal_force, RelativeRadii::of(std::min(one, other), std::max(one, other)), contact_modulus);
      pressed.a_error = std::max(pressed.a_error, std::fabs(corner.a - ellipse.a));
      pressed.b_error = std::max(pressed.b_error, std::fabs(corner.b - ellipse.b));
      pressed.peak_pressure_error =
          std::max(pressed.peak_pressure_error, std::fabs(corner.peak_pressure - ellipse.peak_pressure));
      pressed.approach_error = std::max(pressed.approach_error, std::fabs(corner.approach - ellipse.approach));
    }
  }
  return pressed;
}

}  // namespace patchgrip::contact
