#include <patchgrip/contact/half_space/preconditioner.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {

Preconditioner::Preconditioner(const Grid& grid, Surface surface, Resources resources)
    : product_(grid.nx, grid.ny, Padding::none, resources), symbol_(product_.symbol_size(), resources.memory) {
  constexpr double pi = std::numbers::pi;
  const double lx = grid.nx * grid.dx, ly = grid.ny * grid.dy;
  const double floor = (surface == Surface::free ? pi : pi / 2) / std::sqrt(lx * ly);
  const auto pressure = [=](int i, int j) {
    const double qx = 2 * pi * i / lx, qy = 2 * pi * j / ly;
    return std::sqrt(qx * qx + qy * qy + floor * floor) / 2;
  };
  product_.fill_symbol(pressure, symbol_.data(), resources.set_up);
}

}  // namespace patchgrip::contact
