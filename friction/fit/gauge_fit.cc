// Writes friction/kernels/gauge_coefficients.h: the gauge of a Hertz disc without a search.
//
// Unit radius, M per radius. With the pole outside (|F| > 4 |M|) y = 4 |M| / |F| and R = sqrt(1 - y^2),
//
//     g = |F| H(p),   u = y U(p),   p = 2 R - 1,
//
// H = 1 / f and U are analytic in R in [0, 1] and beyond; interpolated in 50 digits and cut where the rest is below the
// aim. The safe H is cut at 8e-10 and raised by its largest error.
//
// With the pole inside z = (F / M)^2 <= 16 and x = (F / M) n(z): n is interpolated by a rational function of degree 3
// over 3. g is stationary in n and its greatest there, so what a wrong n gives is too small; `raise` makes up for it.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/friction/kernels/chebyshev.h>
#include <patchgrip/friction/kernels/round_functions.h>

namespace {

using patchgrip::friction::kernels::chebyshev_points;
using patchgrip::friction::kernels::chebyshev_series;
using patchgrip::friction::kernels::monomials;
using patchgrip::friction::kernels::PowerFamily;
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

const PowerFamily<Real> hertz(1);

// Force, moment and -slope of f in u with the pole at 1 / u.
struct Outside {
  explicit Outside(const Real& u) {
    const auto v = hertz.outside(1 - u);
    force = v.force;
    moment = u * v.moment;
    slope = u * v.slope;
  }
  Real force, moment, slope;
};

// Of 4 m(u) = y f(u), by Newton's method; m' = slope / u.
Real outer_root(const Real& y) {
  Real u = 5 * y / (4 + y * y);
  for (int i = 0; i < 12; ++i) {
    const Outside v(u);
    u -= (4 * v.moment - y * v.force) / (4 * v.slope / u + y * v.slope);
    if (u > 1) u = 1;
  }
  return u;
}

std::vector<Real> outer_series(bool pole) {
  std::vector<Real> values;
  for (const Real& p : chebyshev_points<Real>(64)) {
    const Real R = (1 + p) / 2;
    const Real y = sqrt((1 - R) * (1 + R));
    const Real u = outer_root(y);
    values.push_back(pole ? u / y : 1 / Outside(u).force);
  }
  return chebyshev_series(values);
}

std::vector<Real> cut(std::vector<Real> series, double truncation) {
  Real rest = 0;
  while (rest + abs(series.back()) < truncation) {
    rest += abs(series.back());
    series.pop_back();
  }
  return monomials(series);
}

Real polynomial(const std::vector<Real>& c, const Real& t) {
  Real sum = 0;
  for (std::size_t k = c.size(); k-- > 0;) sum = sum * t + c[k];
  return sum;
}

constexpr int scan = 4000;

// Largest relative error of `c` as H, over u.
Real outer_error(const std::vector<Real>& c) {
  Real worst = 0;
  for (int i = 0; i <= scan; ++i) {
    const Real u = Real(i) / scan;
    const Outside v(u);
    const Real y = std::min<Real>(4 * v.moment / v.force, 1);
    worst = std::max<Real>(worst, abs(polynomial(c, 2 * sqrt(1 - y * y) - 1) * v.force - 1));
  }
  return worst;
}

// x / q at f(x) = q m(x), with the inner functions 2 x - x^3 / 2 and 1 - x^2 + 3 x^4 / 8 (times 3 pi / 16).
Real inner_root(const Real& q) {
  Real x = q / (2 + q * q / 8);
  for (int i = 0; i < 12; ++i) {
    const Real x2 = x * x;
    x -= (q * (1 - x2 + 3 * x2 * x2 / 8) - 2 * x + x * x2 / 2) / (q * x * (3 * x2 / 2 - 2) - 2 + 3 * x2 / 2);
  }
  return x / q;
}

// S at the pole x^2, times 16 / (3 pi).
Real inner_S(const Real& x2) { return 1 + x2 - x2 * x2 / 8; }

struct Rational {
  std::vector<Real> above, below;  // powers of z; below[0] = 1
  Real operator()(const Real& z) const { return polynomial(above, z) / polynomial(below, z); }
};

// Through the images of seven Chebyshev points under t -> z, which crowd towards z = 0 the more the larger `e`.
Rational inner_rational(const Real& e) {
  constexpr std::size_t degree = 3, n = 2 * degree + 1;
  std::vector<std::vector<Real>> rows;
  for (const Real& t : chebyshev_points<Real>(n)) {
    const Real z = 16 * (1 + t) / (2 + e * (1 - t));
    const Real value = inner_root(sqrt(z));
    std::vector<Real> row;
    Real power = 1;
    for (std::size_t k = 0; k <= degree; ++k, power *= z) row.push_back(power);
    power = z;
    for (std::size_t k = 1; k <= degree; ++k, power *= z) row.push_back(-value * power);
    row.push_back(value);
    rows.push_back(row);
  }
  for (std::size_t i = 0; i < n; ++i) {  // Gauss-Jordan with pivots
    std::size_t pivot = i;
    for (std::size_t k = i; k < n; ++k) pivot = abs(rows[k][i]) > abs(rows[pivot][i]) ? k : pivot;
    std::swap(rows[i], rows[pivot]);
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const Real factor = rows[k][i] / rows[i][i];
      for (std::size_t j = i; j <= n; ++j) rows[k][j] -= factor * rows[i][j];
    }
  }
  Rational r{{}, {1}};
  for (std::size_t i = 0; i < n; ++i) (i <= degree ? r.above : r.below).push_back(rows[i][n] / rows[i][i]);
  return r;
}

// Largest relative deficit of the gauge (q x + 1) / S(x) at x = q n.
Real inner_error(const Rational& n, int points) {
  Real worst = 0;
  for (int i = 1; i <= points; ++i) {
    const Real q = Real(4 * i) / points;
    const Real exact = q * inner_root(q), x = q * n(q * q);
    worst = std::max<Real>(worst, 1 - (q * x + 1) * inner_S(exact * exact) / ((q * exact + 1) * inner_S(x * x)));
  }
  return worst;
}

Rational best_inner_rational() {
  std::pair<Real, int> best{1, 0};
  for (int e = 0; e <= 160; ++e) {
    best = std::min(best, std::pair{inner_error(inner_rational(Real(e) / 8), 200), e});
  }
  return inner_rational(Real(best.second) / 8);
}

void print(const std::string& name, const std::vector<Real>& coefficients, std::size_t terms) {
  std::printf("\ninline constexpr std::array<double, %zu> %s = {\n", terms, name.c_str());
  for (std::size_t k = 0; k < terms; ++k) {
    const Real c = k < coefficients.size() ? coefficients[k] : Real(0);
    std::printf("    %s,\n", c.str(19, std::ios_base::scientific).c_str());
  }
  std::printf("};\n");
}

void print(const std::string& name, const Real& value) {
  std::printf("\ninline constexpr double %s = %s;\n", name.c_str(), value.str(4, std::ios_base::scientific).c_str());
}

}  // namespace

int main() {
  std::printf(
      "// Written by friction/fit/gauge_fit.cc; a test compares. Gauge of a Hertz disc: powers of p outside, of z "
      "inside.\n"
      "#pragma once\n\n#include <array>\n\n"
      "namespace patchgrip::friction::kernels {\n\n// clang-format off\n");
  const std::vector<Real> series = outer_series(false);
  const std::vector<Real> gauge = cut(series, 4e-17), pole = cut(outer_series(true), 4e-16);
  const std::size_t terms = std::max(gauge.size(), pole.size());  // evaluated together
  print("hertz_gauge_outside", gauge, terms);
  print("hertz_pole_outside", pole, terms);
  std::vector<Real> safe = cut(series, 8e-10);
  const Real error = outer_error(safe);
  for (Real& c : safe) c *= 1 + Real(1.001) * error;
  print("hertz_gauge_outside_safe", safe, safe.size());
  print("hertz_gauge_outside_excess", Real(2.1) * error);
  const Rational n = best_inner_rational();
  print("hertz_pole_inside_above", n.above, n.above.size());
  print("hertz_pole_inside_below", n.below, n.below.size());
  print("hertz_gauge_inside_deficit", Real(1.001) * inner_error(n, scan));
  std::printf("\n}  // namespace patchgrip::friction::kernels\n");
}
