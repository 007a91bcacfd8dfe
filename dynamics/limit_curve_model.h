// Polynomials in place of one side of a round limit curve: where the return mapping starts (round_return_mapping.h).
//
// g / y and h are smooth in y^2 up to the rim, but for a weak singularity there. With `terms` powers for both the
// equation of the closest point is
//
//     G = y T(y^2),      T = g / y + kappa (H - h)
//
// solved as if T were linear in y from y = 0 to the rim, and from there by one step of Halley's method.
//
// Domain   any G, H and kappa; what is not a number counts as y = 0.
// Units    none: pure numbers, per L and a, as round_return_mapping.h has them.
// Error    none is promised. Of y on a Hertz disc: 1e-6 in the median. tests/dynamics/limit_curve_model_test.cc.
// Throws   nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
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
    g_rise_ = std::accumulate(g_.begin() + 1, g_.end(), 0.);
    h_rise_ = std::accumulate(h_.begin() + 1, h_.end(), 0.);
  }

  // y in [0, 1]
  double root(double G, double H, double kappa) const noexcept {
    using friction::kernels::Pair;
    std::array<Pair, terms> T;            // of T and r' = (y T)'
    std::array<double, terms - 1> bends;  // of r'' / 2 y
    for (std::size_t k = 0; k < terms; ++k) {
      const double t = g_[k] - kappa * h_[k] + (k == 0 ? kappa * H : 0), n = static_cast<double>(2 * k + 1);
      T[k] = Pair{t, t} * Pair{1, n};
      if (k > 0) bends[k - 1] = n * static_cast<double>(k) * t;
    }
    const double rise = g_rise_ - kappa * h_rise_, centre = T[0][0];
    const double y = 2 * G / (centre + std::sqrt(std::max(centre * centre + 4 * rise * G, 0.)));
    const double z = y * y;
    const Pair p = friction::kernels::polynomial(T, z);
    const double r = y * p[0] - G, slope = p[1];
    return unit(y - r * slope / (slope * slope - r * y * friction::kernels::polynomial(bends, z)));
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
  double g_rise_, h_rise_;           // up to the rim
};

}  // namespace patchgrip::dynamics
