// Kernel of a Hertz or flat-punch disc: polynomials on both sides of the rim, no libm.
//
// Inside, with z = x^2:  Hertz       f/x = (3 pi/8)(1 - z/4),   m = (3 pi/16)(1 - z + 3 z^2/8),   f' = (3 pi/8)(1 - 3
// z/4)
//                        flat punch  f/x = pi/4,                m = (pi/4)(1 - z/2),              f' = pi/4
// Outside: powers of p = ((sqrt 2 + 1) R - V) / ((sqrt 2 - 1) R + V), R = sqrt(V^2 - W^2); see fit/moebius_fit.cc.
// V^2 - W^2 may lose its digits at the rim: f and m are smooth in R^2 there, their first odd power is R^5 (R^3).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <patchgrip/friction/kernels/moebius_coefficients.h>
#include <patchgrip/friction/kernels/pair_polynomial.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction::kernels {

// The derivative of s = f' / u^3 by u is -u (dp/dR / R) ds/dp with dp/dR / R = (sqrt 2 + 1 - (sqrt 2 - 1) p)^3 / (2 sqrt
// 2 (1 + p)). Where s has no first power of R, p = -1 is a root of ds/dp. From the powers of p in s those in -ds/dp / (2
// sqrt 2 (1 + p)), the last two 0.
template <std::size_t N>
constexpr std::array<double, N> bend_of(const std::array<double, N>& s) noexcept {
  std::array<double, N> result{};
  double quotient = 0;
  for (std::size_t k = N - 1; k > 1; --k) {
    quotient = static_cast<double>(k) * s[k] - quotient;
    result[k - 2] = -quotient / (2 * std::numbers::sqrt2);
  }
  return result;
}

struct HertzCoefficients {
  // Powers of z inside.
  static constexpr std::array force_inside{3 * std::numbers::pi / 8, -3 * std::numbers::pi / 32};
  static constexpr std::array moment_inside{3 * std::numbers::pi / 16, -3 * std::numbers::pi / 16,
                                            9 * std::numbers::pi / 128};
  static constexpr std::array slope_inside{3 * std::numbers::pi / 8, -9 * std::numbers::pi / 32};
  static constexpr std::array bend_inside{-9 * std::numbers::pi / 32};
  // Powers of p outside.
  static constexpr const auto& force = hertz_force;
  static constexpr const auto& moment = hertz_moment;
  static constexpr const auto& slope = hertz_slope;
  static constexpr auto bend = bend_of(hertz_slope);
};

struct FlatPunchCoefficients {
  static constexpr std::array force_inside{std::numbers::pi / 4};
  static constexpr std::array moment_inside{std::numbers::pi / 4, -std::numbers::pi / 8};
  static constexpr std::array slope_inside{std::numbers::pi / 4};
  static constexpr std::array bend_inside{0.};
  static constexpr const auto& force = flat_punch_force;
  static constexpr const auto& moment = flat_punch_moment;
  static constexpr const auto& slope = flat_punch_slope;
};

constexpr double moebius_plus = 2.41421356237309504880;   // sqrt 2 + 1
constexpr double moebius_minus = 0.41421356237309504880;  // sqrt 2 - 1

template <class Coefficients>
struct MoebiusKernel {
  static bool pole_inside(const RoundTwist& t) noexcept { return t.V2 <= t.W2; }

  static RoundGradient gradient(const RoundTwist& t) noexcept {
    if (pole_inside(t)) {
      const double k = 1 / t.W;
      const double z = t.V2 * k * k;
      return {k * horner(Coefficients::force_inside, z), horner(Coefficients::moment_inside, z)};
    }
    const double V = std::sqrt(t.V2);
    const double k = 1 / V;
    const Pair g = polynomial(gradient_pairs, variable(t.V2 - t.W2, V));
    return {k * g[0], t.W * k * g[1]};
  }

  // Unlike f and m the slope may have a root of V^2 - W^2 in it: here that must not lose its digits.
  static double slope(const RoundTwist& t) noexcept {
    if (pole_inside(t)) return horner(Coefficients::slope_inside, t.V2 / t.W2);
    const double R2 = std::max(rim_excess(t.vx, t.vy, t.w, t.radius), 0.0);
    return polynomial(Coefficients::slope, variable(R2, std::sqrt(t.V2)));
  }

  // f / x and m are polynomials of so many terms in x^2.
  static constexpr std::size_t inside_terms = Coefficients::moment_inside.size();

  static CurvePoint inside(double x) noexcept {
    const double z = x * x;
    return {x * horner(Coefficients::force_inside, z), horner(Coefficients::moment_inside, z),
            horner(Coefficients::slope_inside, z), 2 * x * horner(Coefficients::bend_inside, z)};
  }

  static CurvePoint outside(double u) noexcept {
    const double p = variable((1 - u) * (1 + u), 1);
    const Pair g = polynomial(gradient_pairs, p);
    if constexpr (requires { Coefficients::bend; }) {
      static constexpr auto slopes = paired(Coefficients::slope, Coefficients::bend);
      const Pair s = polynomial(slopes, p);
      const double c = moebius_plus - moebius_minus * p;
      return {g[0], u * g[1], s[0], u * (c * c * c) * s[1]};
    } else {
      return {g[0], u * g[1], polynomial(Coefficients::slope, p)};
    }
  }

 private:
  static constexpr auto gradient_pairs = paired(Coefficients::force, Coefficients::moment);

  static double variable(double R2, double V) noexcept {
    const double R = std::sqrt(R2);
    return (moebius_plus * R - V) / (moebius_minus * R + V);
  }
};

}  // namespace patchgrip::friction::kernels
