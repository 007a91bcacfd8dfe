// Elliptic contact that creeps and does not shrink: the Hertz ellipse with F / E* = X.
//
//     k = b/a, and with it the shape, depends on R_small / R_large alone: it does not creep
//     a^3 = 3 X R D / (pi),   delta ~ X^(2/3),   X(t) = int C(t - s) dF(s)        (Lee and Radok 1960; hertz_ellipse.h)
//
// The pressure is not that of Hertz, as in press_under_force.h.
//
// Domain   while X does not fall: up to load_integral_falls_at().
// Units    F [N], X [m^2], a, b, delta [m], t [s].
// Error    those of HertzEllipse and a third of those of X; tests/contact/contact_creep_test.cc.
// Throws   std::invalid_argument where X is not positive, or fell before t.
#pragma once

#include <patchgrip/contact/creep/contact_creep.h>
#include <patchgrip/contact/creep/load_integral.h>
#include <patchgrip/contact/hertz_ellipse.h>

namespace patchgrip::contact {

struct GrowingEllipse {
  static GrowingEllipse under_force(const RelativeRadii& radii, const ContactCreep& creep, const History& force,
                                    double t) {
    const double falls = load_integral_falls_at(creep.compliance, force, t);
    if (falls < t) refuse("time", t, "must not be after the load integral falls: the ellipse would shrink");
    const auto ellipse = HertzEllipse::under_force(
        require_positive("load integral", load_integral(creep.compliance, force, t)), radii, 1);
    return {ellipse.a, ellipse.b, ellipse.approach};
  }

  double a;         // major semi-axis [m]
  double b;         // minor semi-axis [m]
  double approach;  // delta [m]
};

}  // namespace patchgrip::contact
