// Where a path of loads leads: the solutions of the last problems, continued in the length of the path.
//
//     x(t) = sum l_k(t) x_k,   t_k = sum |w_j - w_{j-1}|     (Lagrange, through the last 1 to 5)
//
// Of the loads themselves the same is known: as many of the last count as continue them best. On a smooth path in even
// steps each more takes off a power of the step; in uneven ones it ends with the third, as t are chords and not arcs.
// Across a corner the last alone is left.
//
// Only a guess: polish.h starts from it. Memory: allocated by the constructor.
#pragma once

#include <patchgrip/grasp/spatial.h>

namespace patchgrip::grasp {

class LoadPath {
 public:
  // Of solutions of so many numbers.
  explicit LoadPath(Eigen::Index size) : solutions_(size, most), guess_(size) {}

  void forget() noexcept { count_ = 0; }

  // Room for the solution of the next load.
  Eigen::Ref<Eigen::VectorXd> add(const Vector6& load) noexcept;

  // Where the path leads to from one load at least.
  const Eigen::VectorXd& lead(const Vector6& load) noexcept;

 private:
  static constexpr Eigen::Index most = 5;
  using Weights = Eigen::Matrix<double, most, 1>;

  // l_k of the last n, 0 of those before.
  Weights weights(Eigen::Index n, double length) const noexcept;
  Eigen::Index slot(Eigen::Index age) const noexcept { return (next_ + 2 * most - 1 - age) % most; }

  Eigen::MatrixXd solutions_;  // x_k
  Eigen::VectorXd guess_;
  Eigen::Matrix<double, 6, most> loads_ = Eigen::Matrix<double, 6, most>::Zero();
  Weights lengths_ = Weights::Zero();  // t_k
  Eigen::Index count_ = 0, next_ = 0;
};

}  // namespace patchgrip::grasp
