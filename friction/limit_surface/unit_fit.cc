#include <patchgrip/friction/limit_surface/unit_fit.h>

#include <limits>

#include <Eigen/Cholesky>

namespace patchgrip::friction {

Eigen::VectorXd unit_fit(const Eigen::MatrixXd& rows, const Eigen::VectorXd& weights) {
  const Eigen::MatrixXd weighted = rows.transpose() * weights.asDiagonal();
  return (weighted * rows).ldlt().solve(weighted.rowwise().sum());
}

Eigen::VectorXd even_unit_fit(const Eigen::MatrixXd& rows, int steps) {
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(rows.rows(), 1 / static_cast<double>(rows.rows()));
  Eigen::VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < steps; ++k) {
    const Eigen::VectorXd x = unit_fit(rows, weights);
    const Eigen::VectorXd residual = ((rows * x).array() - 1).abs();
    if (residual.maxCoeff() < least) {
      least = residual.maxCoeff();
      best = x;
    }
    weights = weights.cwiseProduct(residual);
    weights /= weights.sum();
  }
  return best;
}

}  // namespace patchgrip::friction
