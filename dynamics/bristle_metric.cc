#include <patchgrip/dynamics/bristle_metric.h>

#include <Eigen/Cholesky>
#include <stdexcept>

namespace patchgrip::dynamics {

BristleMetric::BristleMetric(const Matrix3& stiffness) : K_(stiffness) {
  constexpr double rounding = 0x1p-48;
  if (!K_.allFinite()) throw std::invalid_argument("stiffness is not allowed: must be finite");
  const double asymmetry = (K_ - K_.transpose()).cwiseAbs2().maxCoeff();
  const double size = rounding * rounding * K_.diagonal().cwiseAbs().maxCoeff() * K_.diagonal().cwiseAbs().maxCoeff();
  if (asymmetry > size) throw std::invalid_argument("stiffness is not allowed: must be symmetric");
  const Eigen::LLT<Matrix3> cholesky(K_);
  if (cholesky.info() != Eigen::Success)
    throw std::invalid_argument("stiffness is not allowed: must be positive definite");
  R_ = cholesky.matrixU();
  Rinv_ = R_.triangularView<Eigen::Upper>().solve(Matrix3::Identity());
}

BristleMetric BristleMetric::diagonal(double k_x, double k_y, double k_r) {
  return BristleMetric(Matrix3(Vector3(k_x, k_y, k_r).asDiagonal()));
}

}  // namespace patchgrip::dynamics
