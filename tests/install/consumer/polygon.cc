// A polygon is checked by CGAL inside the library: its users must get GMP and MPFR linked without asking.
#include <iostream>

#include <patchgrip/friction/polygon.h>

int main() {
  const auto unit_square = patchgrip::friction::Polygon::uniform({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {});
  std::cout << "area radius " << unit_square.area_radius() << " m\n";
}
