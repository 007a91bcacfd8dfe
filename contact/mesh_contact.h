// Hertz contact of bodies given as triangles: relative curvature from the fits, with the error that they carry.
//
// Both meshes lie in one frame, about to touch in the given point, or each in a frame of its own that is turned alike,
// with a point of its own: their outward normals there are opposite. With k = k_max along its direction as 1/R1 of each
// body (relative_radii.h), the sum of the two matrices of curvature is as uncertain as the two fits together, the turn
// of their principal directions included,
//
//     |1/R_small - true|, |1/R_large - true| <= e_p + e_m,     e: curvature_error of mesh_curvature.h
//
// and a, b, p_0, delta follow over the corners of that square; they are monotone in each of the two.
//
// Domain   normals opposite to within 0.2 rad; e_p + e_m below half of 1/R_large: else the meshes do not tell.
// Units    [m], F [N], E* [Pa], a_error ... as the results.
// Error    *_error: bounds as reliable as curvature_error; tests/contact/mesh_contact_test.cc. The angle between the
//          normals adds its square, relative.
// Throws   std::invalid_argument, naming the parameter, outside the domain or where a mesh or a radius is refused.
#pragma once

#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/contact/mesh_curvature.h>

namespace patchgrip::contact {

struct MeshContact {
  static MeshContact between(const TriangleMesh& p, const TriangleMesh& m, const Vector& contact_point);
  static MeshContact between(const MeshCurvature& first, const MeshCurvature& second);

  // A ball, a plane (infinite radius) or a hollow (negative) that touches the mesh in the point.
  static MeshContact with_ball(const TriangleMesh& p, double ball_radius, const Vector& contact_point);
  static MeshContact with_ball(const MeshCurvature& first, double ball_radius);

  struct Pressed {
    HertzEllipse ellipse;
    double a_error, b_error, peak_pressure_error, approach_error;  // bounds
  };
  Pressed under_force(double normal_force, double contact_modulus) const;

  MeshCurvature first;   // of p
  MeshCurvature second;  // of m
  double turn;           // from k_max of p to k_max of m, counter-clockwise about the normal of p [rad]
  RelativeRadii radii;
  double curvature_error;  // bound of the error of 1/R_small and 1/R_large [1/m]
  Vector direction_a;      // of the major semi-axis, unit, in the tangent plane of p
};

}  // namespace patchgrip::contact
