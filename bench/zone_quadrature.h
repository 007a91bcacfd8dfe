// Force and moment by adaptive quadrature of their definition (4.47) over any zone (zone.h), as one writes it down:
//
//     grad D = int int p (v_x, v_y, x v_y - y v_x) / |v| dy dx,    v = (vx - w y, vy + w x)
//
// both levels by gsl_integration_qags, split where the pole is; along a curve by one level, in two halves. The
// tolerance is that of force and of moment over the zone's size.
#pragma once

#include <utility>

#include <patchgrip/bench/gsl_adaptive.h>
#include <patchgrip/bench/zone.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

class ZoneQuadrature {
 public:
  ZoneQuadrature(Zone zone, double tolerance);

  friction::Wrench gradient(const friction::Twist& v) const;

 private:
  template <class Integrand>
  double integral(const friction::Point& pole, const Integrand& integrand) const;

  Zone zone_;
  double tolerance_;
  GslWorkspace outer_, inner_;
};

}  // namespace patchgrip::bench
