#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/cosine_transform.h>
#include <patchgrip/contact/half_space/love_kernel.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {

Convolution::Convolution(const Grid& grid, Surface surface, Resources resources)
    : product_(grid.nx, grid.ny, surface == Surface::free ? Padding::doubled : Padding::none, resources),
      symbol_(product_.symbol_size(), resources.memory) {
  if (surface == Surface::free) {
    const Grid transposed{grid.ny, grid.nx, grid.dy, grid.dx};  // the symbol runs along y first
    fill_love_table(transposed, product_.rows(), product_.columns(), symbol_.data(), resources.set_up);
    cosine_transform(product_.rows(), product_.columns(), 1 / product_.normalisation(), symbol_.data(), resources);
    return;
  }
  const double lx = grid.nx * grid.dx, ly = grid.ny * grid.dy;
  const auto displacement = [&](int i, int j) {
    const double q = 2 * std::numbers::pi * std::hypot(i / lx, j / ly);
    return q > 0 ? 2 / q : 0;
  };
  product_.fill_symbol(displacement, symbol_.data(), resources.set_up);
}

void Convolution::apply(const double* pressure, double* displacement, Workers& workers) {
  product_.apply(symbol_.data(), pressure, displacement, workers);
}

std::vector<double> half_space_displacement(const Grid& grid, Surface surface, std::span<const double> pressure,
                                            double contact_modulus, int threads) {
  require_positive("contact_modulus", contact_modulus);
  if (pressure.size() != grid.size()) {
    refuse("pressure.size()", static_cast<double>(pressure.size()), "must be nx ny of the grid");
  }
  std::vector<double> field(pressure.begin(), pressure.end());
  for (double& value : field) value = require_finite("pressure", value) / contact_modulus;
  Workers workers(threads);
  Convolution(grid, surface, {workers}).apply(field.data(), field.data(), workers);
  return field;
}

}  // namespace patchgrip::contact
