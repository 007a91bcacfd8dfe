#include <patchgrip/friction/kernels/round_functions.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>

#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction::kernels {
namespace {

using Values = RoundValues<Real50>;

const Real50 pi = boost::math::constants::pi<Real50>();

// Poles by their distance d from the rim in the table's own measure: 1 - x inside, 1 - u outside.
const std::vector<double> distances{1, 1 - 1e-6, 0.97, 0.75, 0.5, 0.25, 0.03, 1e-3, 1e-9, 0x1p-52};

// Modulus sqrt(1 - w) from the complement w.
Real50 K(const Real50& w) { return boost::math::ellint_rf(Real50(0), w, Real50(1)); }
Real50 E(const Real50& w) { return 2 * boost::math::ellint_rg(Real50(0), w, Real50(1)); }

// f, m and f' as the handbooks print them; they cancel at the centre and far away, which 50 digits can afford.
struct Closed {
  Real50 f, m, slope;
};
struct Disc {
  const char* name;
  double n;
  std::function<Closed(const Real50& x)> inside;
  std::function<Closed(const Real50& x, const Real50& u, const Real50& root, const Real50& arc)>
      outside;  // sqrt(x^2 - 1), asin u
};

const std::vector<Disc> discs = {
    {"Hertz", 1,
     [](const Real50& x) {
       return Closed{3 * pi / 8 * (x - x * x * x / 4), 3 * pi / 16 * (1 - x * x + 3 * x * x * x * x / 8),
                     3 * pi / 8 * (1 - 3 * x * x / 4)};
     },
     [](const Real50& x, const Real50& u, const Real50& root, const Real50& arc) {
       const Real50 x2 = x * x;
       return Closed{3 * (x * (4 - x2) * arc + (x2 + 2) * root * u) / 16,
                     3 * ((8 - 8 * x2 + 3 * x2 * x2) * arc + (6 - 3 * x2) * root) / 64,
                     3 * ((4 - 3 * x2) * arc + (3 - 2 * u * u) * root) / 16};
     }},
    {"flat punch", 0,
     [](const Real50& x) {
       return Closed{pi * x / 4, pi / 4 * (1 - x * x / 2), pi / 4};
     },
     [](const Real50& x, const Real50& u, const Real50& root, const Real50& arc) {
       return Closed{(x * arc + root * u) / 2, ((2 - x * x) * arc + root) / 4, (arc - u * u * root) / 2};
     }},
    {"uniform", 0.5,
     [](const Real50& x) {
       const Real50 y = (1 - x) * (1 + x);
       return Closed{4 / (3 * pi * x) * ((1 + x * x) * E(y) - y * K(y)),
                     4 / (9 * pi) * ((4 - 2 * x * x) * E(y) - y * K(y)),
                     4 / (3 * pi * x * x) * ((2 * x * x - 1) * E(y) + y * K(y))};
     },
     [](const Real50& x, const Real50& u, const Real50&, const Real50&) {
       const Real50 y = (1 - u) * (1 + u);
       const Real50 x2 = x * x;
       const Real50 f = 4 / (3 * pi) * ((1 + x2) * E(y) - (x2 - 1) * K(y));
       const Real50 S = 4 / (9 * pi) * (x * (7 + x2) * E(y) - (x2 - 1) * (x2 + 3) * K(y) * u);
       return Closed{f, S - x * f, 4 / (3 * pi) * ((2 * x - u) * E(y) - 2 * (x - u) * K(y))};
     }},
    {"ring", -0.5,
     [](const Real50& x) {
       const Real50 y = (1 - x) * (1 + x);
       return Closed{2 / (pi * x) * (E(y) - y * K(y)), 2 / pi * (2 * E(y) - y * K(y)) - 2 / pi * (E(y) - y * K(y)),
                     2 / (pi * x * x) * (K(y) - E(y))};
     },
     [](const Real50& x, const Real50& u, const Real50&, const Real50&) {
       const Real50 y = (1 - u) * (1 + u);
       const Real50 f = 2 / pi * E(y);
       return Closed{f, 2 / pi * (2 * x * E(y) - (x - u) * K(y)) - x * f, 2 * u / pi * (K(y) - E(y))};
     }},
};

Real50 error(const Real50& value, const Real50& exact) { return abs(value / exact - 1); }

TEST(PowerFamily, InsideTheRimHasTheClosedFormsOfTheNamedDiscs) {
  for (const Disc& disc : discs) {
    const PowerFamily<Real50> family(disc.n);
    for (const double d : distances) {
      if (d == 1) continue;  // f / x is 0 / 0 in the closed forms
      const Real50 x = 1 - Real50(d);
      const Values g = family.inside(d);
      const Closed c = disc.inside(x);
      EXPECT_LT(error(g.force * x, c.f), 1e-32) << disc.name << ' ' << d;
      EXPECT_LT(error(g.moment, c.m), 1e-32) << disc.name << ' ' << d;
      EXPECT_LT(error(g.slope, c.slope), 1e-32) << disc.name << ' ' << d;
    }
  }
}

TEST(PowerFamily, OutsideTheRimHasTheClosedFormsOfTheNamedDiscs) {
  for (const Disc& disc : discs) {
    const PowerFamily<Real50> family(disc.n);
    for (const double d : distances) {
      if (d == 1) continue;
      const Real50 u = 1 - Real50(d);
      const Real50 x = 1 / u;
      const Real50 root = sqrt((x - 1) * (x + 1));
      const Values g = family.outside(d);
      const Closed c = disc.outside(x, u, root, atan2(Real50(1), root));
      const Real50 lost = x * x * x * x * x * x;  // what the closed forms cancel by
      EXPECT_LT(error(g.force, c.f), 1e-45 * lost) << disc.name << ' ' << d;
      EXPECT_LT(error(g.moment * u, c.m), 1e-45 * lost) << disc.name << ' ' << d;
      EXPECT_LT(error(g.slope * u * u * u, c.slope), 1e-45 * lost) << disc.name << ' ' << d;
    }
  }
}

class OfExponent : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(PowerFamily, OfExponent, ::testing::Values(-0.5, -0.49, -0.3, 0, 0.5, 1, 7.3, 20),
                         [](const auto& instance) { return "Number" + std::to_string(instance.index); });

// At the centre and at infinity every function is its leading coefficient: DLMF 15.2.1 with z = 0.
TEST_P(OfExponent, AtTheCentreAndAtInfinityItHasItsLeadingCoefficients) {
  const Real50 n = GetParam();
  const PowerFamily<Real50> family(n);
  const Real50 B = boost::math::beta(Real50(0.5), n + 1);
  const Values centre = family.inside(1);
  EXPECT_LT(error(centre.force, pi / (2 * B)), 1e-47);
  EXPECT_LT(error(centre.moment, pi / (2 * (n + 1) * B)), 1e-47);
  EXPECT_EQ(centre.slope, centre.force);
  const Values far = family.outside(1);
  EXPECT_EQ(far.force, 1);
  EXPECT_LT(error(far.moment, 1 / (2 * n + 3)), 1e-48);
  EXPECT_EQ(far.slope, far.moment);
}

// The Radon form: |P - M| = (1/4) int |(P - M) . e(phi)| dphi, with the pressure's projection q(s) = (1 - s^2)^n / B on
// every direction. All it has in common with the hypergeometric functions is the pressure.
TEST_P(OfExponent, EqualsTheRadonFormOfTheDistance) {
  const Real50 n = GetParam();
  const PowerFamily<Real50> family(n);
  const Real50 B = boost::math::beta(Real50(0.5), n + 1);
  boost::math::quadrature::tanh_sinh<Real50> quadrature(12);
  const auto integral = [&](const auto& f) { return quadrature.integrate(f, Real50(0), pi / 2, Real50(1e-30)); };
  for (const double x : {0.3, 0.8}) {
    const Values g = family.inside(1 - Real50(x));
    const auto rest = [&](const Real50& t) {  // 1 - x^2 cos^2 t
      const Real50 s = x * cos(t);
      return 1 - s * s;
    };
    EXPECT_LT(
        error(g.force, 2 / B * integral([&](const Real50& t) -> Real50 { return pow(rest(t), n) * sin(t) * sin(t); })),
        1e-29);
    EXPECT_LT(
        error(g.moment, 1 / ((n + 1) * B) * integral([&](const Real50& t) -> Real50 { return pow(rest(t), n + 1); })),
        1e-29);
    EXPECT_LT(
        error(g.slope, 2 / B * integral([&](const Real50& t) -> Real50 { return pow(rest(t), n) * cos(t) * cos(t); })),
        1e-29);
  }
  for (const double u : {0.9, 0.4}) {
    const Values g = family.outside(1 - Real50(u));
    // s = cos t, sqrt(1 - u^2 s^2)
    const auto root = [&](const Real50& t) {
      const Real50 s = u * cos(t);
      return sqrt(1 - s * s);
    };
    const auto weight = [&](const Real50& t, int power) -> Real50 { return pow(sin(t), 2 * n + power); };
    EXPECT_LT(error(g.force, 2 / B * integral([&](const Real50& t) -> Real50 { return weight(t, 1) * root(t); })),
              1e-29);
    EXPECT_LT(error(g.moment,
                    1 / ((n + 1) * B) * integral([&](const Real50& t) -> Real50 { return weight(t, 3) / root(t); })),
              1e-29);
    EXPECT_LT(error(g.slope, 2 / B * integral([&](const Real50& t) -> Real50 {
                               return weight(t, 1) * cos(t) * cos(t) / root(t);
                             })),
              1e-29);
  }
}

// S = f x + m, f = S' and f' = S'' tie the three functions together, on both sides.
TEST_P(OfExponent, ForceAndMomentAreDerivativesOfTheMeanDistance) {
  const PowerFamily<Real50> family(GetParam());
  struct Point {
    Real50 f, S;
  };
  const auto at = [&](const Real50& x) {
    if (x < 1) {
      const Values g = family.inside(1 - x);
      return Point{g.force * x, g.force * x * x + g.moment};
    }
    const Values g = family.outside(1 - 1 / x);
    return Point{g.force, g.force * x + g.moment / x};
  };
  const Real50 h = 1e-9;
  for (const double x0 : {0.1, 0.6, 1.2, 3.0, 50.0}) {
    const Real50 x = x0;
    const Point p1 = at(x + h), m1 = at(x - h), p2 = at(x + 2 * h), m2 = at(x - 2 * h);
    const Real50 slope = x < 1 ? family.inside(1 - x).slope : family.outside(1 - 1 / x).slope / (x * x * x);
    EXPECT_LT(abs((8 * (p1.S - m1.S) - (p2.S - m2.S)) / (12 * h) - at(x).f), 1e-30) << x0;
    EXPECT_LT(abs((8 * (p1.f - m1.f) - (p2.f - m2.f)) / (12 * h) - slope), 1e-30) << x0;
  }
}

// The bottom of it all: a ring is the mean of |P - M| over points of a circle, ...
TEST(PowerFamily, RingIsTheMeanOverTheCircle) {
  const PowerFamily<Real50> ring(-0.5);
  constexpr int points = 400;  // periodic: the error falls like min(x, 1/x)^points
  for (const double x : {0.4, 0.8, 1.25, 2.0}) {
    Real50 S = 0, f = 0;
    for (int i = 0; i < points; ++i) {
      const Real50 phi = 2 * pi * i / points;
      const Real50 dx = x - cos(phi);
      const Real50 distance = sqrt(dx * dx + sin(phi) * sin(phi));
      S += distance / points;
      f += dx / distance / points;
    }
    const Values g = x < 1 ? ring.inside(1 - Real50(x)) : ring.outside(1 - 1 / Real50(x));
    EXPECT_LT(error(x < 1 ? g.force * x : g.force, f), 1e-33) << x;
    EXPECT_LT(error(x < 1 ? g.moment : g.moment / x, S - x * f), 1e-33) << x;
  }
}

// ... and a disc a stack of rings: the load outside the radius r is q = (1 - r^2)^(n + 1/2).
class DiscOfExponent : public ::testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(PowerFamily, DiscOfExponent, ::testing::Values(-0.49, -0.3, 0, 0.5, 1, 7.3, 20),
                         [](const auto& instance) { return "Number" + std::to_string(instance.index); });

TEST_P(DiscOfExponent, IsAStackOfRings) {
  const long double n = GetParam();
  const PowerFamily<long double> family(n);
  const PowerFamily<long double> ring(-0.5L);
  boost::math::quadrature::tanh_sinh<long double> quadrature;
  for (const long double x : {0.3L, 0.8L, 1.25L, 4.0L}) {
    const auto at = [x](const PowerFamily<long double>& source,
                        long double r) {  // {force, moment} of a disc of radius r
      if (x <= r) {
        const auto g = source.inside((r - x) / r);
        return std::pair{g.force * x / r, g.moment * r};
      }
      const auto g = source.outside((x - r) / x);
      return std::pair{g.force, g.moment * r * r / x};
    };
    const long double split = x < 1 ? std::pow((1 - x) * (1 + x), n + 0.5L) : 0.5L;
    const auto stacked = [&](auto member) {
      const auto integrand = [&](long double q) {
        return at(ring, std::sqrt(1 - std::pow(q, 1 / (n + 0.5L)))).*member;
      };
      return quadrature.integrate(integrand, 0.0L, split) + quadrature.integrate(integrand, split, 1.0L);
    };
    const auto disc = at(family, 1);
    // For n = 20 the split (1 - x^2)^(n + 1/2) comes close to 0 and the rings beyond it crowd: tanh-sinh stops at
    // 1e-12.
    const long double tolerance = n == 20 ? 1e-11L : 1e-15L;
    EXPECT_LT(std::abs(stacked(&std::pair<long double, long double>::first) / disc.first - 1), tolerance) << x;
    EXPECT_LT(std::abs(stacked(&std::pair<long double, long double>::second) / disc.second - 1), tolerance) << x;
  }
}

TEST(PowerFamily, OfTheRingHasAnInfiniteSlopeAtTheRim) {
  const PowerFamily<Real50> ring(-0.5);
  // f' ~ -ln d / pi on both sides: it grows by ln(10^6) / pi over six decades of d.
  const Real50 grown = log(Real50(1e6)) / pi;
  EXPECT_LT(abs(ring.inside(1e-18).slope - ring.inside(1e-12).slope - grown), 1e-10);
  EXPECT_LT(abs(ring.outside(1e-18).slope - ring.outside(1e-12).slope - grown), 1e-10);
}

}  // namespace
}  // namespace patchgrip::friction::kernels
