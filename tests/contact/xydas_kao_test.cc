#include <patchgrip/contact/fingertip/xydas_kao.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include <patchgrip/contact/hertz_circle.h>
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

TEST(XydasKaoPressure, AgreesWithTheTable) {
  const auto rows = contact_rows("xydas_kao_468");
  ASSERT_EQ(rows.size(), 5U);
  for (const auto& row : rows) {
    const auto p = XydasKaoPressure::of(row.input("F_N"), row.input("a_K"), row.input("alpha"));
    EXPECT_LE(units_of_rounding(p.peak_pressure, row.output("p0")), 4);
    EXPECT_LE(units_of_rounding(p.pressure(row.input("r")), row.output("p_at_r")), 6);
  }
}

// The seed's own form, in fifty digits.
TEST(XydasKaoPressure, HoldsItsBound) {
  std::mt19937_64 engine(20060270);
  const Exact pi = boost::math::constants::pi<Exact>();
  double worst_peak = 0, worst_pressure = 0;
  for (int i = 0; i < cases(500); ++i) {
    const double alpha = log_uniform(engine, 0.5, i % 2 == 0 ? 50 : 1e6);
    const double force = log_uniform(engine, 1e-12, 1e12), a = log_uniform(engine, 1e-9, 1e3);
    const auto p = XydasKaoPressure::of(force, a, alpha);
    const Exact n(alpha);
    const Exact factor =
        n * boost::math::tgamma(Exact(3 / n)) / (boost::math::tgamma(Exact(1 / n)) * boost::math::tgamma(Exact(2 / n)));
    worst_peak = std::max(worst_peak, units_of_rounding(p.peak_pressure, 3 * Exact(force) / (2 * pi * a * a) * factor));
    if (i % 2 == 0) {
      const double r = i % 4 == 0 ? a * uniform(engine, 0, 1) : a * (1 - log_uniform(engine, 1e-14, 1));
      const Exact exact = p.peak_pressure * pow(1 - pow(Exact(r) / a, n), 1 / n);
      if (r < a) worst_pressure = std::max(worst_pressure, units_of_rounding(p.pressure(r), exact));
    }
  }
  RecordProperty("worst_units_peak", std::to_string(worst_peak));
  RecordProperty("worst_units_pressure", std::to_string(worst_pressure));
  EXPECT_LE(worst_peak, 1.1);
  EXPECT_LE(worst_pressure, 1.1);
}

RC_GTEST_PROP(XydasKaoPressure, CarriesTheForce, ()) {
  const double alpha = 1e-2 * *rc::gen::inRange(50, 5000);
  const auto p = XydasKaoPressure::of(3, 0.006, alpha);
  boost::math::quadrature::tanh_sinh<double> integrate;
  const double carried =
      integrate.integrate([&](double r) { return 2 * std::numbers::pi * r * p.pressure(r); }, 0., 0.006);
  RC_ASSERT(std::abs(carried / 3 - 1) < 1e-6);
}

TEST(XydasKaoPressure, IsHertzForTwoAndUniformForLargeAlpha) {
  const auto circle = HertzCircle::under_force(3, 0.02, 66666);
  const auto p = XydasKaoPressure::of(3, circle.radius, 2);
  EXPECT_NEAR(p.peak_pressure / circle.peak_pressure, 1, 5e-16);
  EXPECT_NEAR(p.pressure(0.6 * circle.radius) / circle.peak_pressure, 0.8, 1e-15);
  EXPECT_NEAR(XydasKaoPressure::of(3, 0.01, 1e6).peak_pressure / (3 / (std::numbers::pi * 1e-4)), 1, 1e-11);
}

RC_GTEST_PROP(XydasKaoPressure, FallsFromThePeakToTheRim, ()) {
  const auto p = XydasKaoPressure::of(3, 1, 1e-2 * *rc::gen::inRange(50, 5000));
  const double r = 1e-3 * *rc::gen::inRange(0, 999);
  RC_ASSERT(p.pressure(r + 1e-3) <= p.pressure(r));
  RC_ASSERT(p.pressure(0) == p.peak_pressure);
  RC_ASSERT(p.pressure(1) == 0);
}

TEST(XydasKaoPressure, OutOfRangeParametersAreRefused) {
  EXPECT_THROW(XydasKaoPressure::of(0, 1, 2), std::invalid_argument);
  EXPECT_THROW(XydasKaoPressure::of(1, 1, 0.4), std::invalid_argument);
  EXPECT_THROW(XydasKaoPressure::of(1, 1, 2e6), std::invalid_argument);
  EXPECT_THROW(XydasKaoPressure::of(1, 1, 2).pressure(-1), std::invalid_argument);
  EXPECT_THROW(XydasKaoPressure::of(1, 1, 2).pressure(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
