// The Gauss hypergeometric function on [0, 1], to the rounding of the scalar type, by Taylor continuation.
//
//     y = 2F1(a, b; c; z),   z (1 - z) y'' + [c - (a + b + 1) z] y' - a b y = 0          (DLMF 15.10.1)
//
// From the power series at z = 0.625 the equation itself is stepped towards z = 1: about w_0 = 1 - z_0 the coefficients
// u_k of y = sum u_k s^k, s = 1 - w / w_0, obey a three-term recurrence, and the series converges for |s| < 1. Centres
// at w_0 = (3/4) 2^-j give |s| <= 1/3 for every w in [2^-(j+1), 2^-j]. No case distinction for integer c - a - b, where
// the connection formulas to 1 - z break down and their neighbours cancel.
//
// Domain   c > 0, c - a - b > -1, b > 0, a > -24; w = 1 - z in [0, 1]. Below 2^-(levels+1) the last series is used up
//          to its circle of convergence: what is singular at z = 1 is then off by about its own size there.
// Error    about 10 units of rounding of Real, growing to some 1e3 for a near -21: Real carries the guard digits.
//          Measured in tests/friction/hypergeometric_test.cc against elementary cases and 50 digits.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace patchgrip::friction::kernels {

template <class Real>
class Hypergeometric {
 public:
  Hypergeometric(Real a, Real b, Real c, int levels) : a_(a), b_(b), c_(c) {
    Real w = Real(3) / 8;
    Real value = power_series(a, b, c, 1 - w);
    Real slope = -a * b / c * power_series(a + 1, b + 1, c + 1, 1 - w);  // dy/dw
    for (int j = 1; j <= levels; ++j, w /= 2) {
      series_.push_back(taylor(w, value, slope));
      const std::vector<Real>& u = series_.back();
      // The next centre lies at s = 1/2; dy/dw = -(dy/ds) / w_0.
      value = 0;
      Real derivative = 0;
      for (auto k = u.size(); k-- > 0;) {
        derivative = derivative / 2 + value;
        value = value / 2 + u[k];
      }
      slope = -derivative / w;
    }
  }

  // y at z = 1 - w.
  Real at_complement(const Real& w) const {
    using std::frexp;
    if (2 * w >= 1) return power_series(a_, b_, c_, 1 - w);
    int exponent = 0;
    frexp(w, &exponent);  // w in [2^(exponent-1), 2^exponent)
    const std::size_t level =
        (w > 0 ? std::min(static_cast<std::size_t>(-exponent), series_.size()) : series_.size()) - 1;
    const Real s = 1 - w / centre(static_cast<int>(level) + 1);
    const std::vector<Real>& u = series_[level];
    Real y = 0;
    for (auto k = u.size(); k-- > 0;) y = y * s + u[k];
    return y;
  }

 private:
  static Real centre(int level) {
    using std::ldexp;
    return ldexp(Real(3) / 4, -level);
  }

  static Real power_series(const Real& a, const Real& b, const Real& c, const Real& z) {
    using std::abs;
    using std::pow;
    // For a < -1 the terms alternate and cancel; Euler's transformation (DLMF 15.8.1) makes all of them positive.
    if (a < -1) return pow(1 - z, c - a - b) * power_series(c - a, c - b, c, z);
    Real term = 1;
    Real sum = 1;
    for (int k = 0; k < 20000; ++k) {
      term *= (a + k) * (b + k) / ((c + k) * Real(k + 1)) * z;
      sum += term;
      if (abs(term) < abs(sum) * std::numeric_limits<Real>::epsilon() / 16) break;
    }
    return sum;
  }

  // Coefficients in s = 1 - w / w_0 from the value and slope at w_0, until the terms at s = 1/2 are below rounding.
  std::vector<Real> taylor(const Real& w0, const Real& value, const Real& slope) const {
    const int terms = 3 * std::numeric_limits<Real>::digits / 2 + 12;
    const Real z0 = 1 - w0;
    std::vector<Real> u{value, -slope * w0};
    for (int k = 0; k + 2 < terms; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Real first = ((2 * w0 - 1) * k + c_ - (a_ + b_ + 1) * z0) * Real(k + 1) * u[i + 1];
      const Real second = (a_ + k) * (b_ + k) * w0 * u[i];
      u.push_back((second - first) / (z0 * Real((k + 1) * (k + 2))));
    }
    return u;
  }

  Real a_, b_, c_;
  std::vector<std::vector<Real>> series_;
};

}  // namespace patchgrip::friction::kernels
