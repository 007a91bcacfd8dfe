// Writes friction/kernels/moebius_coefficients.h: the wrench of a Hertz and a flat-punch disc outside the rim, without
// libm.
//
// In s = sqrt(1 - u^2), u = a / r_M, the functions f, m/u and f'/u^3 of round_functions.h are analytic but for a cut
// along s <= -1 (n = 0 and n = 1). The Moebius variable
//
//     p = ((sqrt 2 + 1) s - 1) / ((sqrt 2 - 1) s + 1)
//
// maps rim to infinity, s in [0, 1], onto [-1, 1] and the cut onto |p| >= 3 + 2 sqrt 2, so the Chebyshev coefficients
// fall like 11.6^-k. They are interpolated in 50 digits and cut where the rest is below 3e-17.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <patchgrip/friction/kernels/chebyshev.h>
#include <patchgrip/friction/kernels/round_functions.h>

namespace {

using patchgrip::friction::kernels::chebyshev_points;
using patchgrip::friction::kernels::chebyshev_series;
using patchgrip::friction::kernels::monomials;
using patchgrip::friction::kernels::PowerFamily;
using patchgrip::friction::kernels::RoundValues;
using Real = boost::multiprecision::cpp_bin_float_50;

constexpr double truncation = 3e-17;

std::vector<Real> fit(const PowerFamily<Real>& family, Real RoundValues<Real>::*member) {
  const Real root2 = sqrt(Real(2));
  std::vector<Real> values;
  for (const Real& p : chebyshev_points<Real>(56)) {
    const Real s = (1 + p) / ((root2 + 1) - (root2 - 1) * p);
    const Real d = s * s / (1 + sqrt(1 - s * s));  // 1 - u, from s^2 = d (2 - d)
    values.push_back(family.outside(d).*member);
  }
  std::vector<Real> series = chebyshev_series(values);
  Real rest = 0;
  while (rest + abs(series.back()) < truncation) {
    rest += abs(series.back());
    series.pop_back();
  }
  return monomials(series);
}

void print(const std::string& name, const std::vector<Real>& coefficients, std::size_t terms) {
  std::printf("\ninline constexpr std::array<double, %zu> %s = {\n", terms, name.c_str());
  for (std::size_t k = 0; k < terms; ++k) {
    const Real c = k < coefficients.size() ? coefficients[k] : Real(0);
    std::printf("    %s,\n", c.str(19, std::ios_base::scientific).c_str());
  }
  std::printf("};\n");
}

void print_disc(const std::string& name, double n) {
  const PowerFamily<Real> family(n);
  const std::vector<Real> force = fit(family, &RoundValues<Real>::force);
  const std::vector<Real> moment = fit(family, &RoundValues<Real>::moment);
  const std::vector<Real> slope = fit(family, &RoundValues<Real>::slope);
  const std::size_t terms = std::max(force.size(), moment.size());  // evaluated together
  print(name + "_force", force, terms);
  print(name + "_moment", moment, terms);
  print(name + "_slope", slope, slope.size());
}

}  // namespace

int main() {
  std::printf(
      "// Written by friction/fit/moebius_fit.cc; a test compares. Powers of p: {f, m / u} and f' / u^3, outside the "
      "rim.\n"
      "#pragma once\n\n#include <array>\n\n"
      "namespace patchgrip::friction::kernels {\n\n// clang-format off\n");
  print_disc("hertz", 1);
  print_disc("flat_punch", 0);
  std::printf("\n}  // namespace patchgrip::friction::kernels\n");
}
