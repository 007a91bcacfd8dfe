// Pressure under a soft fingertip after Xydas and Kao: a family from a cone to a block.
//
//     p(r) = p_0 (1 - (r/a)^alpha)^(1/alpha)                                                                (seed 4.68)
//     p_0 = (F / (pi a^2)) Gamma(1 + 3/alpha) / (Gamma(1 + 1/alpha) Gamma(1 + 2/alpha))
//
// (the seed's 3 F alpha Gamma(3/alpha) / (2 pi a^2 Gamma(1/alpha) Gamma(2/alpha)), in a form that holds for large
// alpha.) alpha = 1 is a cone, 2 Hertz, 1.8 was found for neoprene, alpha -> infinity is uniform. An empirical
// pressure: no shape and no approach go with it. Its friction: friction/xydas_kao_disc.h.
//
// Domain   F, a > 0, 0.5 <= alpha <= 1e6.
// Units    F [N], a, r [m], p [Pa].
// Error    <= 1.1 units of 2^-53, relative, of p_0; of p the same for given p_0, also next to the rim, alpha <= 50;
//          tests/contact/xydas_kao_test.cc.
// Throws   std::invalid_argument, naming the parameter, outside the domain.
#pragma once

namespace patchgrip::contact {

struct XydasKaoPressure {
  static XydasKaoPressure of(double normal_force, double contact_radius, double alpha);

  double pressure(double r) const;  // r >= 0; 0 from the rim on

  double contact_radius;  // a [m]
  double alpha;           // [1]
  double peak_pressure;   // p_0 [Pa]
};

}  // namespace patchgrip::contact
