// Displacement around a contact from its definition, in fifty digits: the judge of its closed forms and series.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>

#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/contact/flat_end_circle.h>
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

// Radii where a displacement changes its size or its form: next to the rim, on both sides of 5/4 a and of sqrt(2) a,
// far away.
inline std::vector<double> radii_around(double a) {
  return {std::nextafter(a, std::numeric_limits<double>::infinity()),
          a * (1 + 1e-15),
          a * (1 + 1e-12),
          a * (1 + 1e-6),
          1.2499999 * a,
          1.2500001 * a,
          1.41421356 * a,
          1.41421357 * a,
          3 * a,
          1e3 * a,
          1e6 * a,
          1e12 * a};
}

// A stamp with a flat end of radius b, in fifty digits.
template <class Profile>
void expect_displacement_is_its_integral(const Profile& profile, double b) {
  const auto rate = [&](const Exact& y) -> Exact {
    const auto circle = contact::BasicFlatEndCircle<Exact>::of_reach(Exact(b), y);
    return profile.approach_slope(circle) * y / circle.radius;
  };
  for (const double a : {1.2 * b, 3 * b}) {
    for (const double r : {a * (1 + 1e-12), 1.3 * a, 2 * a}) {
      const Exact integral = displacement_integral(rate, r, a, b);
      EXPECT_LE(abs(profile.displacement(Exact(r), Exact(a)) / integral - 1), 1e-30) << a << ' ' << r;
    }
  }
}

// The same stamp in double, the radius given and the reach.
template <class Profile>
void expect_displacement_holds_its_error(const Profile& profile, double b) {
  const double stated = profile.errors().displacement;
  for (const double beyond : {1e-15, 1e-12, 1e-6, 0.01, 0.41421356, 0.41421357, 2., 1e3, 1e9, 1e12}) {
    const double a = b * (1 + beyond);
    const auto circle = contact::FlatEndCircle::of_reach(b, b * beyond);
    const auto exact = contact::BasicFlatEndCircle<Exact>::of_reach(Exact(b), Exact(b * beyond));
    for (const double r : radii_around(a)) {
      const Exact u = profile.displacement(Exact(r), Exact(a));
      EXPECT_LE(units_of_rounding(profile.displacement(r, a), u), stated) << a << ' ' << r;
      if (r * (1 - 1e-15) < circle.radius) continue;
      EXPECT_LE(units_of_rounding(profile.displacement(r, circle), profile.displacement(Exact(r), exact)), stated)
          << a << ' ' << r;
    }
  }
}

}  // namespace patchgrip::testing
