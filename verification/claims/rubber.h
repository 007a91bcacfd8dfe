// A hemisphere of rubber, its base held, pressed by a rigid plate: large strains.
//
// Neo-Hooke, incompressible; R = 1 m, G = 1 Pa. Against it stand, of a small contact on a half-space,
//
//     Hertz and the exact sphere   F(delta), E* = 4 G
//     a power of the load          a = c F^gamma, fitted to the radii that FE finds (contact/fingertip/power_law.h)
#pragma once

#include <span>
#include <vector>

#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

struct RubberHemisphere {
  std::vector<double> approaches;  // of the plate to the base [m]
  std::vector<Quantity> quantities;
};
RubberHemisphere rubber_hemisphere();

// a over that of the power of the load which fits all of them best [1].
std::vector<double> over_power_law(std::span<const double> forces, std::span<const double> radii);

}  // namespace patchgrip::verification
