// One smooth friction cone of a contact, in lengths divided by the size of the grasp.
//
// A contact is one element, but for the soft linear finger: that is a point and a spin contact that share their normal
// force. Of each the resistance against the twist W, and its derivatives, follow from D alone:
//
//     rho(W) = n . w + mu D(T^T W),    wrench = F (N - mu T grad D(T^T W)),    G = [N T] = [-n u v 0; -r x n r x u r x v n]
//
// Components that an element does not resist (w at a point, v_u and v_v at a spin contact) are ignored.
//
// Units    lengths and moments over the length L of the grasp (scaled_grasp.h); w times L.
#pragma once

#include <patchgrip/grasp/contact.h>
#include <patchgrip/grasp/spatial.h>

namespace patchgrip::grasp {

struct Derivatives {
  double value = 0;  // D
  Vector3 gradient = Vector3::Zero();
  Matrix3 hessian = Matrix3::Zero();
};

struct BoundedValue {
  double value = 0;
  double error = 0;
};

class Element {
 public:
  enum class Kind { normal, point, spin, ellipsoid, patch };

  // `kind` is one that the contact's cone consists of. `position` and `length` are those of scaled_grasp.h; the contact
  // must outlive the element.
  Element(Kind kind, const Contact& contact, const Vector3& position, double length);

  // The ray F (1, t) of a cone, t = (R_u, R_v, R_M) per normal force: an element of kind `normal` with its own N.
  static Element ray(const Contact& contact, const Vector3& position, double length, const Vector3& t);

  Kind kind() const noexcept { return kind_; }
  const Contact& contact() const noexcept { return *contact_; }
  double mu() const noexcept { return mu_; }
  double moment_length() const noexcept { return e_; }
  const Matrix64& G() const noexcept { return G_; }
  auto N() const noexcept { return G_.col(0); }
  auto T() const noexcept { return G_.rightCols<3>(); }

  // The friction components that it bears: `size` of them from `first` on.
  Eigen::Index first() const noexcept { return kind_ == Kind::spin ? 2 : 0; }
  Eigen::Index size() const noexcept;

  Vector3 sliding(const Vector6& W) const noexcept { return T().transpose() * W; }

  BoundedValue dissipation(const Vector3& v) const noexcept;
  Vector3 gradient(const Vector3& v) const noexcept;
  // False where the Hessian is infinite, or v = 0.
  bool derivatives(const Vector3& v, Derivatives& d) const noexcept;

  // rho(W); the error counts the rounding of all of it.
  BoundedValue resistance(const Vector6& W, double rounding) const noexcept;

  // Smallest mu F that bears t (never too small), and the slip that t would start.
  double gauge(const Vector3& t) const noexcept;
  Vector3 slip(const Vector3& t) const noexcept;

  // L of an ellipsoid {t = L s, |s| <= 1} near the limit surface, and of the one that has value, gradient and Hessian of
  // D at v (it is Q = Hess D^2 / 2 = L L^T); false where that is none.
  Matrix3 surrogate() const noexcept;
  bool osculating(const Vector3& v, Matrix3& L) const noexcept;

 private:
  friction::Twist twist(const Vector3& v) const noexcept { return {v[0], v[1], v[2] * inverse_length_}; }
  Vector3 scaled(const friction::Wrench& t) const noexcept { return {t.fx, t.fy, t.m * inverse_length_}; }

  Kind kind_;
  const Contact* contact_;
  double mu_;
  double e_;               // moment length / L
  double inverse_length_;  // 1 / L
  Vector3 metric_;         // of a point, spin or ellipsoid: D = |metric v|
  const friction::LimitSurface<friction::AnyPatch>* surface_ = nullptr;
  Matrix64 G_;
};

}  // namespace patchgrip::grasp
