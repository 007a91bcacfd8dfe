#include <patchgrip/friction/kernels/hypergeometric.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction::kernels {
namespace {

constexpr int levels = 72;

// w = 1 - z over all levels: on their borders, next to them and between.
std::vector<double> complements() {
  std::vector<double> w{1, 0.9, 0.625, 0.5 + 1e-15, 0.5};
  for (int j = 1; j <= levels; ++j) {
    for (const double factor : {1 - 1e-15, 0.9, 0.75, 0.6, 0.5}) w.push_back(std::ldexp(factor, -j));
  }
  return w;
}

struct Elementary {
  const char* name;
  double a, b, c;
  std::function<Real50(const Real50& w)> closed_form;
};

Real50 root(const Real50& w) { return sqrt(1 - w); }  // sqrt z
// Complete elliptic integrals of the modulus sqrt z, from the complement (DLMF 19.25.1).
Real50 K(const Real50& w) { return boost::math::ellint_rf(Real50(0), w, Real50(1)); }
Real50 E(const Real50& w) { return 2 * boost::math::ellint_rg(Real50(0), w, Real50(1)); }
const Real50 pi = boost::math::constants::pi<Real50>();

// asin sqrt z, from the complement.
Real50 arc(const Real50& w) { return atan2(root(w), sqrt(w)); }

// c - a - b is the exponent of the singular part at z = 1: halves, integers and 0 (a logarithm) among them.
const std::vector<Elementary> elementary = {
    {"1/2,1/2;3/2 is asin", 0.5, 0.5, 1.5, [](const Real50& w) { return w == 1 ? Real50(1) : arc(w) / root(w); }},
    {"1,1;2 is a logarithm", 1, 1, 2, [](const Real50& w) { return w == 1 ? Real50(1) : -log(w) / (1 - w); }},
    {"-3,2;1/2 is a cubic", -3, 2, 0.5,
     [](const Real50& w) {
       const Real50 z = 1 - w;
       return 1 - 12 * z + 24 * z * z - Real50(64) / 5 * z * z * z;
     }},
    {"-1/2,1/2;1/2 is a root", -0.5, 0.5, 0.5, [](const Real50& w) { return sqrt(w); }},
    {"-5/2,3/2;3/2 is a power", -2.5, 1.5, 1.5, [](const Real50& w) { return w * w * sqrt(w); }},
    {"1/2,1/2;1 is K", 0.5, 0.5, 1, [](const Real50& w) { return 2 / pi * K(w); }},
    {"-1/2,1/2;1 is E", -0.5, 0.5, 1, [](const Real50& w) { return 2 / pi * E(w); }},
    {"-1/2,1/2;2 is E and K", -0.5, 0.5, 2,
     [](const Real50& w) {
       if (w == 1) return Real50(1);
       const Real50 z = 1 - w;  // (4 / (3 pi z)) [(1 + z) E - (1 - z) K]
       return 4 / (3 * pi * z) * ((1 + z) * E(w) - w * K(w));
     }},
    {"1/2,1/2;5/2 is asin and a root", 0.5, 0.5, 2.5,
     [](const Real50& w) {
       if (w == 1) return Real50(1);
       const Real50 z = 1 - w;  // 3 [(2 z - 1) asin sqrt z + sqrt(z (1 - z))] / (4 z^(3/2))
       return 3 * ((2 * z - 1) * arc(w) + root(w) * sqrt(w)) / (4 * z * root(w));
     }},
};

TEST(Hypergeometric, OfFiftyDigitsAgreesWithElementaryCases) {
  for (const Elementary& e : elementary) {
    const Hypergeometric<Real50> f(e.a, e.b, e.c, levels);
    for (const double w : complements()) {
      const Real50 exact = e.closed_form(w);
      // Relative to y(0) = 1 where y falls towards zero: a continuation can't know that it does.
      const Real50 error = abs(f.at_complement(w) - exact) / std::max<Real50>(abs(exact), 1);
      EXPECT_LT(error, e.a < -1 ? 1e-46 : 1e-47) << e.name << " at w = " << w;
    }
  }
}

TEST(Hypergeometric, AtOneIsGausssSum) {
  for (const double b : {0.5, 1.25}) {
    for (const double c : {2.75, 3.0, 4.5}) {
      const Real50 a = -0.5;
      const Hypergeometric<Real50> f(a, b, c, levels);
      const auto gamma = [](const Real50& x) { return boost::math::tgamma(x); };
      const Real50 gauss = gamma(c) * gamma(c - a - b) / (gamma(c - a) * gamma(c - b));
      EXPECT_LT(abs(f.at_complement(0) / gauss - 1), 1e-20) << b << ' ' << c;
    }
  }
}

// (c - a) F(a - 1) + (2 a - c + (b - a) z) F + a (z - 1) F(a + 1) = 0 (DLMF 15.5.11) links three functions made apart.
TEST(Hypergeometric, ObeysGausssContiguousRelation) {
  for (const double a : {-0.3, -1.7, -7.3}) {
    for (const double c : {2.0, 3.4}) {
      const double b = 0.5;
      const Hypergeometric<Real50> below(Real50(a) - 1, b, c, levels), f(a, b, c, levels),
          above(Real50(a) + 1, b, c, levels);
      for (const double w : complements()) {
        const Real50 z = 1 - Real50(w);
        const Real50 first = (Real50(c) - a) * below.at_complement(w);
        const Real50 second = (2 * Real50(a) - c + (Real50(b) - a) * z) * f.at_complement(w);
        const Real50 third = -Real50(a) * w * above.at_complement(w);
        EXPECT_LT(abs(first + second + third), 1e-46 * (abs(first) + abs(second) + abs(third)))
            << a << ' ' << c << ' ' << w;
      }
    }
  }
}

// Every set of parameters that round_functions.h asks for.
struct Parameters {
  double a, b, c;
};

std::vector<Parameters> parameters_of(double n) {
  return {{-n, 0.5, 2}, {-n - 1, 0.5, 1}, {-n, 1.5, 2}, {-0.5, 0.5, n + 1.5}, {0.5, 0.5, n + 2.5}, {0.5, 1.5, n + 2.5}};
}

double worst_units(double n) {
  double worst = 0;
  for (const Parameters& p : parameters_of(n)) {
    const Hypergeometric<long double> extended(p.a, p.b, p.c, levels);
    const Hypergeometric<Real50> exact(p.a, p.b, p.c, levels);
    for (const double w : complements()) {
      const Real50 y = exact.at_complement(w);
      worst = std::max(worst, static_cast<double>(abs((Real50(extended.at_complement(w)) - y) / y)) * 0x1p64);
    }
  }
  return worst;
}

class HypergeometricOfThePowerFamily : public ::testing::TestWithParam<double> {};

TEST_P(HypergeometricOfThePowerFamily, IsGoodToAFewUnitsOfLongDouble) {
  const double n = GetParam();
  const double worst = worst_units(n);
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LT(worst, n > 10 ? 1500 : 25);
}

INSTANTIATE_TEST_SUITE_P(, HypergeometricOfThePowerFamily,
                         ::testing::Values(-0.5, -0.49, -0.3, 0, 0.25, 0.5, 1, 2, 3, 7.3, 20),
                         [](const auto& instance) {
                           std::string name = "n_" + std::to_string(instance.param);
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');
                           return name;
                         });

}  // namespace
}  // namespace patchgrip::friction::kernels
