// Curvature of a body that is given as triangles, in the point closest to a given one, with its error.
//
// A polynomial of fourth degree is fitted by least squares to the vertices around the point, in the frame of its own
// normal (Cazals, Pouget, Computer Aided Geometric Design 22, 2005; CGAL Jet_fitting_3). The point itself is the foot
// on a first such fit, not on the flat triangle. Neighbourhoods of 40, 80, ... vertices grow from the nearest one on,
// until a border; of their fits the one with the smallest estimate is taken:
//
//     60 sqrt(sum residual^2 / (n - 15)) / r^2   [1/m],   r^2 = 4 times the mean square of the distance the narrow way
//
// (60: an x^6 that a fourth degree leaves behind counts with 36 of its greatest residual in the second derivative, with
// 50 of its mean one.) curvature_error is that, or twice the change to the next larger fit if that is more. The
// vertices are taken to lie on the smooth body, with the scatter that the residual shows, such as the single precision
// of a file.
//
// Domain   meshes of smooth bodies; the point within the longest side of the nearest triangle from it; 40 vertices
//          around the point without a border among them.
// Units    lengths as in the mesh [m], curvatures [1/m].
// Error    the matrix of curvature, in the tangent plane, differs from the true one by at most curvature_error
//          along any direction, and so do k_max and k_min: in every one of the points drawn on ellipsoids with axes
//          up to 1 : 1 : 5, of 642 to 10242 vertices, exact or with a scatter of 1e-7 to 1e-4 of their size; its
//          median is 8 times the error. Smooth and fine: 1e-4 to 1e-3 of the curvature with 10242 vertices;
//          tests/contact/mesh_curvature_test.cc.
// Fails    at an edge of the body: the estimate is as large as the curvature then.
// Throws   std::invalid_argument: near a border, or with too few vertices; std::runtime_error where the fit is
//          singular.
#pragma once

#include <patchgrip/contact/principal_curvatures.h>
#include <patchgrip/contact/triangle_mesh.h>

namespace patchgrip::contact {

struct MeshCurvature {
  PrincipalCurvatures curvatures;  // convex = positive; normal outwards
  double curvature_error;          // bound of the error of both [1/m]
  Vector point;                    // on the fitted surface [m]
  int vertices;                    // n of the fit
};

MeshCurvature curvature_near(const TriangleMesh& mesh, const Vector& point);

}  // namespace patchgrip::contact
