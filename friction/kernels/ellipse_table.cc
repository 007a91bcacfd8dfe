#include <patchgrip/friction/kernels/ellipse_table.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <patchgrip/friction/kernels/chebyshev.h>

namespace patchgrip::friction::kernels {
namespace {

using Real = long double;
using Integrals = EllipseIntegrals<Real>;

std::size_t index(int k) { return static_cast<std::size_t>(k); }

constexpr std::size_t n = EllipseTable::terms;

// Chebyshev series of the function that is 1 in one of the points and 0 in the others.
const std::vector<std::vector<Real>>& series_of_points() {
  static const std::vector<std::vector<Real>> all = [] {
    std::vector<std::vector<Real>> result;
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<Real> values(n);
      values[i] = 1;
      result.push_back(chebyshev_series(values));
    }
    return result;
  }();
  return all;
}

// lambda(t), t in [-1, 1], onto a row.
template <class Lambda>
EllipseTable::Row make_row(Real b2, const Lambda& lambda) {
  static const std::vector<Real> points = chebyshev_points<Real>(n);
  const auto& basis = series_of_points();
  std::vector<Integrals> values;
  for (const Real t : points) values.push_back(ellipse_integrals(lambda(t), b2));
  const auto coefficients = [&](auto member) {
    std::vector<Real> series(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) series[j] += values[i].*member * basis[i][j];
    }
    return monomials(series);
  };
  const auto pair = [&](auto first, auto second) {
    const std::vector<Real> p = coefficients(first), q = coefficients(second);
    std::array<Pair, n> result;
    for (std::size_t i = 0; i < n; ++i) result[i] = Pair{static_cast<double>(p[i]), static_cast<double>(q[i])};
    return result;
  };
  return {pair(&Integrals::u_major, &Integrals::u_mixed), pair(&Integrals::u_minor, &Integrals::m_pure),
          pair(&Integrals::m_mixed, &Integrals::h_pure), pair(&Integrals::h_cross, &Integrals::h_mixed)};
}

}  // namespace

EllipseTable::EllipseTable(long double b2) : last_(1) {
  while (std::ldexp(1.0L, 2 - 2 * last_) > b2) ++last_;  // 2^-last_ <= b / 2
  for (int k = 0; k < last_; ++k) {
    rows_.push_back(make_row(b2, [k](Real t) {
      const Real l = std::ldexp((t + 3) / 4, -k);
      return l * l;
    }));
  }
  rows_.push_back(make_row(b2, [this](Real t) {
    const Real l = std::ldexp((t + 1) / 2, -last_);
    return l * l;
  }));
  rows_.push_back(make_row(b2, [](Real t) { return 2 / (t + 1); }));
}

EllipseTable::Place EllipseTable::find(double Lambda, double W2) const noexcept {
  if (Lambda >= W2) return {rows_[index(last_ + 1)], 2 * (W2 / Lambda) - 1};
  const double lambda = Lambda / W2;
  const double l = std::sqrt(lambda);
  const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(l) >> 52) - 1023;
  const int k = std::clamp(-1 - exponent, 0, last_);
  const bool rim = k == last_;
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k + (rim ? 1 : 2)) << 52);
  return {rows_[index(k)], scale * l - (rim ? 1 : 3)};
}

}  // namespace patchgrip::friction::kernels
