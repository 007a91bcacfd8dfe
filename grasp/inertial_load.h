// The load on an object that is carried along: gravity and inertia in the object's own moving frame.
//
//     f = m g - m [v' + omega x v + omega' x r_S + omega x (omega x r_S)]
//     m = r_S x m g - [J omega' + omega x J omega + m r_S x (v' + omega x v)]
//
// (seed 4.65 with the gyroscopic and centripetal terms of its 5121, that 4.65 leaves out: at omega = 10 rad/s a kilogram
// 0.1 m off the axis pulls with 10 N.) v, v' are velocity of the origin and its rate of change as seen in the frame.
//
// Units    m [kg], r_S [m], J [kg m^2] about the origin (not about the centre of mass), g [m/s^2].
// Error    rounding of the sums: a few units of 2^-53 of the largest term; tests/grasp/grasp_table_test.cc.
// Throws   std::invalid_argument unless the mass is not negative and all is finite.
#pragma once

#include <patchgrip/grasp/spatial.h>

namespace patchgrip::grasp {

struct CarriedBody {
  double mass;
  Vector3 centre_of_mass;  // r_S
  Matrix3 inertia;         // J about the origin, symmetric
};

struct FrameMotion {
  Vector3 v = Vector3::Zero();
  Vector3 omega = Vector3::Zero();
  Vector3 v_rate = Vector3::Zero();
  Vector3 omega_rate = Vector3::Zero();
};

Vector6 inertial_load(const CarriedBody& body, const Vector3& gravity, const FrameMotion& motion);

}  // namespace patchgrip::grasp
