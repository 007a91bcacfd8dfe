#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/love_kernel.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <numbers>

namespace patchgrip::contact {
namespace {

void fill_periodic_symbol(const Grid& grid, const SpectralProduct& product, std::vector<double>& symbol) {
  auto value = symbol.begin();
  for (int i = 0; i < product.columns(); ++i) {
    for (int j = 0; j < product.rows(); ++j) {
      const double q = 2 * std::numbers::pi * std::hypot(i / (grid.nx * grid.dx), j / (grid.ny * grid.dy));
      *value++ = q > 0 ? 2 / q : 0;
    }
  }
}

}  // namespace

Convolution::Convolution(const Grid& grid, Surface surface, int threads)
    : product_(grid.nx, grid.ny, surface == Surface::free ? Padding::doubled : Padding::none, threads),
      symbol_(product_.symbol_size()) {
  if (surface == Surface::free) {
    const Grid transposed{grid.ny, grid.nx, grid.dy, grid.dx};  // the symbol runs along y first
    fill_love_table(transposed, product_.rows(), product_.columns(), symbol_.data());
    cosine_transform(product_.rows(), product_.columns(), symbol_.data());
  } else {
    fill_periodic_symbol(grid, product_, symbol_);
  }
  for (double& value : symbol_) value /= product_.normalisation();
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
  Convolution(grid, surface, threads).apply(field.data(), field.data(), workers);
  return field;
}

}  // namespace patchgrip::contact
