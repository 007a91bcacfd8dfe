#include <patchgrip/grasp/element.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include <patchgrip/friction/limit_surface/support_function.h>

namespace patchgrip::grasp {
namespace {

constexpr double unit = 0x1p-53;

}  // namespace

Element::Element(Kind kind, const Contact& contact, const Vector3& position, double length)
    : kind_(kind),
      contact_(&contact),
      mu_(kind == Kind::normal ? 0 : contact.cone().mu()),
      e_(contact.cone().moment_length() / length),
      inverse_length_(1 / length) {
  if (kind == Kind::patch) surface_ = &contact.cone().surface();
  metric_ = {kind == Kind::spin ? 0. : 1., kind == Kind::spin ? 0. : 1., kind == Kind::point ? 0. : e_};
  const auto column = [&](const Vector3& a) {
    const auto r = position.cast<long double>();
    return spatial(a, r.cross(a.cast<long double>()).cast<double>());
  };
  G_.col(0) = column(-contact.normal());
  G_.col(1) = column(contact.u());
  G_.col(2) = column(contact.v());
  G_.col(3) = spatial(Vector3::Zero(), contact.normal());
}

Element Element::ray(const Contact& contact, const Vector3& position, double length, const Vector3& t) {
  Element element(Kind::normal, contact, position, length);
  element.G_.col(0) += element.T() * Vector3(t[0], t[1], t[2] / length);
  return element;
}

Eigen::Index Element::size() const noexcept {
  switch (kind_) {
    case Kind::normal:
      return 0;
    case Kind::spin:
      return 1;
    case Kind::point:
      return 2;
    default:
      return 3;
  }
}

BoundedValue Element::dissipation(const Vector3& v) const noexcept {
  if (kind_ == Kind::normal) return {};
  if (kind_ == Kind::patch) {
    const friction::Twist u = twist(v);
    const friction::BoundedWrench g = surface_->patch().bounded_gradient(u);
    const double speed = std::hypot(u.vx, u.vy);
    const double size = speed * std::hypot(g.value.fx, g.value.fy) + std::fabs(u.w * g.value.m);
    return {friction::power(g.value, u), g.force_error * speed + g.moment_error * std::fabs(u.w) + 4 * unit * size};
  }
  const double D = metric_.cwiseProduct(v).norm();
  return {D, 4 * unit * D};
}

Vector3 Element::gradient(const Vector3& v) const noexcept {
  if (kind_ == Kind::normal) return Vector3::Zero();
  if (kind_ == Kind::patch) return scaled(surface_->patch().gradient(twist(v)));
  const Vector3 s = metric_.cwiseProduct(v);
  const double D = s.norm();
  if (D == 0) return Vector3::Zero();
  return metric_.cwiseProduct(s) / D;
}

bool Element::derivatives(const Vector3& v, Derivatives& d) const noexcept {
  d.gradient = gradient(v);
  d.value = d.gradient.dot(v);
  d.hessian.setZero();
  if (kind_ == Kind::normal) return true;
  if (!(d.value > 0)) return false;
  if (kind_ == Kind::patch) {
    friction::Hessian h;
    if (!friction::view(surface_->patch()).hessian(&surface_->patch(), twist(v), h)) return false;
    const double k = inverse_length_;
    d.hessian << h.xx, h.xy, k * h.xw, h.xy, h.yy, k * h.yw, k * h.xw, k * h.yw, k * k * h.ww;
    return true;
  }
  if (kind_ == Kind::spin) return true;
  d.hessian.noalias() = d.gradient * (d.gradient / -d.value).transpose();
  d.hessian.diagonal() += metric_.cwiseAbs2() / d.value;
  return true;
}

// In extended precision: what is left is the rounding of G itself, and of v on its way into D.
BoundedValue Element::resistance(const Vector6& W, double rounding) const noexcept {
  long double dots[4];
  double sizes[4];
  const Eigen::Index columns = kind_ == Kind::normal ? 1 : 4;
  for (Eigen::Index j = 0; j < columns; ++j) {
    long double dot = 0, size = 0;
    for (Eigen::Index i = 0; i < 6; ++i) {
      const long double term = static_cast<long double>(G_(i, j)) * W[i];
      dot += term;
      size += std::fabs(term);
    }
    dots[j] = dot;
    sizes[j] = static_cast<double>(size);
  }
  const double normal = -static_cast<double>(dots[0]);
  const double lost = 1.5 * rounding;
  if (kind_ == Kind::normal) return {normal, lost * sizes[0]};
  const BoundedValue D =
      dissipation({static_cast<double>(dots[1]), static_cast<double>(dots[2]), static_cast<double>(dots[3])});
  // |grad D| <= 1 in force and <= e in moment, up to the scaled length of the patch.
  const double moved = kind_ == Kind::spin ? e_ * sizes[3] : std::hypot(sizes[1], sizes[2]) + e_ * sizes[3];
  return {normal + mu_ * D.value, lost * (sizes[0] + mu_ * moved) + mu_ * D.error};
}

double Element::gauge(const Vector3& t) const noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double force = std::hypot(t[0], t[1]);
  const auto over = [&](double moment) { return moment == 0 ? 0 : e_ > 0 ? moment / e_ : infinity; };
  switch (kind_) {
    case Kind::normal:
      return t.isZero() ? 0 : infinity;
    case Kind::point:
      return t[2] == 0 ? (1 + 4 * unit) * force : infinity;
    case Kind::spin:
      return force == 0 ? (1 + 4 * unit) * over(std::fabs(t[2])) : infinity;
    case Kind::ellipsoid:
      return (1 + 8 * unit) * std::hypot(force, over(t[2]));
    default:
      return surface_->gauge({t[0], t[1], t[2] / inverse_length_}).upper;
  }
}

Vector3 Element::slip(const Vector3& t) const noexcept {
  if (kind_ != Kind::patch) return {t[0], t[1], e_ > 0 ? t[2] / (e_ * e_) : 0};
  const friction::Twist v = surface_->gauge({t[0], t[1], t[2] / inverse_length_}).twist;
  return {v.vx, v.vy, v.w / inverse_length_};
}

Matrix3 Element::surrogate() const noexcept {
  switch (kind_) {
    case Kind::normal:
      return Matrix3::Zero();
    case Kind::point:
      return Vector3(1, 1, 0).asDiagonal();
    case Kind::spin:
      return Vector3(0, 0, e_).asDiagonal();
    case Kind::ellipsoid:
      return Vector3(1, 1, e_).asDiagonal();
    default: {
      // About the centre of pressure.
      const friction::CentredFrame frame = friction::CentredFrame::of(surface_->patch());
      const double k = inverse_length_;
      Matrix3 L = Matrix3::Identity();
      L.row(2) << -k * frame.y, k * frame.x, k * frame.length;
      return L;
    }
  }
}

bool Element::osculating(const Vector3& v, Matrix3& L) const noexcept {
  Derivatives d;
  if (kind_ != Kind::patch || !derivatives(v, d)) return false;
  const Matrix3 Q = d.gradient * d.gradient.transpose() + d.value * d.hessian;
  const Eigen::LLT<Matrix3> factor(Q);
  if (factor.info() != Eigen::Success) return false;
  L = factor.matrixL();
  return L.allFinite();
}

}  // namespace patchgrip::grasp
