#include <patchgrip/friction/limit_surface/unit_fit.h>

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace patchgrip::friction {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();

// What is asked of a function: in a line search, its value alone.
enum class Of { value, derivatives };

// A convex function with its derivatives; value infinite where it is not defined.
struct Expansion {
  double value;
  VectorXd gradient;
  MatrixXd hessian;
};

// Adds -sum of log det M(x).
void add_barrier(Expansion& f, const std::vector<PositiveMatrix>& conditions, const VectorXd& x, Of of) {
  const Eigen::Index n = x.size();
  MatrixXd stack(of == Of::value ? 0 : 6 * static_cast<Eigen::Index>(conditions.size()), n);
  Eigen::Index top = 0;
  for (const PositiveMatrix& m : conditions) {
    Eigen::Matrix3d M = -m.constant;
    for (Eigen::Index j = 0; j < n; ++j) M += x[j] * m.factor[static_cast<std::size_t>(j)];
    const Eigen::LLT<Eigen::Matrix3d> root(M);
    if (root.info() != Eigen::Success) {
      f.value = infinity;
      return;
    }
    f.value -= 2 * std::log(root.matrixLLT().diagonal().prod());
    if (of == Of::value) continue;
    const Eigen::Matrix3d inverse = root.matrixL().solve(Eigen::Matrix3d::Identity());
    for (Eigen::Index j = 0; j < n; ++j) {
      const Eigen::Matrix3d W = inverse * m.factor[static_cast<std::size_t>(j)] * inverse.transpose();
      f.gradient[j] -= W.trace();
      constexpr double twice = 1.4142135623730951;  // an entry off the diagonal counts twice in tr(W W)
      stack.block<6, 1>(top, j) << W(0, 0), W(1, 1), W(2, 2), twice * W(0, 1), twice * W(0, 2), twice * W(1, 2);
    }
    top += 6;
  }
  if (of == Of::derivatives) f.hessian.topLeftCorner(n, n) += stack.transpose() * stack;
}

// Newton's method from a point where the function is finite.
template <class Function>
void minimise(const Function& f, VectorXd& x) {
  // The function is self-concordant, d = sqrt(-slope) its Newton decrement. A full step from d leaves (d / (1 - d))^2
  // at most: 1e-6 from 1e-3, and the value 1e-12 above the least. Halved, a step is never shorter than 1 / (2 + 2 d)
  // (Boyd and Vandenberghe, Convex Optimization, 9.6.4): with d < 2^32 only rounding takes it to 2^-33, where it is
  // still in the domain, which holds all steps up to 1 / d.
  constexpr double quadratic = 1e-6;
  constexpr double shortest = 0x1p-33;
  for (int k = 0; k < 50; ++k) {
    const Expansion at = f(x, Of::derivatives);
    const VectorXd step = -at.hessian.ldlt().solve(at.gradient);
    const double slope = at.gradient.dot(step);
    if (!(slope < -quadratic)) {
      if (slope < 0) x += step;
      return;
    }
    double length = 1;
    while (length > shortest && !(f(x + length * step, Of::value).value <= at.value + 0.1 * length * slope))
      length /= 2;
    x += length * step;
  }
}

}  // namespace

VectorXd unit_fit(const MatrixXd& rows) {
  return (rows.transpose() * rows).ldlt().solve(rows.colwise().sum().transpose());
}

VectorXd unit_fit(const MatrixXd& rows, const std::vector<PositiveMatrix>& conditions, const VectorXd& start) {
  const double count = static_cast<double>(rows.rows());
  const MatrixXd normal = rows.transpose() * rows / count;
  VectorXd x = start;
  for (double weight = 1e2; weight < 1e10; weight *= 10) {
    minimise(
        [&](const VectorXd& at, Of of) {
          const VectorXd residual = (rows * at).array() - 1;
          Expansion f{weight * residual.squaredNorm() / count, 2 * weight / count * (rows.transpose() * residual),
                      2 * weight * normal};
          add_barrier(f, conditions, at, of);
          return f;
        },
        x);
  }
  return x;
}

// Unknowns are x and the bound e of |row . x - 1|.
VectorXd even_unit_fit(const MatrixXd& rows, const std::vector<PositiveMatrix>& conditions, const VectorXd& start) {
  const Eigen::Index n = rows.cols();
  VectorXd y(n + 1);
  y << start, 1.1 * ((rows * start).array() - 1).abs().maxCoeff() + 1e-3;
  const double gap = 2 * static_cast<double>(rows.rows()) + 3 * static_cast<double>(conditions.size());
  for (double weight = gap; weight < 4e5 * gap; weight *= 8) {  // e exceeds the least by <= gap / weight
    minimise(
        [&](const VectorXd& at, Of of) {
          const VectorXd residual = (rows * at.head(n)).array() - 1;
          const Eigen::ArrayXd above = at[n] - residual.array(), below = at[n] + residual.array();
          Expansion f{weight * at[n], VectorXd::Zero(n + 1), MatrixXd::Zero(n + 1, n + 1)};
          if (above.minCoeff() <= 0 || below.minCoeff() <= 0) {
            f.value = infinity;
            return f;
          }
          f.value -= above.log().sum() + below.log().sum();
          if (of == Of::value) {
            add_barrier(f, conditions, at.head(n), of);
            return f;
          }
          const Eigen::ArrayXd p = 1 / above, q = 1 / below;
          f.gradient.head(n) = rows.transpose() * (p - q).matrix();
          f.gradient[n] = weight - (p + q).sum();
          const VectorXd curvature = (p * p + q * q).matrix();
          f.hessian.topLeftCorner(n, n) = rows.transpose() * curvature.asDiagonal() * rows;
          f.hessian.topRightCorner(n, 1) = rows.transpose() * (q * q - p * p).matrix();
          f.hessian.bottomLeftCorner(1, n) = f.hessian.topRightCorner(n, 1).transpose();
          f.hessian(n, n) = curvature.sum();
          add_barrier(f, conditions, at.head(n), of);
          return f;
        },
        y);
  }
  return y.head(n);
}

}  // namespace patchgrip::friction
