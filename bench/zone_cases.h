// Every kind of patch by every method that can do it: the exact one, sums over points, adaptive quadrature, a sampled
// pressure, and the polynomials of Keppler 2006 on the Hertz disc; poles near the zone, at its rim and far away. Each
// error is the worst over 200 poles, with Xydas and Kao 30, of the quadrature 4.
#pragma once

#include <vector>

#include <patchgrip/bench/case.h>

namespace patchgrip::bench {

// The scale of moments is l = M_0 / (mu F_N), the moment of a rotation about the centre of pressure.
std::vector<Case> zone_cases();

}  // namespace patchgrip::bench
