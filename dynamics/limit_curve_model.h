// Polynomials in place of one side of a round limit curve: where the return mapping starts (round_return_mapping.h).
//
// g / y and h are smooth in y^2 up to the rim, but for a weak singularity there. With `terms` powers for both the
// equation of the closest point is
//
//     G = y T(y^2),      T = g / y + kappa (H - h)
//
// solved as if T were linear in y between its values at y = 0 and on the rim, and from there by one step of
// Householder's method of third order.
//
// Domain   any G, H and kappa; what is not a number counts as y = 0.
// Error    of y on a Hertz disc: below 4e-6 for nine loads of ten at 1.5 times the limit. None is promised.
// Throws   nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <patchgrip/friction/kernels/chebyshev.h>
#include <patchgrip/friction/kernels/pair_polynomial.h>

namespace patchgrip::dynamics {

template <std::size_t terms>
class LimitCurveModel {
 public:
  // Interpolates `curve`, with curve(y).g and .h for y in (0, 1].
  template <class Curve>
  explicit LimitCurveModel(const Curve& curve) {
    using namespace friction::kernels;
    std::vector<double> g, h;
    for (const double t : chebyshev_points<double>(terms)) {
      const double y = std::sqrt((1 + t) / 2);
      const auto place = curve(y);
      g.push_back(place.g / y);
      h.push_back(place.h);
    }
    std::ranges::copy(in_squares(monomials(chebyshev_series(g))), g_.begin());
    std::ranges::copy(in_squares(monomials(chebyshev_series(h))), h_.begin());
  }

  // y in [0, 1]
  double root(double G, double H, double kappa) const noexcept {
    std::array<double, terms> T;
    for (std::size_t k = 0; k < terms; ++k) T[k] = g_[k] - kappa * h_[k];
    T[0] += kappa * H;
    double rise = 0;  // of T up to the rim
    for (std::size_t k = 1; k < terms; ++k) rise += T[k];
    const double y = unit(2 * G / (T[0] + std::sqrt(std::max(T[0] * T[0] + 4 * rise * G, 0.))));

    // r = y T - G and its three derivatives, the third a sixth, the second a half.
    const double z = y * y;
    double t = 0, first = 0, second = 0, third = 0;
    for (std::size_t k = terms; k-- > 0;) {
      const double n = static_cast<double>(2 * k + 1), twice = n * static_cast<double>(2 * k) / 2;
      t = t * z + T[k];
      first = first * z + n * T[k];
      if (k > 0) second = second * z + twice * T[k];
      if (k > 0) third = third * z + twice * static_cast<double>(2 * k - 1) / 3 * T[k];
    }
    second *= y;
    const double r = y * t - G, s = r * second, q = first * first - s;
    return unit(y - r * q / (first * (q - s) + r * r * third));
  }

 private:
  static double unit(double y) noexcept { return y > 0 ? (y < 1 ? y : 1) : 0; }

  // Powers of t = 2 z - 1 as those of z.
  static std::vector<double> in_squares(const std::vector<double>& powers) {
    std::vector<double> result(powers.size());
    for (std::size_t k = powers.size(); k-- > 0;) {
      for (std::size_t i = powers.size(); i-- > 0;) result[i] = 2 * (i > 0 ? result[i - 1] : 0) - result[i];
      result[0] += powers[k];
    }
    return result;
  }

  std::array<double, terms> g_, h_;  // powers of y^2 in g / y and h
};

}  // namespace patchgrip::dynamics
