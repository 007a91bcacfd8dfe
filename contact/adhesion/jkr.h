// Adhesion after Johnson, Kendall and Roberts: Hertz pressure and a tension that is singular at the rim.
//
//     F = 4 E* a^3 / (3 R) - sqrt(8 pi w E* a^3),   delta = a^2 / R - sqrt(2 pi a w / E*)     (seed 4.1.4, w = 2 gamma)
//     p(r) = (2 E* / (pi R)) sqrt(a^2 - r^2) - (E* / pi) sqrt(2 pi a w / E*) / sqrt(a^2 - r^2)
//     dF/d(delta) = 2 E* a (1 - 3y/4) / (1 - y/4),   y = sqrt(2 pi w R^2 / (E* a^3))
//
// (Proc. Roy. Soc. A 324, 1971; Johnson 5.5.) The energy release rate (E* / 2 pi a)(delta - a^2/R)^2 is w everywhere.
// With s = F + 3 pi w R and q = sqrt(3 pi w R (2 F + 3 pi w R)):
//
//     a^3 = (3 R / 4 E*)(s + q)            stable under a load F >= -1.5 pi w R
//     a^3 = (3 R / 4 E*) F^2 / (s + q)     unstable under load, -1.5 pi w R <= F < 0 (s - q without cancellation)
//
// Held by its approach the contact is stable further, down to a^3 = pi w R^2 / (8 E*), y = 4. With L^3 = pi w R^2 / E*,
// a = L (1 + t)^2 / 2 and t^2 (6 + 4 t + t^2) = 3 + 4 R delta / L^2.
//
//                           F                 a^3                   delta
//     load_pull_off         -(3/2) pi w R     9 pi w R^2 / (8 E*)
//     displacement_pull_off -(5/6) pi w R     pi w R^2 / (8 E*)     -(3/4) L^2 / R
//     jump_in               -(4/3) pi w R     2 pi w R^2 / E*       0           (first touch, held by its approach)
//     no_load               0                 9 pi w R^2 / (2 E*)
//
// Domain   large Tabor parameter (tabor.h); a much smaller than R.
// Units    F [N], a, r, delta [m], p [Pa], stiffness [N/m].
// Error    units of 2^-53: a <= 1.1, relative, at every load; at a given approach <= 1.1 + 2^-8 / t. F, delta,
//          stiffness, p: <= 1.1 relative to the larger of their two terms, where a is given; where F or delta is given,
//          that one is returned as it is, and the other has <= 3 (plus those of a by an approach) times the larger
//          term. The stiffness has a pole at y = 4: at a given approach <= 2 + 2^-8 / t + 2^-9 / t^2, relative to the
//          larger of 2 E* a 3y / |4 - y| and itself; tests/contact/jkr_test.cc.
// Fails    the stiffness is infinite where the approach is least, and p tends to -infinity at the rim.
// Throws   std::invalid_argument, naming the parameter: loads and approaches below pull-off, r >= a.
#pragma once

#include <patchgrip/contact/adhesion/adhesive_sphere.h>

namespace patchgrip::contact {

struct Jkr {
  explicit Jkr(const AdhesiveSphere& contact) : sphere(contact) {}

  AdhesiveState at_radius(double contact_radius) const;  // stable or not
  AdhesiveState under_force(double normal_force) const;
  AdhesiveState unstable_under_force(double normal_force) const;
  AdhesiveState at_approach(double approach) const;  // the larger of two radii

  AdhesiveState load_pull_off() const;
  AdhesiveState displacement_pull_off() const;
  AdhesiveState jump_in() const;
  AdhesiveState no_load() const;

  double pressure(double contact_radius, double r) const;  // 0 <= r < a

  AdhesiveSphere sphere;
};

}  // namespace patchgrip::contact
