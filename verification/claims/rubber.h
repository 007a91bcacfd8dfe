// A hemisphere of rubber, its base held, pressed by a rigid plate: large strains.
//
// Neo-Hooke, incompressible; R = 1 m, G = 1 Pa. Against it stand, of a small contact on a half-space,
//
//     Hertz and the exact sphere   F(delta), a(delta), E* = 4 G
//     Hertz under the load         a(F) = (3 F R / 4 E*)^(1/3)
//     a power of the load          a = c F^gamma, fitted to the radii that FE finds (contact/fingertip/power_law.h)
//
// FE's pairs of load and radius are judged by ratios to the last two, which are 1 where the law is right.
//
// Units    SI. Throws std::invalid_argument where a load or radius is not positive.
#pragma once

#include <vector>

#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

struct PressedHemisphere {
  std::vector<double> approaches;  // of the plate to the base [m]
  std::vector<Quantity> quantities;
};
PressedHemisphere rubber_hemisphere();

// What is claimed of them, from the loads [N] and radii [m] at the approaches.
std::vector<std::vector<double>> values_of(const std::vector<double>& forces, const std::vector<double>& radii);

// What sticks moves with the plate: Q = K_v d, M = K_w beta, for dynamics/ to take as the stiffness of its bristles. Of
// Mindlin's K_v = 16 E a / 9, K_w = 16 E a^3 / 9, with E = 3 G and the radius that FE finds, they are those shares.
PressedHemisphere fingertip();

}  // namespace patchgrip::verification
