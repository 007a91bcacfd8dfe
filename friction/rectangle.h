// Friction of a uniform pressure on a rectangle l_xi by l_eta, centred, its sides along the axes.
//
//     p = F_N / (l_xi l_eta)
//
// Corner sums [[.]] (sign sx sy; x = sx l_xi/2 - xi_M, y = sy l_eta/2 - eta_M, d = sqrt(x^2 + y^2)), corrected from the
// seed's section 4.2.4:
//
//     I1  = -[[x d + y^2 asinh(x/|y|)]] / (2 l_xi l_eta),      I2 = [[y d + x^2 asinh(y/|x|)]] / (2 l_xi l_eta)
//     S   =  [[x y d / 3 + x^3 asinh(y/|x|) / 6 + y^3 asinh(x/|y|) / 6]] / (l_xi l_eta)
//     a_K I3 = S + xi_M I2 - eta_M I1
//
// Evaluated as the polygon that it is (polygon.h): the edge sums are these with one logarithm an edge.
// Example 4.8: l_xi = 2 L, l_eta = L, pole (0, L): I1 = 0.865204647..., a_K I3 = 0.290337795... L.
//
// Domain, error   as polygon.h.
// Units    l_xi, l_eta [m].
// Throws   std::invalid_argument unless both sides are positive and finite.
#pragma once

#include <patchgrip/friction/polygon.h>

namespace patchgrip::friction {

class Rectangle : public Polygon {
 public:
  static Rectangle of_sides(double l_xi, double l_eta);

  double l_xi() const noexcept { return l_xi_; }
  double l_eta() const noexcept { return l_eta_; }

 private:
  Rectangle(Polygon polygon, double l_xi, double l_eta) : Polygon(std::move(polygon)), l_xi_(l_xi), l_eta_(l_eta) {}

  double l_xi_, l_eta_;
};

}  // namespace patchgrip::friction
