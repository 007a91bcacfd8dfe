#include <patchgrip/contact/fingertip/winkler.h>
#include <patchgrip/contact/require.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <boost/math/special_functions/log1p.hpp>

namespace patchgrip::contact {
namespace {

using Real = long double;

constexpr Real pi = std::numbers::pi_v<Real>;

Real depth(const WinklerFingertip& tip, double approach) {
  return require_in("approach", approach, 0, tip.tip_radius, Ends::open);
}

Real radius(const WinklerFingertip& tip, Real approach) {
  return std::sqrt(approach) * std::sqrt(2 * tip.tip_radius - approach);
}

void require_inclination(const WinklerFingertip& tip, Real approach, double inclination) {
  const Real opening = std::atan2(radius(tip, approach), tip.tip_radius - approach);  // arccos(h / R)
  require_in("inclination", inclination, 0, static_cast<double>(pi / 2 - opening), Ends::right_open);
}

// arcsin v - sqrt(1 - v^2) artanh v = int_0^v u artanh(u) / sqrt(1 - u^2) du, which starts like v^3/3.
Real phi(Real v) {
  if (v > 0.15L) return std::asin(v) - std::sqrt((1 - v) * (1 + v)) * std::atanh(v);
  // artanh(u) / sqrt(1 - u^2) = sum d_k u^(2k+1), (2k + 1) d_k = 2k d_(k-1) + b_k, (1 - u^2)^(-1/2) = sum b_k u^(2k).
  Real b = 1, d = 1, power = v * v * v, sum = power / 3;
  for (int k = 1; k < 13; ++k) {
    b *= Real(2 * k - 1) / (2 * k);
    d = (2 * k * d + b) / (2 * k + 1);
    power *= v * v;
    sum += d * power / (2 * k + 3);
  }
  return sum;
}

}  // namespace

WinklerFingertip WinklerFingertip::of(double tip_radius, double spring_modulus) {
  return {require_positive("tip_radius", tip_radius), require_positive("spring_modulus", spring_modulus)};
}

double WinklerFingertip::contact_radius(double approach) const {
  return static_cast<double>(radius(*this, depth(*this, approach)));
}

double WinklerFingertip::peak_pressure(double approach) const {
  const Real delta = depth(*this, approach), R = tip_radius;
  return static_cast<double>(spring_modulus * delta / R * ((R - delta) / R));
}

double WinklerFingertip::normal_force(double approach) const {
  const Real delta = depth(*this, approach), h = tip_radius - delta;
  return static_cast<double>(-2 * pi * spring_modulus * h * h * boost::math::log1pmx(delta / h));
}

WinklerFingertip::InclinedForce WinklerFingertip::inclined_force(double approach, double inclination) const {
  const Real delta = depth(*this, approach), h = tip_radius - delta, a = radius(*this, delta);
  require_inclination(*this, delta, inclination);
  const Real c = std::cos(Real(inclination)), s = std::sin(Real(inclination));
  const auto across = [&](Real psi) {
    const Real G = h * c - a * s * std::sin(psi), Y = a * std::cos(psi);
    return G * phi(Y / std::hypot(G, Y)) * Y * c;
  };
  // The integrand vanishes at both ends and goes on periodically: every doubling squares the error.
  Real sum = across(0);
  Real step = pi / 2;
  Real before = step * sum;
  for (int halvings = 0; halvings < 16; ++halvings) {
    for (Real psi = -pi / 2 + step / 2; psi < pi / 2; psi += step) sum += across(psi);
    step /= 2;
    const Real now = step * sum;
    const Real change = std::fabs(now - before);
    before = now;
    if (halvings > 1 && change <= 1e-14L * now) {
      const Real force = 2 * spring_modulus * now;
      return {static_cast<double>(force), static_cast<double>(2 * spring_modulus * change + 4e-16L * force)};
    }
  }
  throw std::runtime_error("winkler: no convergence of the inclined force, last change in doubt at inclination " +
                           std::to_string(inclination));
}

double WinklerFingertip::inclined_pressure(double approach, double inclination, double x, double y) const {
  const Real delta = depth(*this, approach), h = tip_radius - delta;
  require_inclination(*this, delta, inclination);
  require_finite("x", x);
  require_finite("y", y);
  const Real R = tip_radius, radial = std::hypot(Real(x), Real(y));
  const Real length = std::sin(Real(inclination)) * x;
  if (!(radial < R) || !(length < h)) return 0;
  const Real g = (h - length) / (std::cos(Real(inclination)) * std::sqrt((R - radial) * (R + radial)));
  return g < 1 ? static_cast<double>(spring_modulus * (1 - g) * g) : 0;
}

}  // namespace patchgrip::contact
