// Shape of a Hertz ellipse: the ratio of its semi-axes from the ratio of the relative radii of curvature.
//
//     R_small / R_large = RD(0, k^2, 1) / RD(0, 1, k^2) = k^2 D / B,   k = b / a      (seed 4.1.3; Johnson 4.26)
//
// D and B as in complete_elliptic.h; a lies along the direction of R_large. Solved by Newton's method in ln k; closer
// to the circle than R_small = R_large / 2 in ln(1 - k), from
//
//     1 - R_small / R_large = e^2 (1/2 - (1 + k^2) T) / (1/2 - e^2 T),   1 - k = (2/3) (1 - R_small / R_large) + ...
//
// so that the eccentricity of a nearly circular zone keeps every digit. Wider types start from the double solution.
//
// The seed's factors, and those of its figure 4.11 (what the rotational formulas with one radius R get wrong at equal
// approach), follow without 0/0 as well:
//
//     F_1 = ((4/pi) sqrt(k B D))^(1/3),   F_2 = (2/pi) sqrt(k) K / F_1
//     f_a = sqrt(2 D R_large / (K R)),   f_b = k f_a,   f_p = pi / (2 K f_b),   f_FN = pi f_a / (2 K)
//
// Domain   1e-30 <= R_small / R_large <= 1: 1 a circle, below a line contact, which has no approach of its own.
// Units    all [1].
// Error    in long double <= 2^-3 units of 2^-53, relative, each of k, 1 - k, e, K, B, D;
//          tests/contact/ellipse_shape_test.cc.
// Throws   std::invalid_argument outside the domain; std::runtime_error, with the residual, should Newton not converge.
#pragma once

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <patchgrip/contact/complete_elliptic.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {

// What an ellipse is to the circle of one radius R at the same approach (seed figure 4.11).
template <class T>
struct FactorsToCircle {
  T pressure;  // f_p
  T force;     // f_FN
  T a, b;      // f_a, f_b
};

template <class T>
struct EllipseShape {
  static constexpr double smallest_ratio = 1e-30;

  static EllipseShape of_ratio(const T& ratio) {  // R_small / R_large
    return of(ratio, 1 - ratio);
  }
  static EllipseShape of_one_minus_ratio(const T& one_minus_ratio) { return of(1 - one_minus_ratio, one_minus_ratio); }
  // Both, where both are known better than one from the other.
  static EllipseShape of(const T& ratio, const T& one_minus_ratio);

  T seed_F1() const {
    using std::cbrt;
    using std::sqrt;
    return cbrt(4 / boost::math::constants::pi<T>() * sqrt(k * integrals.B * integrals.D));
  }
  T seed_F2() const {
    using std::sqrt;
    return 2 / boost::math::constants::pi<T>() * sqrt(k) * integrals.K / seed_F1();
  }

  FactorsToCircle<T> against_large_radius() const { return factors(T(1)); }
  FactorsToCircle<T> against_small_radius() const { return factors(1 / ratio); }

  T ratio;                        // R_small / R_large
  T k;                            // b / a, in (0, 1]
  T one_minus_k;                  // 1 - b / a
  T eccentricity;                 // e = sqrt(1 - k^2)
  CompleteElliptic<T> integrals;  // at this k

 private:
  struct Trial {
    CompleteElliptic<T> integrals;
    T residual;  // ln of what the trial gives over what is asked
    T slope;     // its derivative with respect to the logarithm solved for
  };
  static Trial trial(const T& k, const T& x, const T& ratio, const T& one_minus_ratio);
  static T guess(double ratio);  // of k

  FactorsToCircle<T> factors(const T& large_over_reference) const {
    using std::sqrt;
    const T fa = sqrt(2 * integrals.D / integrals.K * large_over_reference);
    const T quarter = boost::math::constants::half_pi<T>() / integrals.K;
    return {quarter / (k * fa), quarter * fa, fa, k * fa};
  }
};

template <class T>
typename EllipseShape<T>::Trial EllipseShape<T>::trial(const T& k, const T& x, const T& ratio,
                                                       const T& one_minus_ratio) {
  using std::log;
  const auto c = CompleteElliptic<T>::of_axes(k, x);
  const T e2 = x * (1 + k);
  const T b = T(1) / 2 - e2 * c.excess;                    // B / K
  const T d = T(1) / 2 + e2 * c.excess;                    // D / K
  const T gap = T(1) / 2 - (1 + k * k) * c.excess;         // (B - k^2 D) / (K e^2)
  const T slope = 2 - gap / d + 2 * k * k * c.excess / b;  // d ln(ratio) / d ln k
  if (one_minus_ratio > T(1) / 2) return {c, log(k * k * d / (b * ratio)), slope};
  const T given = e2 * gap / b;
  return {c, log(given / one_minus_ratio), x * k * d / (b * given) * slope};
}

// k ~ ratio^(2/3) near the circle, ratio ~ k^2 (ln(4/k) - 1) near the line.
template <class T>
T EllipseShape<T>::guess(double ratio) {
  if (ratio > 0.03) return T(std::cbrt(ratio * ratio));
  double k = std::sqrt(ratio);
  for (int i = 0; i < 3; ++i) k = std::sqrt(ratio / (std::log(4 / k) - 1));
  return T(k);
}

template <class T>
EllipseShape<T> EllipseShape<T>::of(const T& ratio, const T& one_minus_ratio) {
  using std::abs;
  using std::exp;
  using std::pow;
  using std::sqrt;
  require_in("radius_ratio", static_cast<double>(ratio), smallest_ratio, 1);
  require_in("one_minus_radius_ratio", static_cast<double>(one_minus_ratio), 0, 1);
  if (one_minus_ratio == 0) return {T(1), T(1), T(0), T(0), CompleteElliptic<T>::of_axes(T(1), T(0))};

  const bool round = !(one_minus_ratio > T(1) / 2);
  T k, x;
  if constexpr (std::is_same_v<T, double>) {
    k = guess(ratio);
    x = round ? 2 * one_minus_ratio / 3 : 1 - k;
  } else {
    const auto start = EllipseShape<double>::of(static_cast<double>(ratio), static_cast<double>(one_minus_ratio));
    k = T(start.k);
    x = T(start.one_minus_k);
  }
  if (round) {
    k = 1 - x;
  } else {
    x = 1 - k;
  }

  // A step squares the error: below this one, what is left is rounding.
  const T converged = pow(std::numeric_limits<T>::epsilon(), T(0.6));
  for (int steps = 0;; ++steps) {
    const Trial t = trial(k, x, ratio, one_minus_ratio);
    const T step = t.residual / t.slope;
    if (round) {
      x *= exp(-step);
      k = 1 - x;
    } else {
      k *= exp(-step);
      x = 1 - k;
    }
    if (abs(step) < converged) break;
    if (steps == 20)
      throw std::runtime_error("ellipse_shape: no convergence, residual " +
                               std::to_string(static_cast<double>(t.residual)));
  }
  return {ratio, k, x, sqrt(x * (1 + k)), CompleteElliptic<T>::of_axes(k, x)};
}

}  // namespace patchgrip::contact
