// Solves M x = r for M = sum C C^T, 6 x 6, given the C.
//
// By L D L^T; where that meets a pivot that is small against its diagonal, by the QR decomposition of all C^T on top of
// each other, scaled to unit columns, which never forms M: it bears condition numbers of M up to 1e30 instead of 1e15.
//
// `emit(sink)` must call sink(C) with the columns C, as often as it is called.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include <patchgrip/grasp/spatial.h>

namespace patchgrip::grasp {

// Upper triangular R with R^T R = sum C C^T: Householder's reflections, of only the rows that are not yet zero.
class TriangleOfRows {
 public:
  template <class Columns>
  void add(const Columns& C) {
    constexpr int rows = Columns::ColsAtCompileTime;
    Eigen::Matrix<double, rows, 6> below = C.transpose();
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
      const double size = std::sqrt(R_(j, j) * R_(j, j) + below.col(j).squaredNorm());
      if (size == 0) continue;
      const double diagonal = R_(j, j) > 0 ? -size : size;
      const double first = R_(j, j) - diagonal;
      // I - u u^T / (-diagonal first), u = (first, below.col(j))
      const Eigen::Matrix<double, rows, 1> u = below.col(j) / first;
      const double pace = -first / diagonal;
#pragma GCC unroll 6
      for (int k = j + 1; k < 6; ++k) {
        const double dot = pace * (R_(j, k) + u.dot(below.col(k)));
        R_(j, k) -= dot;
        below.col(k) -= dot * u;
      }
      R_(j, j) = diagonal;
    }
  }

  const Matrix6& R() const noexcept { return R_; }

 private:
  Matrix6 R_ = Matrix6::Zero();
};

class SquareSum {
 public:
  // Coordinates from `rank` on are left out: their solution is r itself. False if M is not finite.
  template <class Emit>
  bool factor(const Emit& emit, int rank) {
    Matrix6 M = Matrix6::Zero();
    emit([&](const auto& C) { add_square(M, C); });
    return factor(M, emit, rank);
  }

  // The lower triangle of M is known.
  template <class Emit>
  bool factor(Matrix6 M, const Emit& emit, int rank) {
    for (int j = rank; j < 6; ++j) M(j, j) = 1;
    if (!M.allFinite()) return false;
    if (factor_regular(M)) return true;
    const Vector6 scale = M.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    TriangleOfRows triangle;
    Matrix6 left_out = Matrix6::Zero();
    for (int j = rank; j < 6; ++j) left_out(j, j) = 1;
    triangle.add(left_out);
    emit([&](const auto& C) { triangle.add((scale.asDiagonal() * C).eval()); });
    Vector6 d = triangle.R().diagonal();
    const double largest = d.cwiseAbs().maxCoeff();
    for (int j = 0; j < 6; ++j) {
      if (std::fabs(d[j]) < 1e-30 * largest) d[j] = 1e-30 * largest;
    }
    // M = S^-1 R^T R S^-1
    L_ = scale.cwiseInverse().asDiagonal() * triangle.R().transpose();
    for (int j = 0; j < 6; ++j) {
      L_.col(j) *= scale[j] / d[j];
      inverse_[j] = scale[j] / d[j] * (scale[j] / d[j]);
    }
    return L_.allFinite();
  }

  Vector6 solve(const Vector6& r) const {
    Vector6 x = r;
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
#pragma GCC unroll 6
      for (int i = j + 1; i < 6; ++i) x[i] -= L_(i, j) * x[j];
    }
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) x[j] *= inverse_[j];
#pragma GCC unroll 6
    for (int j = 5; j >= 0; --j) {
#pragma GCC unroll 6
      for (int i = j + 1; i < 6; ++i) x[j] -= L_(i, j) * x[i];
    }
    return x;
  }

 private:
  static constexpr double smallest_pivot = 1e-10;  // of M scaled to a unit diagonal

  // The lower triangle.
  template <class Columns>
  static void add_square(Matrix6& M, const Columns& C) {
    for (int k = 0; k < Columns::ColsAtCompileTime; ++k) {
      for (int j = 0; j < 6; ++j) {
        for (int i = j; i < 6; ++i) M(i, j) += C(i, k) * C(j, k);
      }
    }
  }

  // Of the lower triangle; false at a small pivot.
  bool factor_regular(Matrix6 M) {
    const Vector6 diagonal = M.diagonal();
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j) {
      if (!(M(j, j) > smallest_pivot * diagonal[j])) return false;
      inverse_[j] = 1 / M(j, j);
#pragma GCC unroll 6
      for (int i = j + 1; i < 6; ++i) L_(i, j) = M(i, j) * inverse_[j];
#pragma GCC unroll 6
      for (int k = j + 1; k < 6; ++k) {
#pragma GCC unroll 6
        for (int i = k; i < 6; ++i) M(i, k) -= L_(i, j) * M(k, j);
      }
    }
    return true;
  }

  Matrix6 L_ = Matrix6::Identity();    // unit lower triangle
  Vector6 inverse_ = Vector6::Ones();  // of D
};

}  // namespace patchgrip::grasp
