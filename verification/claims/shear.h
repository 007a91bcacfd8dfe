// Hertz contact under a growing twist or shear: partial slip, and where patch friction without elasticity is right.
//
// p = p_0 sqrt(1 - r^2/a^2) with a = 1 m, p_0 = 1 Pa, given; G = 1 Pa.
//
//     torsion   beta = (mu p_0 / (2 G)) (K(k) - E(k)), k^2 = 1 - c^2/a^2, turns so far that the circle c sticks
//               M = (16/3) G (c^3 beta + 3 int_c^a t^2 beta(t) dt)                               (Lubkin 1951)
//     shear     d = 3 mu F (2 - nu) / (16 G a) (1 - (1 - Q/(mu F))^(2/3)),  nu = 0         (Cattaneo, Mindlin 1949)
//     stuck     M / beta = 16 G a^3 / 3,  Q / d = 8 G a / (2 - nu): 16 E a^3 / 9, 16 E a / 9 for nu = 1/2
//
// The patch of the library (friction::HertzDisc) has no elasticity: it resists with all it has from the start.
#pragma once

#include <vector>

#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

struct Torsion {
  double mu;
  std::vector<double> turns;  // beta [rad]
  std::vector<Quantity> quantities;
};
Torsion torsion();

struct Shear {
  double mu;
  std::vector<double> forces;  // Q [N]
  std::vector<Quantity> quantities;
};
Shear shear();

struct StuckCircle {
  double poisson_ratio;
  std::vector<Quantity> quantities;  // stiffnesses
};
StuckCircle stuck_circle();

}  // namespace patchgrip::verification
