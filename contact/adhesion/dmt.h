// Adhesion after Derjaguin, Muller and Toporov: Hertz contact under an additional load 2 pi w R from outside it.
//
//     a^3 = (3 R / 4 E*)(F + 2 pi w R),   delta = a^2 / R,   dF/d(delta) = 2 E* a
//     p(r) = (2 E* / (pi R)) sqrt(a^2 - r^2)      (without the attraction outside, which carries -2 pi w R)
//
// (J. Colloid Interface Sci. 53, 1975, in the form of Maugis.) The bodies part at F = -2 pi w R, where a = 0.
//
// Domain   small Tabor parameter (tabor.h); F >= -2 pi w R; a much smaller than R.
// Units    F [N], a, r, delta [m], p [Pa], stiffness [N/m].
// Error    units of 2^-53, relative: a, delta, stiffness <= 1.1, under load also next to the pull-off; F at a given
//          approach <= 1.1 of the larger of its terms; tests/contact/dmt_test.cc.
// Throws   std::invalid_argument, naming the parameter: loads below the pull-off, negative approaches, r > a.
#pragma once

#include <patchgrip/contact/adhesion/adhesive_sphere.h>

namespace patchgrip::contact {

struct Dmt {
  explicit Dmt(const AdhesiveSphere& contact) : sphere(contact) {}

  AdhesiveState under_force(double normal_force) const;
  AdhesiveState at_approach(double approach) const;

  AdhesiveState pull_off() const { return at_approach(0); }
  AdhesiveState no_load() const { return under_force(0); }

  double pressure(double contact_radius, double r) const;  // 0 <= r <= a

  AdhesiveSphere sphere;
};

}  // namespace patchgrip::contact
