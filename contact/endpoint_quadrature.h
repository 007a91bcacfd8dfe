// Integral of a function that is smooth inside and may be singular, or nearly so, at either end.
//
// Double-exponential (tanh-sinh) quadrature (Takahasi and Mori 1974): with x = tanh((pi/2) sinh t) on [-1, 1] the
// trapezoidal rule in t converges fast, and nodes crowd at the ends. The integrand is told its distance from both
// without cancellation. The scalar decides the number of digits.
//
// Domain   at an end no worse than the inverse of a root.
// Error    the step is halved, which doubles the digits, until three results agree in two thirds of the digits: mostly
//          below 8, at most 64 units of rounding of int |f|, for f accurate to rounding. (Two may meet by chance: with
//          a pole next to an end the error swings as it falls.) The bound that comes along is the last difference and
//          16 such units. For what is not smooth inside results never agree so well; then it is 16 times the last
//          difference, a fair guess and no proof.
// Throws   std::runtime_error where f is not finite.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <vector>

#include <boost/math/constants/constants.hpp>

#include <patchgrip/contact/estimate.h>

namespace patchgrip::contact {

template <class Real>
struct EndpointNode {
  Real distance;  // 1 - x, of x > 0
  Real weight;    // dx / dt
};

constexpr int endpoint_levels = 13;

// The nodes t > 0 that the step 2^-level adds, down to a distance of the fourth power of a rounding from the end.
// Shared by threads.
template <class Real>
const std::vector<EndpointNode<Real>>& endpoint_nodes(int level) {
  using std::cosh;
  using std::exp;
  using std::ldexp;
  using std::sinh;
  static std::array<std::once_flag, endpoint_levels> made;
  static std::array<std::vector<EndpointNode<Real>>, endpoint_levels> nodes;
  const auto k = static_cast<std::size_t>(level);
  std::call_once(made[k], [&] {
    const Real pi = boost::math::constants::pi<Real>();
    const Real step = ldexp(Real(1), -level);
    const Real eps = std::numeric_limits<Real>::epsilon();
    for (int i = 1;; i += level == 0 ? 1 : 2) {
      const Real t = i * step;
      const Real distance = 2 / (1 + exp(pi * sinh(t)));
      if (distance < eps * eps * eps * eps) return;
      nodes[k].push_back({distance, pi / 2 * cosh(t) * distance * (2 - distance)});
    }
  });
  return nodes[k];
}

// f(x - lo, hi - x)
template <class Real, class Integrand>
BasicEstimate<Real> bounded_integral(const Integrand& f, const Real& lo, const Real& hi) {
  using std::abs;
  using std::pow;
  const Real half = (hi - lo) / 2;
  if (!(half > 0)) return {0, 0};
  const Real eps = std::numeric_limits<Real>::epsilon();
  const Real agreement = pow(eps, Real(2) / 3);
  const Real middle = f(half, half);
  Real value = boost::math::constants::half_pi<Real>() * middle;  // sums over all nodes, times the step
  Real absolute = abs(value);
  Real difference = 0;
  int rises = 0;
  for (int level = 0; level < endpoint_levels; ++level) {
    Real sum = 0;
    Real size = level == 0 ? absolute : Real(0);
    for (const auto& [distance, weight] : endpoint_nodes<Real>(level)) {
      const Real left = f(Real(distance * half), Real((2 - distance) * half));
      const Real right = f(Real((2 - distance) * half), Real(distance * half));
      sum += weight * (left + right);
      size += weight * (abs(left) + abs(right));
    }
    if (!(size <= std::numeric_limits<Real>::max())) throw std::runtime_error("integrand is not finite");
    if (level == 0) {
      value += sum;
      absolute = size;
      continue;
    }
    const Real step = 1 / Real(1 << level);
    const Real next = value / 2 + step * sum;
    const Real before = difference;
    difference = abs(next - value);
    // Rounding, or what is not smooth, has taken over.
    if (level > 4 && difference > before && ++rises > 1) {
      difference = before;
      break;
    }
    value = next;
    absolute = absolute / 2 + step * size;
    if (level > 2 && difference <= agreement * absolute && before <= agreement * absolute) break;
  }
  if (difference > agreement * absolute) difference *= 16;
  return {half * value, half * (difference + 8 * eps * absolute)};
}

template <class Real, class Integrand>
Real integrate_to_both_ends(const Integrand& f, const Real& lo, const Real& hi) {
  return bounded_integral(f, lo, hi).value;
}

}  // namespace patchgrip::contact
