// Loads and twists of the held object: the conventions of the folder.
//
//     load     w = (f, m)      external wrench on the object, inertia included, moment about the origin
//     twist    W = (v, omega)  virtual motion of the object, v at the origin; a point r moves with v + omega x r
//     power    w . W
//
// All vectors are in one right-handed frame fixed to the object.
//
// Units    f [N], m [N m]; v [m/s], omega [rad/s].
#pragma once

#include <Eigen/Core>

namespace patchgrip::grasp {

using Vector3 = Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix3 = Eigen::Matrix3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix64 = Eigen::Matrix<double, 6, 4>;

inline Vector6 spatial(const Vector3& first, const Vector3& second) { return (Vector6() << first, second).finished(); }

}  // namespace patchgrip::grasp
