// Displacement around a contact from its definition, in fifty digits: the judge of its closed forms and series.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <boost/math/constants/constants.hpp>

#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::testing {

// (2/pi) int arcsin(x/r) dg(x) over the x between the flat end b (0 if there is none) and a; with x = sqrt(y^2 + b^2),
// rate(y) = dg/dy.
template <class Rate>
Exact displacement_integral(const Rate& rate, double r, double a, double b) {
  const Exact end(b);
  const auto integrand = [&](const Exact& y, const Exact&) -> Exact {
    return rate(y) * asin(sqrt(y * y + end * end) / r);
  };
  const Exact reach = sqrt((Exact(a) - end) * (Exact(a) + end));
  return 2 / boost::math::constants::pi<Exact>() * contact::integrate_to_both_ends(integrand, Exact(0), reach);
}

// Radii where a displacement changes its size or its form: next to the rim, on both sides of sqrt(2) a, far away.
inline std::vector<double> radii_around(double a) {
  return {std::nextafter(a, std::numeric_limits<double>::infinity()),
          a * (1 + 1e-15),
          a * (1 + 1e-12),
          a * (1 + 1e-6),
          1.2 * a,
          1.41421356 * a,
          1.41421357 * a,
          3 * a,
          1e3 * a,
          1e6 * a,
          1e12 * a};
}

}  // namespace patchgrip::testing
