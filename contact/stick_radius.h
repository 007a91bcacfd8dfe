// Stick while two bodies are pressed together with friction: radius a_S of the inner circle that sticks.
//
// Dissimilar bodies want to slip outwards under pressure. With chi = beta_D / mu (dundurs.h) and s = a_S / a:
//
//     (1 / 2s) ln((1 + s)/(1 - s)) = (1 / chi) K(sqrt(1 - s^2))                    (Spence; Johnson 5.4; seed 4.1.4)
//
// (uncoupled: the shear does not act back on the pressure, Goodman). The same for a punch and for a sphere, as long as
// the load only grows. Solved for L = artanh s, in which it reads chi L = s K(sqrt(1 - s^2)) and both ends are open:
//
//     1 - s -> 2 exp(-pi/chi)   for chi -> 0,        s -> 4 exp(-chi)   for chi -> infinity
//
// The seed prints the right side with its inverse, (a/a_S) ln(..) = (beta/mu) K with beta = 4 |beta_D|: its figure 4.12
// and its "a_S <= 1 % for beta/mu <= 1/3" follow from that, against its own limit beta -> 0. seed_printed_stick_ratio()
// solves what is printed.
//
// Domain   chi > 0 (0: everything sticks, no need to ask).
// Units    [1].
// Error    units of 2^-53, relative, of everything above 1e-300 in size: s, 1 - s <= 2, their logarithms <= 1.1: one
//          rounding to double, the rest in 64 bits. Of those the logarithm of L loses at most 8 |ln L| <= 24 units,
//          and 1 - s loses 3 (2 L), where 2 L <= 53; where L is larger or smaller, the limits above are exact to
//          rounding. tests/contact/stick_radius_test.cc.
// Fails    for large |beta_D|, where the coupling counts: it lowers s by 1 % at beta_D = 0.2, chi = 1, by 8 % at 0.45.
//          s and 1 - s fall to 0 where they are below the range of double: their logarithms do not.
// Throws   std::invalid_argument unless chi is positive and finite; std::runtime_error should the root not be found.
#pragma once

namespace patchgrip::contact {

struct StickRatio {
  static StickRatio of(double beta_over_mu);  // chi = |beta_D| / mu

  double stick;      // s = a_S / a
  double slip;       // 1 - s
  double log_stick;  // ln s
  double log_slip;   // ln(1 - s)
};

// The seed's printed equation, for its figure 4.12: printed_beta_over_mu = 4 |beta_D| / mu.
StickRatio seed_printed_stick_ratio(double printed_beta_over_mu);

}  // namespace patchgrip::contact
