// Fits of a form, linear in its coefficients x, that is to be 1 at given points: row i . x = 1, a point each.
//
// Private to the library: its public headers know no Eigen.
#pragma once

#include <Eigen/Core>

namespace patchgrip::friction {

// Least squares; row i counts with weights[i] >= 0.
Eigen::VectorXd unit_fit(const Eigen::MatrixXd& rows, const Eigen::VectorXd& weights);

// Least largest |row . x - 1|: weights grow where it is large until only the largest count (Lawson 1961). Stops after
// `steps` fits and returns the best of them.
Eigen::VectorXd even_unit_fit(const Eigen::MatrixXd& rows, int steps);

}  // namespace patchgrip::friction
