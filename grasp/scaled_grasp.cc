#include <patchgrip/grasp/scaled_grasp.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <patchgrip/grasp/square_sum.h>

namespace patchgrip::grasp {
namespace {

// Of all contacts about their centroid.
struct Extent {
  explicit Extent(const std::vector<Contact>& contacts) {
    const double share = 1 / static_cast<double>(contacts.size());
    for (const Contact& c : contacts) centroid += share * c.position();
    double square = 0;
    for (const Contact& c : contacts) {
      square += share * (c.position() - centroid).squaredNorm();
      patch = std::max(patch, c.cone().moment_length());
    }
    rms = std::sqrt(square);
  }

  Vector3 centroid = Vector3::Zero();
  double rms;
  double patch = 0;  // largest moment length
};

double power_of_two_near(double x) { return std::exp2(std::round(std::log2(x))); }

std::vector<Element::Kind> kinds_of(const FrictionCone& cone) {
  using Kind = Element::Kind;
  if (!cone.has_friction()) return {Kind::normal};
  switch (cone.model()) {
    case FrictionCone::Model::point:
      return {Kind::point};
    case FrictionCone::Model::soft_elliptic:
      return {Kind::ellipsoid};
    case FrictionCone::Model::soft_linear:
      return {Kind::point, Kind::spin};
    case FrictionCone::Model::patch:
      return {Kind::patch};
    default:
      return {Kind::normal};
  }
}

}  // namespace

void ScaledGrasp::set_scale(const std::vector<Contact>& contacts) {
  if (contacts.empty()) throw std::invalid_argument("contacts = 0 is not allowed: a grasp has at least one contact");
  const Extent extent(contacts);
  const double far = extent.centroid.norm();
  const double size = std::max(extent.rms, extent.patch);
  // Contacts that all lie at one point have no size of their own.
  const double own = size > 1e-9 * far ? size : far;
  length_ = own > 0 ? power_of_two_near(own) : 1;
  if (far > 4 * length_) centre_ = extent.centroid;
  rounding_ *= 1 + far / length_;
}

ScaledGrasp::ScaledGrasp(const std::vector<Contact>& contacts, const std::optional<Vector3>& centre)
    : contacts_(contacts.size()) {
  set_scale(contacts);
  if (centre) centre_ = *centre;
  parts_.reserve(2 * contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vector3 position = (contacts[i].position() - centre_) / length_;
    for (const Element::Kind kind : kinds_of(contacts[i].cone())) {
      parts_.push_back({Element(kind, contacts[i], position, length_), i});
    }
  }
  find_range();
}

ScaledGrasp::ScaledGrasp(const std::vector<Contact>& contacts, std::span<const std::vector<Vector3>> rays)
    : contacts_(contacts.size()) {
  set_scale(contacts);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Vector3 position = (contacts[i].position() - centre_) / length_;
    for (const Vector3& t : rays[i]) parts_.push_back({Element::ray(contacts[i], position, length_, t), i});
  }
  find_range();
}

// By a QR decomposition of all columns of G, friction moments in units of the moment length, that takes contact by
// contact, four at a time: squaring G would hide what is below 1e-8. R^-1 is as good as singular vectors unless the rank
// is in doubt.
void ScaledGrasp::find_range() {
  constexpr std::size_t together = 4;
  TriangleOfRows triangle;
  Eigen::Matrix<double, 6, 4 * together> columns;
  for (std::size_t i = 0; i < parts_.size(); i += together) {
    if (i + together > parts_.size()) columns.setZero();
    for (std::size_t k = 0; k < std::min(together, parts_.size() - i); ++k) {
      const Element& element = parts_[i + k].element;
      auto four = columns.middleCols<4>(static_cast<Eigen::Index>(4 * k));
      four = element.G();
      four.rightCols<3>() *= element.surrogate();
    }
    triangle.add(columns);
  }
  const Matrix6& R = triangle.R();
  const double count = std::sqrt(static_cast<double>(parts_.size()));
  if (R.diagonal().cwiseAbs().minCoeff() > 0) {
    P_ = R.triangularView<Eigen::Upper>().solve(count * Matrix6::Identity());
    if (P_.norm() * R.norm() < 1e4 * count) return;
  }
  const Eigen::JacobiSVD<Matrix6> svd(R, Eigen::ComputeFullV);
  const Vector6& values = svd.singularValues();
  rank_ = 0;
  P_.setZero();
  null_.setZero();
  for (int j = 0; j < 6; ++j) {
    const Vector6 direction = svd.matrixV().col(j);
    if (values[j] > rank_tolerance * values[0]) {
      P_.col(j) = direction * (count / values[j]);
      ++rank_;
    } else {
      null_ += direction * direction.transpose();
    }
  }
}

Vector6 ScaledGrasp::scaled_load(const Vector6& load) const noexcept {
  const Vector3 f = load.head<3>();
  return spatial(f, (load.tail<3>() - centre_.cross(f)) / length_);
}

Vector6 ScaledGrasp::twist(const Vector6& scaled) const noexcept {
  const Vector3 omega = scaled.tail<3>() / length_;
  return spatial(scaled.head<3>() - omega.cross(centre_), omega);
}

Vector6 ScaledGrasp::scaled_twist(const Vector6& twist) const noexcept {
  const Vector3 omega = twist.tail<3>();
  return spatial(twist.head<3>() + omega.cross(centre_), omega * length_);
}

}  // namespace patchgrip::grasp
