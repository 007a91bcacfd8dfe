#include <patchgrip/contact/elliptic_power_pressure.h>

#include <cmath>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/contact/complete_elliptic.h>
#include <patchgrip/contact/endpoint_quadrature.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {
namespace {

// (2n-1)! / (4^n n! (n-1)!) = Gamma(n + 1/2) / (2 sqrt(pi) Gamma(n + 1))
double integral_constant(int n) {
  const auto x = static_cast<long double>(n);
  return static_cast<double>(boost::math::tgamma_ratio(x + 0.5L, x + 1) /
                             (2 * std::sqrt(std::numbers::pi_v<long double>)));
}

}  // namespace

EllipticPowerPressure EllipticPowerPressure::of(int n, double a, double b, double peak_pressure,
                                                double contact_modulus) {
  require_in("n", n, 1, 1000);
  require_positive("a", a);
  require_in("b", b, 1e-9 * a, a);
  require_positive("peak_pressure", peak_pressure);
  require_positive("contact_modulus", contact_modulus);
  const auto elliptic = CompleteElliptic<double>::of_axes(b / a, (a - b) / a);
  const double scale = 4 * integral_constant(n) * (peak_pressure / contact_modulus);
  return {n,
          a,
          b,
          peak_pressure,
          contact_modulus,
          require_representable("normal_force", peak_pressure * (2 * std::numbers::pi / (2 * n + 1)) * a * b),
          require_representable("approach", scale * b * elliptic.K),
          require_representable("curvature_x", 2 * n * scale * (b / a) * (elliptic.D / a)),
          require_representable("curvature_y", 2 * n * scale * (elliptic.B / b))};
}

double EllipticPowerPressure::pressure(double x, double y) const {
  // Extended precision: next to the rim the three terms cancel.
  const long double X = static_cast<long double>(x) / a;
  const long double Y = static_cast<long double>(y) / b;
  const auto inside = static_cast<double>(1 - X * X - Y * Y);
  return inside > 0 ? peak_pressure * std::pow(inside, n - 0.5) : 0;
}

// Over a quarter, both signs of y: next to t = pi/2 a slender ellipse peaks within b/a.
double EllipticPowerPressure::displacement(double x, double y) const {
  const double X = x / a;
  const double Y = y / b;
  require_in("x^2/a^2 + y^2/b^2", X * X + Y * Y, 0, 1 + 0x1p-51);
  const auto integrand = [&](double t, double left) {
    const double sin = t < left ? std::sin(t) : std::cos(left);
    const double cos = t < left ? std::cos(t) : std::sin(left);
    const double one = X * sin - Y * cos;
    const double other = X * sin + Y * cos;
    const auto power = [this](double s) { return std::fabs(s) < 1 ? std::pow((1 - s) * (1 + s), n) : 0; };
    return (power(one) + power(other)) / std::hypot(a * cos, b * sin);
  };
  const double integral = integrate_to_both_ends(integrand, 0., std::numbers::pi / 2);
  return 2 * integral_constant(n) * (peak_pressure / contact_modulus) * a * b * integral;
}

}  // namespace patchgrip::contact
