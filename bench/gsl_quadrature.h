// Force and moment of a Hertz disc by adaptive quadrature of their definition (4.47) in two dimensions.
//
// In polar coordinates, the axis through the pole: with x = r_M / a, d^2 = (r - x)^2 + 4 r x sin^2(phi/2),
//
//     f = 2 int_0^1 int_0^pi (x - r cos phi) / d  p r dphi dr,       p = 3/(2 pi) sqrt(1 - r^2)
//     m = 2 int_0^1 int_0^pi (r^2 - r x cos phi) / d  p r dphi dr
//
// Both levels are gsl_integration_qags (QUADPACK); the outer one is split at r = x, where the inner integral has a
// kink.
// The tolerance is absolute in units of mu F_N and mu F_N a, and relative: what is met first ends a quadrature.
#pragma once

#include <patchgrip/bench/gsl_adaptive.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

class GslQuadrature {
 public:
  GslQuadrature(double radius, double tolerance);

  friction::Wrench gradient(const friction::Twist& v) const;

 private:
  template <class Integrand>
  double integral(double x, const Integrand& integrand) const;

  double radius_;  // a [m]
  double tolerance_;
  GslWorkspace outer_, inner_;
};

}  // namespace patchgrip::bench
