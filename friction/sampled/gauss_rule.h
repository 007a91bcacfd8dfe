// Gauss-Legendre rules on [-1, 1], each made once.
#pragma once

#include <vector>

namespace patchgrip::friction::kernels {

struct GaussPoint {
  double t;
  double weight;
};

inline constexpr int most_gauss_points = 32;

// Exact for polynomials of degree 2 count - 1; 1 <= count <= most_gauss_points.
const std::vector<GaussPoint>& gauss_rule(int count);

}  // namespace patchgrip::friction::kernels
