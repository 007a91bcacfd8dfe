// An approximate inverse of the half-space: pressure from displacement on an infinite periodic surface.
//
//     (M r)^(q) = (1/2) sqrt(q^2 + q_0^2) r^(q),   q_0 = pi / L (free), pi / 2L (periodic), L = sqrt(L_x L_y)
//
// A wave of pressure p cos(q x) displaces the surface by (2 / E* q) p cos(q x): M undoes that, and the floor q_0 keeps
// the mean. Symmetric and positive definite, so conjugate gradients may use it, restricted to any set of cells. Without
// padding: a quarter of the cost of a product with a free surface.
//
// Units    r [m], M r [1] (p / E*).
#pragma once

#include <patchgrip/contact/half_space/convolution.h>
#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/resources.h>
#include <patchgrip/contact/half_space/spectral_product.h>

namespace patchgrip::contact {

class Preconditioner {
 public:
  Preconditioner(const Grid& grid, Surface surface, Resources resources);

  // r and M r may be the same array.
  void apply(const double* r, double* Mr, Workers& workers) { product_.apply(symbol_.data(), r, Mr, workers); }

 private:
  SpectralProduct product_;
  Array<double> symbol_;
};

}  // namespace patchgrip::contact
