// Dundurs' parameters of two elastic half-spaces: how much the materials differ.
//
//     alpha_D = (E'_p - E'_m) / (E'_p + E'_m),   E' = E / (1 - nu^2)
//     beta_D = (E*/2) [(1 - 2 nu_m)(1 + nu_m) / E_m - (1 - 2 nu_p)(1 + nu_p) / E_p]     (Johnson 5.3, E* of material.h)
//
// beta_D couples normal and tangential displacement: it is 0 for equal materials, for two incompressible ones, and for
// an incompressible body against a rigid one; positive where body p is the more compliant in shear. Frictionless normal
// contact needs E* alone. The seed (4.1.4) writes (2 + 2 nu) for (1 + nu)/2 and so prints 4 |beta_D|.
//
// Domain   one body may be rigid.
// Units    [1]; |alpha_D| <= 1, |beta_D| <= 3/4 (1/2 for nu >= 0).
// Error    <= 1.01 units of 2^-53, relative, plus 2^-62 absolute where similar bodies nearly cancel;
//          tests/contact/dundurs_test.cc.
// Throws   std::invalid_argument for two rigid bodies.
#pragma once

#include <patchgrip/contact/material.h>

namespace patchgrip::contact {

struct Dundurs {
  static Dundurs of(const Material& p, const Material& m);

  double seed_printed_beta() const { return beta < 0 ? -4 * beta : 4 * beta; }  // seed 4.1.4

  double alpha;  // alpha_D [1]
  double beta;   // beta_D [1]
};

}  // namespace patchgrip::contact
