// S(M) = integral of p |P - M| dA with its first and second derivatives in the pole M.
#pragma once

namespace patchgrip::friction::kernels {

struct DistanceSums {
  double S = 0;
  double gx = 0, gy = 0;
  double xx = 0, xy = 0, yy = 0;
};

enum class Derivatives { first, second };

}  // namespace patchgrip::friction::kernels
