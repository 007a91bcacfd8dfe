// Principal curvatures of a surface in a point: of a graph, of an ellipsoid, and of any shape operator.
//
// In an orthonormal basis of the tangent plane the surface is (h11 x^2 + 2 h12 x y + h22 y^2)/2 to second order, and
//
//     D = sqrt((h11 - h22)^2 + 4 h12^2),   k = (h11 + h22 +- D)/2,   k_max at (1/2) atan2(2 h12, h11 - h22)
//
// the smaller in size as det / larger. (seed 4.1.3 prints the radii only; do Carmo, 3-3 for the two shapes.)
//
// Graph z = f(x, y):  W = 1 + fx^2 + fy^2; along the gradient h11 = f_nn / W^(3/2), h12 = f_nt / W, h22 = f_tt /
//     sqrt(W),
//     det = (fxx fyy - fxy^2) / W^2. Positive: the surface bends towards +z (a body that lies above it is convex).
// Ellipsoid x^2/ax^2 + y^2/ay^2 + z^2/az^2 = 1, convex = positive:  h = Q / |Q x| on the tangent plane, with
//     Q = diag(1/a_i^2),
//     det = 1 / (ax ay az |Q x|^2)^2; the point is (ax cos v cos u, ay cos v sin u, az sin v).
//
// Units    lengths [m], curvatures [1/m], u, v [rad].
// Error    k_max, k_min <= 1.1 units of 2^-53, relative, of the graph; of the ellipsoid <= 1.1 units for the given u,
//          v; tests/contact/principal_curvatures_test.cc.
// Fails    the directions in an umbilic: any pair is principal there, one is given.
// Throws   std::invalid_argument, naming the parameter, for what is not finite, or an axis that is not positive.
#pragma once

#include <array>

#include <patchgrip/contact/relative_radii.h>

namespace patchgrip::contact {

using Vector = std::array<double, 3>;

struct PrincipalCurvatures {
  PrincipalRadii radii() const;  // {1 / k_max, 1 / k_min}, infinite where flat

  double k_max;               // [1/m]
  double k_min;               // [1/m], <= k_max
  Vector direction_of_k_max;  // unit vectors [1]; sign without meaning
  Vector direction_of_k_min;
  Vector normal;  // graph: towards +z; ellipsoid: outwards
};

PrincipalCurvatures curvatures_of_graph(double fx, double fy, double fxx, double fxy, double fyy);

struct Ellipsoid {
  static Ellipsoid of_axes(double ax, double ay, double az);

  Vector point(double u, double v) const;
  PrincipalCurvatures curvatures(double u, double v) const;

  double ax, ay, az;  // [m]
};

}  // namespace patchgrip::contact
