// Chebyshev interpolation, and Chebyshev series as powers. Used when tables and fits are made, never at a pole.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <boost/math/constants/constants.hpp>

namespace patchgrip::friction::kernels {

// Coefficients of 1, t, t^2, ... from those of T_0, T_1, T_2, ...
template <class Real>
std::vector<Real> monomials(const std::vector<Real>& chebyshev) {
  const std::size_t n = chebyshev.size();
  std::vector<Real> result(n), current(n + 1), next(n + 1);
  current[0] = 1;
  next[1] = 1;
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i <= j; ++i) result[i] += chebyshev[j] * current[i];
    std::vector<Real> after(n + 1);
    for (std::size_t i = 0; i < n; ++i) after[i + 1] = 2 * next[i];
    for (std::size_t i = 0; i < n; ++i) after[i] -= current[i];
    current = std::exchange(next, after);
  }
  return result;
}

// The n zeros of T_n.
template <class Real>
std::vector<Real> chebyshev_points(std::size_t n) {
  using std::cos;
  const Real& pi = boost::math::constants::pi<Real>();
  std::vector<Real> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back(cos(pi * Real(2 * i + 1) / Real(2 * n)));
  return points;
}

// Coefficients of T_0, T_1, ... from the values in those points.
template <class Real>
std::vector<Real> chebyshev_series(const std::vector<Real>& values) {
  using std::cos;
  const Real& pi = boost::math::constants::pi<Real>();
  const std::size_t n = values.size();
  std::vector<Real> series(n);
  for (std::size_t j = 0; j < n; ++j) {
    for (std::size_t i = 0; i < n; ++i) series[j] += values[i] * cos(pi * Real(j * (2 * i + 1)) / Real(2 * n));
    series[j] *= Real(j == 0 ? 1 : 2) / Real(n);
  }
  return series;
}

}  // namespace patchgrip::friction::kernels
