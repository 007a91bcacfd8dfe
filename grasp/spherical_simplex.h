// Pieces of the unit sphere of R^n, n <= 6: what searches over directions halve.
//
// Corners are unit vectors, one a column. A piece is what positive combinations of its corners make, scaled to size 1;
// the 2^n orthants cover the sphere, and both halves of a piece cover it.
#pragma once

#include <Eigen/Core>
#include <utility>

namespace patchgrip::grasp {

using Direction = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;
using SimplexCorners = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;

// `which` in [0, 2^n): the j-th bit is the sign of the j-th axis.
inline SimplexCorners orthant(Eigen::Index n, int which) {
  SimplexCorners corners = SimplexCorners::Identity(n, n);
  for (Eigen::Index j = 0; j < n; ++j) corners(j, j) = (which >> j) % 2 == 0 ? 1 : -1;
  return corners;
}

inline Direction middle_of(const SimplexCorners& corners) { return corners.rowwise().sum().normalized(); }

// Where a piece is halved: the corners at the ends of its longest edge. n >= 2.
inline std::pair<Eigen::Index, Eigen::Index> longest_edge(const SimplexCorners& corners) {
  std::pair<Eigen::Index, Eigen::Index> edge{0, 1};
  double least = 2;
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    for (Eigen::Index j = i + 1; j < corners.cols(); ++j) {
      const double cosine = corners.col(i).dot(corners.col(j));
      if (cosine < least) {
        least = cosine;
        edge = {i, j};
      }
    }
  }
  return edge;
}

}  // namespace patchgrip::grasp
