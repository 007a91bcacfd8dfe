#include <patchgrip/contact/adhesion/maugis_dugdale.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <patchgrip/contact/adhesion/dmt.h>
#include <patchgrip/contact/adhesion/jkr.h>
#include <patchgrip/tests/contact/contact_table.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::contact_rows;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using patchgrip::testing::units_of_rounding;

constexpr double pi = std::numbers::pi;

TEST(MaugisDugdale, AgreesWithTheTable) {
  const auto rows = contact_rows("maugis_dugdale");
  ASSERT_EQ(rows.size(), 3U);
  for (const auto& row : rows) {
    const auto model =
        MaugisDugdale::of(AdhesiveSphere::of(row.input("R"), row.input("E_star"), row.input("w")), row.input("sigma0"));
    const auto at = model.at_radius(row.input("a"));
    EXPECT_LE(units_of_rounding(model.maugis_parameter(), row.output("lam")), 3);
    EXPECT_LE(units_of_rounding(at.outer_radius / at.contact_radius, row.output("c_over_a")), 4);
    EXPECT_LE(units_of_rounding(at.ring_width, row.output("c_minus_a")), 6);
    EXPECT_LE(units_of_rounding(at.normal_force, row.output("F_N")), 20);  // the rounding of w, times the larger term
    EXPECT_LE(units_of_rounding(at.approach, row.output("delta")), 12);
  }
}

// lambda is chosen: R = w = 1 and K = 1/pi make every unit of the model simple.
MaugisDugdale model_of(double lambda) {
  return MaugisDugdale::of(AdhesiveSphere::of(1, 0.75 / pi, 1), lambda / (2 * std::cbrt(pi)));
}

TEST(MaugisDugdale, PullOffAgreesWithTheTable) {
  const auto rows = contact_rows("maugis_pulloff");
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& row : rows) {
    const auto point = MaugisCurve<long double>{row.input("lam")}.pull_off();
    EXPECT_LE(units_of_rounding(static_cast<double>(-point.force), row.output("Fbar_pulloff")), 2);
    EXPECT_LE(units_of_rounding(static_cast<double>(point.A), row.output("Abar_pulloff")), 2);
    EXPECT_LE(units_of_rounding(static_cast<double>(point.n + 1), row.output("m_pulloff")), 2);
  }
}

// The equations as they stand, in fifty digits: a residual, not the library's own route.
Exact condition_of_maugis(const Exact& lambda, const Exact& A, const Exact& n) {
  const Exact m = 1 + n, s = sqrt(n * (n + 2)), t = acos(1 / m);
  return lambda * A * A / 2 * (s + (m * m - 2) * t) + 4 * lambda * lambda * A / 3 * (s * t - n) - 1;
}

TEST(MaugisDugdale, CurveSolvesTheConditionOfMaugis) {
  std::mt19937_64 engine(20060240);
  for (int i = 0; i < cases(500); ++i) {
    const Exact lambda = log_uniform(engine, 1e-4, 1e4), n = log_uniform(engine, 1e-8, 1e8);
    const auto point = MaugisCurve<Exact>{lambda}.at(n);
    EXPECT_LE(abs(condition_of_maugis(lambda, point.A, n)), 1e-28);  // acos next to 1 halves the digits
  }
}

TEST(MaugisDugdale, CurveHoldsItsBound) {
  std::mt19937_64 engine(20060241);
  double worst = 0, worst_pull_off = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double lambda = log_uniform(engine, i % 2 == 0 ? 1e-8 : 1e-2, i % 2 == 0 ? 1e8 : 1e2);
    const MaugisCurve<long double> curve{lambda};
    const MaugisCurve<Exact> exact{Exact(lambda)};
    const auto units = [](long double value, const Exact& reference) {
      return static_cast<double>(abs(Exact(value) / reference - 1)) * 0x1p53;
    };
    const double A = log_uniform(engine, 1e-4, 1e4);
    const auto point = curve.at_radius(A);
    const auto exactly = exact.at_radius(Exact(A));
    worst = std::max({worst, units(point.n, exactly.n),
                      static_cast<double>(abs(point.force - exactly.force) / exactly.force_term) * 0x1p53});
    const auto least = curve.pull_off();
    const auto exactly_least = exact.pull_off();
    worst_pull_off = std::max({worst_pull_off, units(least.force, exactly_least.force), units(least.A, exactly_least.A),
                               units(least.n, exactly_least.n)});
  }
  RecordProperty("worst_units", std::to_string(worst));
  RecordProperty("worst_units_pull_off", std::to_string(worst_pull_off));
  EXPECT_LE(worst, 0.25);
  EXPECT_LE(worst_pull_off, 0.25);
}

TEST(MaugisDugdale, StateAtARadiusHoldsItsBound) {
  std::mt19937_64 engine(20060243);
  const Exact exact_pi = boost::math::constants::pi<Exact>();
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double R = log_uniform(engine, 1e-9, 1e3), E = log_uniform(engine, 1e3, 1e12);
    const double w = log_uniform(engine, 1e-4, 1e2);
    const Exact K = 4 * Exact(E) / 3, unit = cbrt(exact_pi * w * R * R / K);
    const double attraction =
        static_cast<double>(log_uniform(engine, 1e-7, 1e7) / 2 * cbrt(Exact(exact_pi * w * K * K / R)));
    const double a = static_cast<double>(unit * log_uniform(engine, 1e-3, 1e3));
    const auto at = MaugisDugdale::of(AdhesiveSphere::of(R, E, w), attraction).at_radius(a);

    const MaugisCurve<Exact> curve{2 * Exact(attraction) * cbrt(Exact(R / (exact_pi * w * K * K)))};
    const auto point = curve.at_radius(a / unit);
    const Exact depth = unit * unit / R;
    const Exact attracted = point.A * point.A + abs(point.approach);
    worst = std::max(
        {worst, units_of_rounding(at.ring_width, a * point.n), units_of_rounding(at.outer_radius, a * (1 + point.n)),
         static_cast<double>(abs(at.normal_force / (exact_pi * w * R) - point.force) / point.force_term) * 0x1p53,
         static_cast<double>(abs(at.approach / depth - point.approach) / attracted) * 0x1p53});
  }
  RecordProperty("worst_units", std::to_string(worst));
  EXPECT_LE(worst, 1.1);
}

TEST(MaugisDugdale, RadiusUnderALoadHoldsItsEstimate) {
  std::mt19937_64 engine(20060242);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double lambda = log_uniform(engine, 1e-6, 1e6);
    const auto model = model_of(lambda);
    const double least = model.pull_off().normal_force;
    const double force = i % 3 == 0   ? log_uniform(engine, 1e-9, 1e9)
                         : i % 3 == 1 ? uniform(engine, least, 0)
                                      : least * (1 - log_uniform(engine, 1e-15, 1));
    const auto at = model.under_force(force);

    // The curve through the library's own lambda, in fifty digits.
    const Exact exact_pi = boost::math::constants::pi<Exact>();
    const Exact E(model.sphere().contact_modulus), K = 4 * E / 3;
    const MaugisCurve<Exact> exact{2 * Exact(model.attraction()) * cbrt(1 / (exact_pi * K * K))};
    const auto exactly_least = exact.pull_off();
    const auto point = exact.under_force(force / exact_pi, exactly_least);
    const Exact a = point.A * cbrt(exact_pi / K);
    worst = std::max(worst, static_cast<double>(abs(at.contact_radius / a - 1)) / at.relative_radius_error);
    if (force > 0.9 * least) {
      EXPECT_LE(at.relative_radius_error, 1.7e-16 + 1e-16 / lambda);
    }
  }
  RecordProperty("worst_of_estimate", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

RC_GTEST_PROP(MaugisDugdale, PressureCarriesTheForce, ()) {
  const double lambda = std::pow(10, 1e-3 * *rc::gen::inRange(-1500, 1500));
  const auto model = model_of(lambda);
  const auto at = model.under_force(1e-2 * *rc::gen::inRange(-400, 2000));
  boost::math::quadrature::tanh_sinh<double> integrate;
  const auto part = [&](double lo, double hi) {
    return integrate.integrate([&](double r) { return 2 * pi * r * model.pressure(at, r); }, lo, hi);
  };
  const double carried = part(0, at.contact_radius) + part(at.contact_radius, at.outer_radius);
  RC_ASSERT(std::abs(carried - at.normal_force) < 1e-6 * (1 + std::abs(at.normal_force)));
}

RC_GTEST_PROP(MaugisDugdale, ForceRisesWithTheRadiusOnTheStableBranch, ()) {
  const auto model = model_of(std::pow(10, 1e-3 * *rc::gen::inRange(-3000, 3000)));
  const auto least = model.pull_off();
  const double a = least.contact_radius * (1 + std::pow(10, 1e-3 * *rc::gen::inRange(-3000, 3000)));
  RC_ASSERT(model.at_radius(a).normal_force > least.normal_force);
  RC_ASSERT(model.at_radius(1.001 * a).normal_force > model.at_radius(a).normal_force);
  RC_ASSERT(model.at_radius(1.001 * a).ring_width < model.at_radius(a).ring_width);
}

TEST(MaugisDugdale, TendsToDmtAndJkr) {
  for (const double force : {-4., 0., 5., 1e3}) {
    const auto soft = model_of(1e4), hard = model_of(1e-4);
    EXPECT_NEAR(soft.under_force(force).contact_radius / Jkr(soft.sphere()).under_force(force).contact_radius, 1, 1e-7);
    EXPECT_NEAR(soft.under_force(force).approach, Jkr(soft.sphere()).under_force(force).approach, 1e-6);
    EXPECT_NEAR(hard.under_force(force).contact_radius / Dmt(hard.sphere()).under_force(force).contact_radius, 1, 1e-3);
  }
  EXPECT_NEAR(model_of(9.99e7).pull_off().normal_force / -pi, 1.5, 1e-15);
  EXPECT_NEAR(model_of(1.01e-8).pull_off().normal_force / -pi, 2, 2e-11);
}

// Between the limits the tension falls from 2 to 3/2.
TEST(MaugisDugdale, PullOffFallsWithLambda) {
  double before = 2;
  for (double lambda = 1.01e-8; lambda < 9e7; lambda *= 1.5) {
    const double now = model_of(lambda).pull_off().normal_force / -pi;
    EXPECT_LE(now, before + 1e-15);
    before = now;
  }
}

TEST(MaugisDugdale, FitOfThePullOffStaysWithinItsError) {
  double most = 0, least = 0;
  for (double lambda = 1.01e-8; lambda < 9e7; lambda *= 1.01) {
    const double error = pull_off_fit(lambda) / (model_of(lambda).pull_off().normal_force / -pi) - 1;
    most = std::max(most, error);
    least = std::min(least, error);
  }
  RecordProperty("most", std::to_string(most));
  RecordProperty("least", std::to_string(least));
  EXPECT_LE(most, 0.007);
  EXPECT_GE(least, -0.018);
  EXPECT_GE(most, 0.005);
  EXPECT_LE(least, -0.015);
}

TEST(MaugisDugdale, OutOfRangeParametersAreRefused) {
  const auto s = AdhesiveSphere::of(1, 1, 1);
  EXPECT_THROW(MaugisDugdale::of(s, 0), std::invalid_argument);
  EXPECT_THAT([&] { MaugisDugdale::of(s, 1e9); },
              ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("must lie in [1e-08, 1e+08]")));
  const auto model = model_of(1);
  EXPECT_THROW(model.under_force(1.001 * model.pull_off().normal_force), std::invalid_argument);
  EXPECT_THROW(model.under_force(std::nan("")), std::invalid_argument);
  EXPECT_THROW(model.at_radius(0), std::invalid_argument);
  EXPECT_THROW(model.pressure(model.pull_off(), -1), std::invalid_argument);
  EXPECT_EQ(model.pressure(model.pull_off(), 1e9), 0);
  EXPECT_NEAR(model.under_force(model.pull_off().normal_force).contact_radius / model.pull_off().contact_radius, 1,
              1e-7);
}

}  // namespace
}  // namespace patchgrip::contact
