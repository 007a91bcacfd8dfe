// Displacement of a half-space under any pressure on a grid.
//
//     u_z(x) = (1 / pi E*) integral p(x') / |x - x'| dA'                        (Boussinesq; seed 4.6, Johnson 3.17)
//
// the pressure constant in each cell, u_z at the centres. A `free` surface is that of the whole half-space, pressed on
// the grid alone: the sum over Love's rectangles (love_kernel.h), as a product in Fourier space. A `periodic` surface
// repeats the grid without end: u_z of a wave p cos(q x) is (2 / E* q) p cos(q x) exactly, and the mean of u_z, which
// the mean pressure would make infinite, is put to zero.
//
// Units    u_z [m]; p [Pa]. Convolution takes p / E*.
// Error    u_z of the piecewise constant pressure: <= convolution_error of the largest |u_z|;
//          tests/contact/convolution_test.cc.
//          Of a smooth pressure sampled at the centres: order 2 in the cell size, 1.5 near a Hertzian edge.
// Throws   displacement(): std::invalid_argument unless the pressure has one finite number a cell and E* is positive.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/contact/half_space/grid.h>
#include <patchgrip/contact/half_space/resources.h>
#include <patchgrip/contact/half_space/spectral_product.h>

namespace patchgrip::contact {

enum class Surface { free, periodic };

inline constexpr double convolution_error = 1e-13;

class Convolution {
 public:
  Convolution(const Grid& grid, Surface surface, Resources resources);

  // u_z [m] from p / E* [1]; they may be the same array.
  void apply(const double* pressure, double* displacement, Workers& workers);

 private:
  SpectralProduct product_;
  Array<double> symbol_;
};

// The inverse problem: u_z [m] under p [Pa]. The shape that takes this pressure is approach - u_z in the contact.
std::vector<double> half_space_displacement(const Grid& grid, Surface surface, std::span<const double> pressure,
                                            double contact_modulus, int threads = 1);

}  // namespace patchgrip::contact
