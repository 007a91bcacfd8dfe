// Gauge of a Hertz disc of unit radius without a search: polynomials on both sides of the rim, no libm.
//
// F = |(fx, fy)|, M = |m| per radius. The slip (V along the force, W = a |w|) has the pole x = V / W.
//
//     inside, F <= 4 M:   z = (F/M)^2, x = (F/M) n, from a rational start a Newton step for
//                         1 - x^2 + 3 x^4/8 - n (2 - x^2/2) = 0;   g = (F x + M) / S(x),
//                         S = (3 pi/16)(1 + x^2 - x^4/8)
//     outside:            R = sqrt(F^2 - 16 M^2), p = 2 R/F - 1;   g = F H(p),   1/x = (4 M/F) U(p)
//
// F/M = 4 is the rim: there f = 3 pi/8 * 3/4 is four times m = 9 pi/128. H is smooth in R^2 there (its first odd power
// is R^5), so R^2 may lose its digits. Coefficients: fit/gauge_fit.cc.
#pragma once

#include <cmath>
#include <numbers>

#include <patchgrip/friction/kernels/gauge_coefficients.h>
#include <patchgrip/friction/kernels/pair_polynomial.h>

namespace patchgrip::friction::kernels {

struct HertzLoad {
  double F2;  // F^2
  double M;

  bool pole_inside() const noexcept { return F2 <= 16 * M * M; }
};

struct HertzSlip {
  double gauge;
  double V_per_F;
  double W;
};

namespace detail {

constexpr double hertz_m0 = 3 * std::numbers::pi / 16;

inline double hertz_start(double z) noexcept {
  return horner(hertz_pole_inside_above, z) / horner(hertz_pole_inside_below, z);
}

// h(n) = 1 - x^2 + 3 x^4/8 - n (2 - x^2/2), and dh/dn.
inline double hertz_equation(double n, double x2) noexcept { return 1 - x2 * (1 - 0.375 * x2) - n * (2 - 0.5 * x2); }
inline double hertz_derivative(double n, double x2, double z) noexcept { return z * n * (1.5 * x2 - 2) - 2 + 1.5 * x2; }

// One step makes the gauge exact; the pole takes a second one, its derivative inverted from the first without dividing.
template <bool pole>
double hertz_root(double z) noexcept {
  const double start = hertz_start(z);
  const double x2 = z * start * start;
  const double k = 1 / hertz_derivative(start, x2, z);
  const double n = start - k * hertz_equation(start, x2);
  if constexpr (!pole) return n;
  const double y2 = z * n * n;
  return n - k * (2 - k * hertz_derivative(n, y2, z)) * hertz_equation(n, y2);
}

// (F x + M) / (S / m0) at x = (F/M) n.
inline double hertz_inside(double n, double z, double M) noexcept {
  const double x2 = z * n * n;
  return M * (1 + z * n) / (1 + x2 * (1 - 0.125 * x2));
}

}  // namespace detail

inline double hertz_gauge(const HertzLoad& t) noexcept {
  if (t.pole_inside()) {
    const double z = t.F2 / (t.M * t.M);
    return detail::hertz_inside(detail::hertz_root<false>(z), z, t.M) / detail::hertz_m0;
  }
  const double F = std::sqrt(t.F2), R = std::sqrt(t.F2 - 16 * t.M * t.M);
  return F * polynomial(hertz_gauge_outside, 2 * R / F - 1);
}

inline double safe_hertz_gauge(const HertzLoad& t) noexcept {
  if (t.pole_inside()) {
    constexpr double raised = (1 + hertz_gauge_inside_deficit) / detail::hertz_m0;
    const double z = t.F2 / (t.M * t.M);
    return detail::hertz_inside(detail::hertz_start(z), z, t.M) * raised;
  }
  const double F = std::sqrt(t.F2), R = std::sqrt(t.F2 - 16 * t.M * t.M);
  return F * polynomial(hertz_gauge_outside_safe, 2 * R / F - 1);
}

// With the slip, scaled so that its power F V + M W is the gauge.
inline HertzSlip hertz_slip(const HertzLoad& t) noexcept {
  static constexpr auto outside = paired(hertz_gauge_outside, hertz_pole_outside);
  if (t.pole_inside()) {
    const double z = t.F2 / (t.M * t.M);
    const double n = detail::hertz_root<true>(z);
    const double x2 = z * n * n;
    const double k = 1 / (detail::hertz_m0 * (1 + x2 * (1 - 0.125 * x2)));  // 1 / D of (x, 1)
    return {t.M * (1 + z * n) * k, n * k / t.M, k};
  }
  const double F = std::sqrt(t.F2), R = std::sqrt(t.F2 - 16 * t.M * t.M);
  const double k = 1 / F;
  const Pair g = polynomial(outside, 2 * R * k - 1);
  const double y = t.M * k;
  const double u = 4 * y * g[1];
  const double V = g[0] / (1 + y * u);
  return {F * g[0], V * k, u * V};
}

}  // namespace patchgrip::friction::kernels
