#include <patchgrip/contact/complete_elliptic.h>
#include <patchgrip/contact/elliptic_pressure.h>
#include <patchgrip/contact/require.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr double slenderest = 1e-16;

struct Square {
  Real high, low;  // (length / axis)^2, to twice the digits
};

Square square_of_ratio(Real length, Real axis) {
  const Real ratio = length / axis;
  const Real rest = std::fma(-ratio, axis, length) / axis;
  const Real high = ratio * ratio;
  return {high, std::fma(ratio, ratio, -high) + 2 * ratio * rest};
}

// 1 - x^2/a^2 - y^2/b^2. Near the rim the high parts cancel exactly, the larger one first.
Real inside(const EllipticPressure& e, double x, double y) {
  const Square along = square_of_ratio(x, e.a), across = square_of_ratio(y, e.b);
  return (1 - std::max(along.high, across.high)) - std::min(along.high, across.high) - (along.low + across.low);
}

}  // namespace

EllipticPressure EllipticPressure::of(double a, double b, double peak_pressure) {
  require_positive("a", a);
  require_in("b", b, slenderest * a, a);
  return {a, b, require_positive("peak_pressure", peak_pressure)};
}

double EllipticPressure::pressure(double x, double y) const {
  const Real level = inside(*this, require_finite("x", x), require_finite("y", y));
  return level > 0 ? static_cast<double>(peak_pressure * std::sqrt(level)) : 0;
}

double EllipticPressure::normal_force() const {
  return static_cast<double>(2 * std::numbers::pi_v<Real> * a * b * peak_pressure / 3);
}

double EllipticPressure::displacement(double x, double y, double contact_modulus) const {
  const Real modulus = require_positive("contact_modulus", contact_modulus);
  // Lengths in a: squares neither overflow nor underflow.
  const Real k = Real(b) / a, one_minus_k = (Real(a) - b) / a;
  const Real u = require_finite("x", x) / Real(a), v = require_finite("y", y) / Real(a);
  const Real scale = peak_pressure * Real(b) / modulus;
  const Real level = inside(*this, x, y);
  if (level >= 0) {
    const auto c = CompleteElliptic<Real>::of_axes(k, one_minus_k);
    return static_cast<double>(scale * (c.K - u * u * c.D - v / k * (v / k) * c.B));
  }

  // w^2 + P w + Q = 0, Q < 0.
  const Real beyond = (1 - u) * (1 + u);
  const Real P = beyond + (k - v) * (k + v);
  const Real Q = k * k * level;
  const Real root = std::hypot(beyond - (k - v) * (k + v), 2 * u * v);  // sqrt(P^2 - 4 Q)
  const Real w = P > 0 ? -2 * Q / (P + root) : (root - P) / 2;
  const Real A = 1 + w, B = k * k + w;
  const Real potential = boost::math::ellint_rf(w, B, A) - u * u / 3 * boost::math::ellint_rd(B, w, A) -
                         v * v / 3 * boost::math::ellint_rd(A, w, B);
  return static_cast<double>(scale * potential);
}

}  // namespace patchgrip::contact
