// Stribeck's excess as a mean of plane waves: what makes local friction an integral over projections of the pressure.
//
// In units of the Stribeck velocity the excess of friction at a point, exp(-u^2) along its velocity u, is the mean over
// all directions n(phi) of waves that see the component u . n alone:
//
//     exp(-u^2) u / |u| = (1 / 2 pi) int_0^(2 pi) n g(u . n) dphi
//     g(t) = (pi / 2) sgn(t) exp(-z) [I_0(z) - 2 z (I_0(z) - I_1(z))],   z = t^2 / 2
//
// g is the slope of (pi / 2) |t| exp(-z) I_0(z), whose mean over the directions is the error function (term by term:
// the mean of |cos|^(2j+1) is (2/pi) (2j)!!/(2j+1)!!). g(0+) = pi / 2, which alone gives Coulomb's u / |u|, and far
// away g ~ -sqrt(pi) / (4 t^3).
//
// Up to t = 8 a table of polynomials, made once from the Bessel functions; beyond it the series in 1 / t.
//
// Error    <= 4 units of 2^-53 of pi/2; tests/friction/stribeck_wave_test.cc.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <boost/math/special_functions/bessel.hpp>

#include <patchgrip/friction/kernels/chebyshev.h>

namespace patchgrip::friction::kernels {

// From the definition, t >= 0; in double it loses z units.
template <class Real>
Real stribeck_wave_by_definition(const Real& t) {
  using std::exp;
  const Real z = t * t / 2;
  const Real I0 = boost::math::cyl_bessel_i(0, z), I1 = boost::math::cyl_bessel_i(1, z);
  return boost::math::constants::half_pi<Real>() * exp(-z) * (I0 - 2 * z * (I0 - I1));
}

class StribeckWave {
 public:
  static const StribeckWave& shared() {
    static const StribeckWave wave;
    return wave;
  }

  // g(t)
  double operator()(double t) const noexcept {
    const double size = std::fabs(t);
    if (size == 0) return 0;
    const double g = size < far ? near_value(size) : far_value(size);
    return t < 0 ? -g : g;
  }

 private:
  static constexpr double far = 8;
  static constexpr int per_unit = 8;
  static constexpr std::size_t terms = 10;

  StribeckWave() {
    const auto points = chebyshev_points<long double>(terms);
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      std::vector<long double> values;
      for (const long double x : points) {
        values.push_back(stribeck_wave_by_definition((row + (1 + x) / 2) / per_unit));
      }
      const auto powers = monomials(chebyshev_series(values));
      for (std::size_t k = 0; k < terms; ++k) rows_[row][k] = static_cast<double>(powers[k]);
    }
  }

  double near_value(double t) const noexcept {
    const double place = t * per_unit;
    const auto row = static_cast<std::size_t>(place);
    const double x = 2 * (place - static_cast<double>(row)) - 1;
    double g = rows_[row][terms - 1];
    for (std::size_t k = terms - 1; k-- > 0;) g = g * x + rows_[row][k];
    return g;
  }

  // -(sqrt(pi) / 2) sum of 2 j a_j / t^(2j+1),  a_j = a_(j-1) (2j-1)^2 / (4 j): the 20th term is below rounding.
  static double far_value(double t) noexcept {
    const double u2 = 1 / (t * t);
    double a = 1, sum = 0;
    for (int j = 1; j <= 20; ++j) {
      a *= (2 * j - 1) * (2 * j - 1) * u2 / (4 * j);
      sum += 2 * j * a;
    }
    return -sum / (2 * std::numbers::inv_sqrtpi * t);
  }

  std::array<std::array<double, terms>, static_cast<std::size_t>(far) * per_unit> rows_;
};

}  // namespace patchgrip::friction::kernels
