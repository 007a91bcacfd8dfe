#include <patchgrip/grasp/contact.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <utility>

#include <patchgrip/contact/require.h>

namespace patchgrip::grasp {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

template <class Real>
using Three = Eigen::Matrix<Real, 3, 1>;

void require_finite(const std::string& name, const Vector3& a) {
  for (int i = 0; i < 3; ++i) contact::require_finite(name + "_" + axes[i], a[i]);
}

void require_direction(const std::string& name, const Vector3& a) {
  require_finite(name, a);
  contact::require_positive("length of " + name, a.stableNorm());
}

template <class Real>
Three<Real> direction(const Vector3& a) {
  const Three<Real> scaled = a.cast<Real>() / Real(a.stableNorm());
  return scaled / scaled.norm();
}

// The part of the tangent that is across n; any that is, if none is given.
template <class Real>
Three<Real> in_plane(const ContactFrame& frame, const Three<Real>& n) {
  Eigen::Index farthest;
  n.cwiseAbs().minCoeff(&farthest);
  const Three<Real> u = frame.tangent ? direction<Real>(*frame.tangent) : Three<Real>(Three<Real>::Unit(farthest));
  return u - n.dot(u) * n;
}

template <class Real>
Three<Real> tangent(const ContactFrame& frame, const Three<Real>& n) {
  // Once more: the first difference rounds relative to |u|.
  const Three<Real> v = n.cross(in_plane(frame, n)).normalized();
  return v.cross(n).normalized();
}

ContactFrame checked(const ContactFrame& frame) {
  require_finite("position", frame.position);
  require_direction("normal", frame.normal);
  if (frame.tangent) require_direction("tangent", *frame.tangent);
  const double sine = in_plane(frame, direction<double>(frame.normal)).norm();
  contact::require_in("angle between tangent and normal [rad]", std::asin(std::fmin(1, sine)), 1e-6, 2);
  return frame;
}

}  // namespace

Contact::Contact(const ContactFrame& frame, FrictionCone cone)
    : frame_(checked(frame)),
      n_(direction<double>(frame.normal)),
      u_(tangent(frame, n_)),
      v_(n_.cross(u_)),
      cone_(std::move(cone)) {}

Eigen::Matrix<long double, 3, 3> Contact::extended_axes() const noexcept {
  const Three<long double> n = direction<long double>(frame_.normal), u = tangent(frame_, n);
  Eigen::Matrix<long double, 3, 3> uvn;
  uvn << u, n.cross(u), n;
  return uvn;
}

Vector6 Contact::wrench(double normal_force, const Vector3& friction) const noexcept {
  const Vector3 force = friction[0] * u_ + friction[1] * v_ - normal_force * n_;
  return spatial(force, frame_.position.cross(force) + friction[2] * n_);
}

friction::Twist Contact::sliding(const Vector6& twist) const noexcept {
  const Vector3 omega = twist.tail<3>();
  const Vector3 w = twist.head<3>() + omega.cross(frame_.position);
  return {u_.dot(w), v_.dot(w), n_.dot(omega)};
}

double Contact::opening(const Vector6& twist) const noexcept {
  const Vector3 omega = twist.tail<3>();
  return -n_.dot(twist.head<3>() + omega.cross(frame_.position));
}

}  // namespace patchgrip::grasp
