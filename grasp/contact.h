// One contact on a rigid object: where it is, how it is turned and what it can transmit.
//
// n is the outward normal of the object, (u, v, n) a right-handed frame. With the normal force F >= 0 and the friction
// t = (R_u, R_v, R_M) the object feels
//
//     force = -F n + R_u u + R_v v,    moment = r x force + R_M n,    v = n x u                  (seed 4.66)
//
// and slides against the contact with (u . w, v . w, n . omega), w = v_0 + omega x r, when it moves with (v_0, omega).
//
// Units    r [m]; n and u any length.
// Throws   std::invalid_argument unless all are finite and n and u span a plane.
#pragma once

#include <optional>

#include <patchgrip/grasp/friction_cone.h>
#include <patchgrip/grasp/spatial.h>

namespace patchgrip::grasp {

struct ContactFrame {
  Vector3 position;
  Vector3 normal;                  // outward
  std::optional<Vector3> tangent;  // u, made orthogonal to the normal; any if not given
};

struct ContactForce {
  double normal = 0;             // F [N]
  Vector3 friction = {0, 0, 0};  // R_u, R_v [N], R_M [N m]
};

class Contact {
 public:
  Contact(const ContactFrame& frame, FrictionCone cone);

  const Vector3& position() const noexcept { return frame_.position; }
  const Vector3& normal() const noexcept { return n_; }
  const Vector3& u() const noexcept { return u_; }
  const Vector3& v() const noexcept { return v_; }
  const FrictionCone& cone() const noexcept { return cone_; }

  // (u, v, n) as columns, of the frame that was given: normalised to the digits of long double.
  Eigen::Matrix<long double, 3, 3> extended_axes() const noexcept;

  // Wrench on the object.
  Vector6 wrench(double normal_force, const Vector3& friction) const noexcept;

  // How the object slides against the contact, (v_u, v_v, w), and how fast it leaves it, -n . w.
  friction::Twist sliding(const Vector6& twist) const noexcept;
  double opening(const Vector6& twist) const noexcept;

 private:
  ContactFrame frame_;
  Vector3 n_, u_, v_;
  FrictionCone cone_;
};

}  // namespace patchgrip::grasp
