#include <patchgrip/contact/hertz_ellipse_approximation.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/contact/hertz_ellipse.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::log_uniform;

TEST(HertzEllipseApproximation, ErrorsStayWithinTheirBoundsAndNotFarBelow) {
  std::mt19937_64 engine(20060160);
  for (int i = 0; i < cases(2000); ++i) {
    const double q = log_uniform(engine, HertzEllipseApproximation::smallest_ratio * (1 + 1e-12), 1);
    const double large = log_uniform(engine, 1e-6, 1e6), force = log_uniform(engine, 1e-12, 1e12);
    const double modulus = log_uniform(engine, 1, 1e12);
    const auto radii = RelativeRadii::of(q * large, large);
    const auto cheap = HertzEllipseApproximation::under_force(force, radii, modulus);
    const auto exact = HertzEllipse::under_force(force, radii, modulus);

    const double pressure = cheap.peak_pressure / exact.peak_pressure - 1;
    const double approach = cheap.approach / exact.approach - 1;
    EXPECT_LE(std::abs(cheap.a / exact.a - 1), cheap.a_error) << q;
    EXPECT_LE(std::abs(cheap.b / exact.b - 1), cheap.b_error) << q;
    EXPECT_LE(std::abs(pressure), cheap.peak_pressure_error) << q;
    EXPECT_LE(std::abs(approach), cheap.approach_error) << q;
    if (q < 0.9) {
      EXPECT_LE(pressure, 0) << q;
      EXPECT_LE(approach, 0) << q;
      EXPECT_GE(cheap.a, exact.a) << q;
      EXPECT_LE(cheap.peak_pressure_error, 1.2 * std::abs(pressure)) << q;
      EXPECT_LE(cheap.approach_error, 1.2 * std::abs(approach)) << q;
      EXPECT_LE(cheap.a_error, 1.6 * std::abs(cheap.a / exact.a - 1)) << q;
    }
  }
}

RC_GTEST_PROP(HertzEllipseApproximation, IsExactForTheCircle, ()) {
  const double R = std::pow(10, 1e-3 * *rc::gen::inRange(-3000, 3000));
  const auto cheap = HertzEllipseApproximation::under_force(2, RelativeRadii::of(R, R), 1e6);
  const auto exact = HertzEllipse::under_force(2, RelativeRadii::of(R, R), 1e6);
  RC_ASSERT(std::abs(cheap.a / exact.a - 1) <= cheap.a_error);
  RC_ASSERT(std::abs(cheap.b / exact.b - 1) <= cheap.b_error);
  RC_ASSERT(std::abs(cheap.peak_pressure / exact.peak_pressure - 1) <= cheap.peak_pressure_error);
  RC_ASSERT(std::abs(cheap.approach / exact.approach - 1) <= cheap.approach_error);
  RC_ASSERT(cheap.approach_error < 2e-15);
}

// Past its domain the approximation would go on, ever worse: it is refused instead.
TEST(HertzEllipseApproximation, SlenderZonesAreRefused) {
  EXPECT_THAT(
      [] { HertzEllipseApproximation::under_force(1, RelativeRadii::of(1e-5, 1), 1); },
      ::testing::ThrowsMessage<std::invalid_argument>("radius_ratio = 1e-05 is not allowed: must lie in [1e-04, 1]"));
  EXPECT_THROW(HertzEllipseApproximation::under_force(0, RelativeRadii::of(1, 1), 1), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
