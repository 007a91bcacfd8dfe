#include <patchgrip/friction/rectangle.h>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

Rectangle Rectangle::of_sides(double l_xi, double l_eta) {
  const double x = contact::require_positive("l_xi", l_xi) / 2;
  const double y = contact::require_positive("l_eta", l_eta) / 2;
  return {Polygon::uniform({{-x, -y}, {x, -y}, {x, y}, {-x, y}}), l_xi, l_eta};
}

}  // namespace patchgrip::friction
