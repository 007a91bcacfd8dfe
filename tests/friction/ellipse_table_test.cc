#include <patchgrip/friction/kernels/ellipse_table.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <boost/math/special_functions/ellint_rd.hpp>

#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction::kernels {
namespace {

using std::numbers::pi;

// Carlson's R_D for int_lambda^inf s^(1/2) P^(3/2) Q^(3/2) ds: h_cross, the one that is not made by parts.
double h_cross_error(double lambda, double b) {
  const Real50 l = lambda, b2 = Real50(b) * b;
  const Real50 al = 1 + l, be = b2 + l;
  const Real50 A = 2 * boost::math::ellint_rd(l, be, al) / 3;
  const Real50 B = 2 * boost::math::ellint_rd(l, al, be) / 3;
  const Real50 exact = 3 * al * sqrt(al) * (A - b2 * B) / (1 - b2) / 2;
  const long double quadrature =
      ellipse_integrals(static_cast<long double>(lambda), static_cast<long double>(b) * b).h_cross;
  return static_cast<double>(abs(quadrature / exact - 1));
}

TEST(EllipseIntegrals, AgreeWithCarlsonsToExtendedPrecision) {
  for (const double b : {0.999, 0.5, 0.03, 1e-3, 1e-6}) {
    for (const double lambda : {0.0, 1e-6 * b * b, b * b, 0.01, 1.0, 1e4, 1e12}) {
      EXPECT_LE(h_cross_error(lambda, b), 2e-18) << b << ' ' << lambda;
    }
  }
}

TEST(EllipseIntegrals, OfACircleAreThoseOfTheHertzDisc) {
  const auto rim = ellipse_integrals(0.0, 1.0);
  const double tolerance = 100 * 0x1p-53;            // the sum of a hundred terms in double
  EXPECT_NEAR(rim.u_major, 9 * pi / 32, tolerance);  // f on the rim
  EXPECT_NEAR(rim.u_mixed, 9 * pi / 32, tolerance);
  EXPECT_NEAR(rim.u_minor, 9 * pi / 32, tolerance);
  EXPECT_NEAR(rim.m_pure, 9 * pi / 128, tolerance);  // m on the rim
  EXPECT_NEAR(rim.m_mixed, 9 * pi / 64, tolerance);
  const auto centre = ellipse_centre(1.0);
  EXPECT_NEAR((centre.major + centre.minor) / 4, 3 * pi / 16, tolerance);  // m at the centre
}

TEST(EllipseIntegrals, FarAwayAreThoseOfAPoint) {
  for (const double b : {1.0, 0.1, 1e-4}) {
    const auto far = ellipse_integrals(1e14L, static_cast<long double>(b) * b);
    EXPECT_NEAR(static_cast<double>(far.u_major), 1, 1e-13);
    EXPECT_NEAR(static_cast<double>(far.u_mixed), 1, 1e-13);
    EXPECT_NEAR(static_cast<double>(far.u_minor), 1, 1e-13);
    EXPECT_NEAR(static_cast<double>(far.m_pure), 0.2, 1e-13);  // <(e . P)^2> = a^2 / 5
  }
}

TEST(EllipseTable, HasTheIntegralsToRounding) {
  std::mt19937_64 engine(1);
  double worst = 0;
  for (const double b : {1.0, 0.9, 0.51, 0.5, 0.1, 0.01, 1e-3}) {
    const long double b2 = static_cast<long double>(b) * b;
    const EllipseTable table(b2);
    for (int i = 0; i < testing::cases(400); ++i) {
      const double lambda = i % 2 == 0 ? testing::log_uniform(engine, 1e-4 * b * b, 4)
                                       : testing::log_uniform(engine, 1e-12 * b * b, 1e16);
      const auto exact = ellipse_integrals(static_cast<long double>(lambda), b2);
      const auto [row, t] = table.find(lambda, 1);
      EXPECT_TRUE(std::fabs(t) <= 1);
      const auto judge = [&, t = t](const auto& pairs, long double first, long double second) {
        const Pair p = polynomial(pairs, t);
        worst = std::max({worst, std::fabs(static_cast<double>(p[0] / first - 1)) * 0x1p53,
                          std::fabs(static_cast<double>(p[1] / second - 1)) * 0x1p53});
      };
      judge(row.u_major_mixed, exact.u_major, exact.u_mixed);
      judge(row.u_minor_m_pure, exact.u_minor, exact.m_pure);
      judge(row.m_mixed_h_pure, exact.m_mixed, exact.h_pure);
      judge(row.h_cross_h_mixed, exact.h_cross, exact.h_mixed);
    }
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 8);
}

// Lambda and W2 may both be scaled; the rim itself and infinity have their rows.
TEST(EllipseTable, KnowsTheRimAndInfinity) {
  const EllipseTable table(0.01L);
  EXPECT_EQ(table.find(0, 3).t, -1);
  EXPECT_EQ(table.find(3, 0).t, -1);
  EXPECT_NE(&table.find(0, 3).row, &table.find(3, 0).row);
  EXPECT_EQ(&table.find(0.7, 1).row, &table.find(0.7 * 0x1p80, 0x1p80).row);
  EXPECT_EQ(polynomial(table.find(3, 0).row.u_major_mixed, -1)[0], 1);
}

}  // namespace
}  // namespace patchgrip::friction::kernels
