#include <patchgrip/grasp/contact.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

Vector3 finite(const std::string& name, const Vector3& a) {
  for (int i = 0; i < 3; ++i) contact::require_finite(name + "_" + axes[i], a[i]);
  return a;
}

Vector3 direction(const std::string& name, const Vector3& a) {
  const double size = finite(name, a).stableNorm();
  contact::require_positive("length of " + name, size);
  const Vector3 scaled = a / size;
  return scaled / scaled.norm();
}

// The axis that is farthest from n.
Vector3 any_tangent(const Vector3& n) {
  Eigen::Index axis;
  n.cwiseAbs().minCoeff(&axis);
  return Vector3::Unit(axis);
}

Vector3 tangent(const ContactFrame& frame, const Vector3& n) {
  const Vector3 u = frame.tangent ? direction("tangent", *frame.tangent) : any_tangent(n);
  const Vector3 in_plane = u - n.dot(u) * n;
  contact::require_in("angle between tangent and normal [rad]", std::asin(std::fmin(1, in_plane.norm())), 1e-6, 2);
  // Once more: the first difference rounds relative to |u|.
  const Vector3 v = n.cross(in_plane).normalized();
  return v.cross(n).normalized();
}

}  // namespace

Contact::Contact(const ContactFrame& frame, FrictionCone cone)
    : r_(finite("position", frame.position)),
      n_(direction("normal", frame.normal)),
      u_(tangent(frame, n_)),
      v_(n_.cross(u_)),
      cone_(std::move(cone)) {}

Vector6 Contact::wrench(double normal_force, const Vector3& friction) const noexcept {
  const Vector3 force = friction[0] * u_ + friction[1] * v_ - normal_force * n_;
  return spatial(force, r_.cross(force) + friction[2] * n_);
}

friction::Twist Contact::sliding(const Vector6& twist) const noexcept {
  const Vector3 omega = twist.tail<3>();
  const Vector3 w = twist.head<3>() + omega.cross(r_);
  return {u_.dot(w), v_.dot(w), n_.dot(omega)};
}

double Contact::opening(const Vector6& twist) const noexcept {
  const Vector3 omega = twist.tail<3>();
  return -n_.dot(twist.head<3>() + omega.cross(r_));
}

}  // namespace patchgrip::grasp
