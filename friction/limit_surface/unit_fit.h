// Fits of a form, linear in its coefficients x, that is to be 1 at given points: row i . x = 1, a point each.
//
// Side conditions are matrices, affine in x, that are to be positive definite. An interior-point method: Newton's on
// the objective plus a logarithmic barrier for every condition, the objective's weight growing.
//
// Domain   rows of full column rank: points that no form of the kind vanishes on.
// Units    none: points of the frame of support_function.h, where forms and coefficients are of order 1.
// Error    even_unit_fit: 1e-5 of its objective. What a form is worth is judged afterwards (support_ratio.h).
// Throws   nothing.
//
// Private to the library: its public headers know no Eigen.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace patchgrip::friction {

// M(x) = sum of x_j factor[j] - constant, positive definite.
struct PositiveMatrix {
  std::vector<Eigen::Matrix3d> factor;
  Eigen::Matrix3d constant;
};

// Least squares, without side conditions.
Eigen::VectorXd unit_fit(const Eigen::MatrixXd& rows);

// From `start`, which meets the side conditions: the least mean square of row . x - 1,
Eigen::VectorXd unit_fit(const Eigen::MatrixXd& rows, const std::vector<PositiveMatrix>& conditions,
                         const Eigen::VectorXd& start);

// or its least largest size, to 1e-5.
Eigen::VectorXd even_unit_fit(const Eigen::MatrixXd& rows, const std::vector<PositiveMatrix>& conditions,
                              const Eigen::VectorXd& start);

}  // namespace patchgrip::friction
