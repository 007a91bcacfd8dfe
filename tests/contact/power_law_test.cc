#include <patchgrip/contact/fingertip/power_law.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/hertz_circle.h>
#include <patchgrip/contact/sphere.h>
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

TEST(PowerLawFit, AgreesWithTheTable) {
  const auto rows = contact_rows("power_law_fit");
  ASSERT_EQ(rows.size(), 1U);
  for (const auto& row : rows) {
    std::vector<MeasuredRadius> points;
    for (const std::string i : {"1", "2", "3", "4", "5"}) points.push_back({row.input("F_" + i), row.input("a_" + i)});
    const auto fit = PowerLawFit::to(points);
    EXPECT_LE(units_of_rounding(fit.law.c, row.output("c")), 4);
    EXPECT_LE(units_of_rounding(fit.law.gamma, row.output("gamma")), 4);
    EXPECT_LE(units_of_rounding(fit.rms_log, row.output("rms_log")), 200);  // of a: residuals are a hundredth of it
    EXPECT_EQ(fit.points, 5);
  }
}

// Normal equations in fifty digits.
TEST(PowerLawFit, HoldsItsBound) {
  std::mt19937_64 engine(20060260);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double lo = log_uniform(engine, 1e-12, 1e9), span = log_uniform(engine, 1.01, 1e3);
    const double c = log_uniform(engine, 1e-6, 1), gamma = uniform(engine, 0.05, 0.34);
    std::vector<MeasuredRadius> points;
    for (int k = 0; k < 2 + i % 9; ++k) {
      const double force = k == 0 ? lo : k == 1 ? lo * span : lo * log_uniform(engine, 1, span);
      points.push_back({force, c * std::pow(force, gamma) * uniform(engine, 0.99, 1.01)});
    }
    Exact n = 0, x = 0, y = 0, xx = 0, xy = 0, largest = 1;
    for (const auto& p : points) {
      const Exact lx = log(Exact(p.normal_force)), ly = log(Exact(p.contact_radius));
      n += 1, x += lx, y += ly, xx += lx * lx, xy += lx * ly;
      largest = std::max({largest, Exact(abs(lx)), Exact(abs(ly))});
    }
    const Exact slope = (n * xy - x * y) / (n * xx - x * x), offset = (y - slope * x) / n;
    if (!(slope > 0)) {
      EXPECT_THROW(PowerLawFit::to(points), std::invalid_argument);
      continue;
    }
    const auto fit = PowerLawFit::to(points);
    const double bound = fit.error_units * 0x1p-53;
    EXPECT_NEAR(fit.error_units / static_cast<double>(1.6 + 0x1p-7 * largest * largest / log(Exact(span))), 1, 1e-9);
    worst = std::max({worst, static_cast<double>(abs(fit.law.gamma - slope)) / bound,
                      static_cast<double>(abs(fit.law.c / exp(offset) - 1)) / bound});
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

RC_GTEST_PROP(PowerLawFit, FindsTheLawThatMadeThePoints, ()) {
  const auto law = PowerLaw::of(std::pow(10, 1e-3 * *rc::gen::inRange(-4000, 0)), 1e-3 * *rc::gen::inRange(50, 334));
  std::vector<MeasuredRadius> points;
  for (const double force : {0.05, 0.3, 1., 2.5, 20.}) points.push_back({force, law.contact_radius(force)});
  const auto fit = PowerLawFit::to(points);
  RC_ASSERT(std::abs(fit.law.gamma - law.gamma) < 1e-15);
  RC_ASSERT(std::abs(fit.law.c / law.c - 1) < 1e-15);
  RC_ASSERT(fit.rms_log < 1e-15);
  RC_ASSERT(std::abs(law.normal_force(law.contact_radius(2.5)) / 2.5 - 1) < 1e-14);
}

TEST(PowerLawFit, OfHertzHasGammaOneThird) {
  std::vector<MeasuredRadius> points;
  for (const double force : {0.1, 0.5, 1., 3., 10.})
    points.push_back({force, HertzCircle::under_force(force, 0.02, 66666).radius});
  EXPECT_NEAR(PowerLawFit::to(points).law.gamma, 1. / 3, 1e-15);
}

// The shape of a ball alone explains gamma < 1/3: what a narrow range of loads gives is the slope of the exact sphere.
TEST(PowerLawFit, OfADeeplyPressedBallFallsBelowOneThird) {
  for (const auto& [ratio, gamma] :
       {std::pair{0.01, 0.333}, std::pair{0.5, 0.307}, std::pair{0.8, 0.236}, std::pair{0.9, 0.175}}) {
    std::vector<MeasuredRadius> points;
    double slope = 0;
    for (const double part : {0.999, 1., 1.001}) {
      const auto zone = AxisymmetricContact<Sphere>::at_radius(Sphere::of_radius(0.02), 0.02 * ratio * part, 66666);
      points.push_back({zone.force(), zone.radius()});
      if (part == 1) slope = 1 / zone.growth_exponent();
    }
    EXPECT_NEAR(slope, gamma, 6e-4);
    EXPECT_NEAR(PowerLawFit::to(points).law.gamma, slope, 1e-4);
  }
}

// 95 % limits hold the truth in 95 % of experiments: 2000 of them are within 0.95 +- 0.02 but for one in 40000.
TEST(PowerLawFit, ConfidenceLimitsCoverAsOftenAsTheySay) {
  std::mt19937_64 engine(20060261);
  std::normal_distribution<double> noise(0, 0.02);
  const int experiments = std::max(2000, cases(2000));
  int gamma_covered = 0, c_covered = 0, radius_covered = 0;
  for (int i = 0; i < experiments; ++i) {
    std::vector<MeasuredRadius> points;
    for (const double force : {0.1, 0.4, 1., 3., 8.})
      points.push_back({force, 0.004 * std::pow(force, 0.28) * std::exp(noise(engine))});
    const auto fit = PowerLawFit::to(points);
    const auto gamma = fit.gamma_limits(0.95), c = fit.c_limits(0.95);
    gamma_covered += gamma.low <= 0.28 && 0.28 <= gamma.high;
    c_covered += c.low <= 0.004 && 0.004 <= c.high;
    const double force = std::array{0.02, 0.9, 5., 200.}[static_cast<std::size_t>(i % 4)];
    const auto radius = fit.radius_limits(force, 0.95);
    const double truth = 0.004 * std::pow(force, 0.28);
    radius_covered += radius.low <= truth && truth <= radius.high;
  }
  EXPECT_NEAR(static_cast<double>(gamma_covered) / experiments, 0.95, 0.02);
  EXPECT_NEAR(static_cast<double>(c_covered) / experiments, 0.95, 0.02);
  EXPECT_NEAR(static_cast<double>(radius_covered) / experiments, 0.95, 0.02);
}

// At 1 N the radius is c, and far off it is the exponent that tells.
TEST(PowerLawFit, LimitsOfTheRadiusAreThoseOfBothTogether) {
  const std::vector<MeasuredRadius> points{{0.2, 3.1e-3}, {0.5, 4e-3}, {2, 6.1e-3}, {8, 9e-3}};
  const auto fit = PowerLawFit::to(points);
  const auto at_one = fit.radius_limits(1, 0.95), c = fit.c_limits(0.95);
  EXPECT_NEAR(at_one.low / c.low, 1, 1e-14);
  EXPECT_NEAR(at_one.high / c.high, 1, 1e-14);
  const auto gamma = fit.gamma_limits(0.95), far = fit.radius_limits(1e100, 0.95);
  EXPECT_NEAR(std::log(far.high / far.low) / (std::log(1e100) * (gamma.high - gamma.low)), 1, 0.01);
  EXPECT_THROW(fit.radius_limits(0, 0.95), std::invalid_argument);
}

// Three points, one degree of freedom: Student's factor at 95 % is 12.7062.
TEST(PowerLawFit, LimitsOfThreePointsAreStudents) {
  const std::vector<MeasuredRadius> points{{1, 0.004}, {2, 0.005}, {4, 0.0061}};
  const auto fit = PowerLawFit::to(points);
  const auto limits = fit.gamma_limits(0.95);
  EXPECT_NEAR((limits.high - limits.low) / 2 / fit.gamma_spread, 12.706204736432095, 1e-9);
}

TEST(PowerLawFit, PointsThatFixNoLineAreRefused) {
  const std::vector<MeasuredRadius> one{{1, 0.004}}, same{{1, 0.004}, {1, 0.005}}, two{{1, 0.004}, {2, 0.005}};
  EXPECT_THROW(PowerLawFit::to(one), std::invalid_argument);
  EXPECT_THAT([&] { PowerLawFit::to(same); }, ::testing::ThrowsMessage<std::invalid_argument>(
                                                  "normal_force = 1 is not allowed: must differ between the points"));
  EXPECT_LT(PowerLawFit::to(two).rms_log, 1e-17);
  EXPECT_THROW(PowerLawFit::to(two).gamma_limits(0.95), std::invalid_argument);
  EXPECT_THROW(PowerLawFit::to(std::vector<MeasuredRadius>{{1, 0.004}, {-2, 0.005}}), std::invalid_argument);
  const std::vector<MeasuredRadius> three{{1, 0.004}, {2, 0.005}, {4, 0.0061}};
  EXPECT_THROW(PowerLawFit::to(three).c_limits(1), std::invalid_argument);
}

TEST(PowerLaw, HoldsItsBound) {
  std::mt19937_64 engine(20060262);
  double worst = 0;
  for (int i = 0; i < cases(500); ++i) {
    const auto law = PowerLaw::of(log_uniform(engine, 1e-6, 1), uniform(engine, 0.05, 0.34));
    const double force = log_uniform(engine, 1e-12, 1e12);
    const double radius = law.contact_radius(force);
    worst = std::max(worst, units_of_rounding(radius, law.c * pow(Exact(force), Exact(law.gamma))) / 3);
    const Exact ratio = Exact(radius) / law.c;
    const double allowed = (2 + static_cast<double>(Exact(abs(log(ratio))))) / law.gamma;
    worst = std::max(worst, units_of_rounding(law.normal_force(radius), pow(ratio, 1 / Exact(law.gamma))) / allowed);
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
  EXPECT_LE(worst, 1);
}

TEST(PowerLaw, OutOfRangeParametersAreRefused) {
  EXPECT_THROW(PowerLaw::of(0, 0.3), std::invalid_argument);
  EXPECT_THROW(PowerLaw::of(1, -0.3), std::invalid_argument);
  EXPECT_THROW(PowerLaw::of(1, 0.3).contact_radius(-1), std::invalid_argument);
  EXPECT_THROW(PowerLaw::of(1, 0).normal_force(1), std::invalid_argument);
  EXPECT_EQ(PowerLaw::of(1, 0.3).contact_radius(0), 0);
}

}  // namespace
}  // namespace patchgrip::contact
