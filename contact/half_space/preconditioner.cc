#include <patchgrip/contact/half_space/preconditioner.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {

Preconditioner::Preconditioner(const Grid& grid, Surface surface, int threads)
    : product_(grid.nx, grid.ny, Padding::none, threads), symbol_(product_.symbol_size()) {
  constexpr double pi = std::numbers::pi;
  const double lx = grid.nx * grid.dx, ly = grid.ny * grid.dy;
  const double floor = (surface == Surface::free ? pi : pi / 2) / std::sqrt(lx * ly);
  auto value = symbol_.begin();
  for (int i = 0; i < product_.columns(); ++i) {
    for (int j = 0; j < product_.rows(); ++j) {
      const double qx = 2 * pi * i / lx, qy = 2 * pi * j / ly;
      *value++ = std::sqrt(qx * qx + qy * qy + floor * floor) / (2 * product_.normalisation());
    }
  }
}

}  // namespace patchgrip::contact
