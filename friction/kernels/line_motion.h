// What friction of a uniformly loaded line consists of, without a cancellation at any pole.
//
// The line has the length L and lies along x about the origin, so that its points slide with (u, s), u = vx and
// s = vy + w x from t_0 to t_1. With the speeds q_0, q_1 of its ends, Q = q_0 + q_1 and l = |w| L (times |w| a pole is
// a velocity: Q is the major axis of the ellipse through the pole whose foci are the ends, l their distance),
//
//     x = l / Q,    c^2 = 1 - x^2 = (Q - l)(Q + l) / Q^2                    eccentricity of that ellipse
//     nu = 2 vy / Q,    eta^2 = 1 - nu^2 = 4 kappa / (Q + l)                where the pole lies on it
//     1 - x^2 nu^2 = 4 q_0 q_1 / Q^2
//
//     Q - l = u^2 sum 1 / (q_i + |t_i|) + 2 out,    kappa = u^2 / (Q - l)
//
// out = min |t_i| if all points slide one way across the line, else 0. Three functions of x alone are left,
//
//     A = artanh(x) / x,    alpha = (A - 1) / x^2,    gamma = (1 - c^2 A) / x^2
//
// and every term that patches need is positive (line_load.h). Up to x = 4/5 they follow from, with x = 2 s / (1 + s^2),
//
//     gamma = 2 (1 + s^2) [1/3 - sum_(j >= 1) s^(2j) / ((2j - 1)(2j + 1)(2j + 3))]
//
// and beyond from the logarithm, which then cancels nothing. A pole on the line has A = alpha = infinity.
//
// Domain   every twist but rest.
// Error    a few roundings of each member.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace patchgrip::friction::kernels {

// gamma(x), s^2 = sigma <= 1/4.
template <class Real>
Real line_moment_series(const Real& sigma) {
  constexpr std::size_t terms = std::numeric_limits<Real>::digits / 2 - 6;  // the last is below a quarter^(terms + 6)
  static const std::array<Real, terms> coefficients = [] {
    std::array<Real, terms> c;
    for (std::size_t j = 0; j < c.size(); ++j) {
      const auto odd = static_cast<double>(2 * j + 3);
      c[j] = Real(1) / (odd * (odd * odd - 4));
    }
    return c;
  }();
  Real sum = 0;
  for (std::size_t j = coefficients.size(); j-- > 0;) sum = sum * sigma + coefficients[j];
  return 2 * (1 + sigma) * (Real(1) / 3 - sigma * sum);
}

template <class Real>
struct LineMotion {
  LineMotion(const Real& vx, const Real& vy, const Real& w, const Real& length) {
    using std::abs;
    using std::hypot;
    using std::log;
    using std::log1p;
    using std::sqrt;
    const Real t0 = across(w, -length / 2, vy), t1 = across(w, length / 2, vy);
    const Real s0 = abs(t0), s1 = abs(t1), u = abs(vx);
    const Real q0 = hypot(vx, t0), q1 = hypot(vx, t1);
    const bool turns = (t0 < 0) != (t1 < 0);
    const Real out = turns ? Real(0) : std::min(s0, s1);
    on_line = u == 0 && out == 0;
    Q = q0 + q1;
    const Real l = abs(w) * length;
    // 1 / sum of 1 / (q_i + |t_i|)
    const Real width = (q0 + s0) * ((q1 + s1) / (q0 + s0 + q1 + s1));
    const Real gap = u * (u / width) + 2 * out;
    const Real kappa = out == 0 ? width : u * (u / gap);
    x = l / Q;
    c2 = gap / Q * ((Q + l) / Q);
    nu = 2 * (vy / Q);
    eta2 = 4 * kappa / (Q + l);
    ends = 4 * (q0 / Q) * (q1 / Q);
    const Real x2 = x * x;
    if (5 * x <= 4) {
      const Real s = x / (1 + sqrt(c2));
      gamma = line_moment_series<Real>(s * s);
      A = (1 - x2 * gamma) / c2;
      alpha = (1 - gamma) / c2;
    } else {
      // Where u^2 underflows: log((Q + l) kappa / u^2) / 2.
      const Real tiny = std::numeric_limits<Real>::min() / std::numeric_limits<Real>::epsilon();
      const Real artanh = gap > l * tiny ? Real(log1p(2 * l / gap) / 2) : Real(log(sqrt(Q + l) * sqrt(kappa)) - log(u));
      A = artanh / x;
      alpha = (A - 1) / x2;
      gamma = (1 - (c2 > 0 ? Real(c2 * A) : Real(0))) / x2;
    }
  }

  Real Q;      // [m/s]
  Real x;      // eccentricity
  Real c2;     // 1 - x^2
  Real nu;     // the force across the line
  Real eta2;   // 1 - nu^2
  Real ends;   // 1 - x^2 nu^2; 0 with the pole on an end
  Real A;      // artanh(x) / x
  Real alpha;  // (A - 1) / x^2
  Real gamma;  // (1 - c^2 A) / x^2
  bool on_line;

 private:
  static Real across(const Real& w, const Real& x, const Real& vy) {
    if constexpr (std::is_same_v<Real, double>) {
      return std::fma(w, x, vy);
    } else {
      return vy + w * x;
    }
  }
};

}  // namespace patchgrip::friction::kernels
