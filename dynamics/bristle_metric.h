// The stiffness of bristles as a metric: K = R^T R, symmetric and positive definite.
//
// Units    K in (x, y, turn): [N/m], [N], [N m].
// Throws   std::invalid_argument unless K is finite, symmetric to rounding and positive definite.
#pragma once

#include <Eigen/Core>

namespace patchgrip::dynamics {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

class BristleMetric {
 public:
  explicit BristleMetric(const Matrix3& stiffness);

  static BristleMetric diagonal(double k_x, double k_y, double k_r);

  const Matrix3& stiffness() const noexcept { return K_; }
  const Matrix3& root() const noexcept { return R_; }             // upper triangular
  const Matrix3& inverse_root() const noexcept { return Rinv_; }  // of the same

 private:
  Matrix3 K_, R_, Rinv_;
};

}  // namespace patchgrip::dynamics
