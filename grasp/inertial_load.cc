#include <patchgrip/grasp/inertial_load.h>

#include <Eigen/Geometry>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

template <class Matrix>
void require_all_finite(const char* name, const Matrix& a) {
  for (const double x : a.reshaped()) contact::require_finite(name, x);
}

}  // namespace

Vector6 inertial_load(const CarriedBody& body, const Vector3& gravity, const FrameMotion& motion) {
  const double mass = contact::require_non_negative("mass", body.mass);
  require_all_finite("centre_of_mass", body.centre_of_mass);
  require_all_finite("inertia", body.inertia);
  require_all_finite("gravity", gravity);
  for (const Vector3& a : {motion.v, motion.omega, motion.v_rate, motion.omega_rate}) require_all_finite("motion", a);
  const auto& [v, omega, v_rate, omega_rate] = motion;
  const Vector3& r = body.centre_of_mass;
  const Vector3 origin = v_rate + omega.cross(v);  // acceleration of the origin
  const Vector3 centre = origin + omega_rate.cross(r) + omega.cross(omega.cross(r));
  const Vector3 spin = body.inertia * omega_rate + omega.cross(Vector3(body.inertia * omega));
  return spatial(mass * (gravity - centre), mass * r.cross(gravity - origin) - spin);
}

}  // namespace patchgrip::grasp
