// Integrals of Stribeck's excess: force and moment, with the errors that their integrands come with.
//
// Units    moment per a length of the patch's size, so that all are of one unit (vector_quadrature.h).
#pragma once

#include <array>

#include <patchgrip/friction/kernels/vector_quadrature.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::friction::kernels {

// exp(-u^2) below this, at speeds of 6.4 v_S and more, is not summed but counts as error.
inline constexpr double negligible = 1e-18;

// fx, fy, m / length, error of the force, of m / length
using ExcessParts = std::array<double, 5>;

inline void add(BoundedIntegrals<5>& sum, const BoundedIntegrals<5>& part) noexcept {
  for (std::size_t i = 0; i < 5; ++i) {
    sum.value[i] += part.value[i];
    sum.error[i] += part.error[i];
  }
}

inline BoundedWrench collected(const BoundedIntegrals<5>& sum, double scale, double length) noexcept {
  const auto& [value, error] = sum;
  return {{scale * value[0], scale * value[1], scale * length * value[2]},
          scale * (error[0] + error[1] + value[3]),
          scale * length * (error[2] + value[4])};
}

}  // namespace patchgrip::friction::kernels
