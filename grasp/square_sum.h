// Solves M x = r for M = sum C C^T, 6 x 6, given the C.
//
// Scaled to a unit diagonal and by Cholesky; where that meets a small pivot, by the QR decomposition of all C^T on top of
// each other, which never forms M: it bears condition numbers of M up to 1e30 instead of 1e15.
//
// `emit(sink)` must call sink(C) with the columns C; it is called once or twice.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <limits>

#include <patchgrip/grasp/spatial.h>

namespace patchgrip::grasp {

class SquareSum {
 public:
  // Coordinates from `rank` on are left out: their solution is r itself. False if M is not finite.
  template <class Emit>
  bool factor(const Emit& emit, int rank) {
    Matrix6 M = Matrix6::Zero();
    emit([&](const auto& C) { M.noalias() += C.lazyProduct(C.transpose()); });
    for (int j = rank; j < 6; ++j) M(j, j) = 1;
    if (!M.allFinite()) return false;
    scale_ = M.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    const Eigen::LLT<Matrix6> cholesky(scale_.asDiagonal() * M * scale_.asDiagonal());
    L_ = cholesky.matrixL();
    if (cholesky.info() == Eigen::Success && L_.diagonal().minCoeff() > smallest_pivot) return true;
    Eigen::Matrix<double, 12, 6> stack = Eigen::Matrix<double, 12, 6>::Zero();
    for (int j = rank; j < 6; ++j) stack(j, j) = 1;
    emit([&]<class Columns>(const Columns& C) {
      constexpr int rows = Columns::ColsAtCompileTime;
      stack.bottomRows<6>().setZero();
      stack.template middleRows<rows>(6) = C.transpose() * scale_.asDiagonal();
      const Eigen::HouseholderQR<Eigen::Matrix<double, 12, 6>> qr(stack);
      stack.topRows<6>() = qr.matrixQR().topRows<6>().template triangularView<Eigen::Upper>();
    });
    L_ = stack.topRows<6>().transpose();
    const double largest = L_.diagonal().cwiseAbs().maxCoeff();
    for (int j = 0; j < 6; ++j) {
      if (std::fabs(L_(j, j)) < 1e-30 * largest) L_(j, j) = 1e-30 * largest;
    }
    return L_.allFinite();
  }

  Vector6 solve(const Vector6& r) const {
    Vector6 x = scale_.cwiseProduct(r);
    L_.triangularView<Eigen::Lower>().solveInPlace(x);
    L_.triangularView<Eigen::Lower>().transpose().solveInPlace(x);
    return scale_.cwiseProduct(x);
  }

 private:
  static constexpr double smallest_pivot = 1e-5;  // of L: 1e-10 of M

  Vector6 scale_ = Vector6::Ones();
  Matrix6 L_ = Matrix6::Identity();
};

}  // namespace patchgrip::grasp
