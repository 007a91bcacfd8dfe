#include <patchgrip/contact/rotational_pressure.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {
namespace {

// sqrt(pi) Gamma(n) / Gamma(n + 1/2) = 4^n n! (n-1)! / (2n)!
double peak_constant(int n) {
  const auto x = static_cast<long double>(n);
  return static_cast<double>(std::sqrt(std::numbers::pi_v<long double>) * boost::math::tgamma_ratio(x, x + 0.5L));
}

}  // namespace

RotationalPressure RotationalPressure::of_curvature(int n, double contact_radius, double curvature_radius,
                                                    double contact_modulus) {
  require_in("n", n, 1, 1000);
  const double a = require_positive("contact_radius", contact_radius);
  const double R = require_positive("curvature_radius", curvature_radius);
  const double E = require_positive("contact_modulus", contact_modulus);
  const double peak = E / std::numbers::pi * peak_constant(n) * (a / R);
  return {n,
          a,
          R,
          E,
          require_representable("peak_pressure", peak),
          require_representable("normal_force", E * peak_constant(n) * (a / R) * a / (n + 0.5) * a),
          require_representable("approach", a / n * (a / R))};
}

double RotationalPressure::pressure(double r) const {
  r = std::fabs(r);
  if (r >= radius) return 0;
  const double w = (radius - r) / radius * ((radius + r) / radius);
  return peak_pressure * std::pow(w, n - 1) * std::sqrt(w);
}

double RotationalPressure::height(double r) const {
  require_in("r", r, 0, radius);
  const double rho = r / radius;
  const int nodes = n + 1;
  long double sum = 0;  // of up to a thousand terms: in double their roundings would add up
  for (int j = 1; j < nodes; ++j) {
    const double s = rho * std::sin(std::numbers::pi * std::min(j, nodes - j) / nodes);  // not of a rounded pi - x
    sum -= std::expm1(n * std::log1p(-s * s));
  }
  return approach / nodes * static_cast<double>(sum);
}

double RotationalPressure::displacement(double r) const {
  r = std::fabs(r);
  if (std::isnan(r)) return r;
  if (r <= radius) return approach - height(r);
  // s = sin t; r - a s from 1 - sin t.
  const auto weighted = [&](double, double left) {
    const double s = std::cos(left);
    const double away = (r - radius) + 2 * radius * std::pow(std::sin(left / 2), 2);
    return std::pow(std::sin(left), 2 * n + 1) / std::sqrt(away / r * (1 + radius / r * s));
  };
  const double integral = integrate_to_both_ends(weighted, 0., std::numbers::pi / 2);
  // int_0^1 (1 - s^2)^n ds = sqrt(pi)/2 Gamma(n + 1) / Gamma(n + 3/2)
  const double whole = peak_constant(n) * n / (2 * n + 1.);
  return force / (std::numbers::pi * contact_modulus * r) * (integral / whole);
}

}  // namespace patchgrip::contact
