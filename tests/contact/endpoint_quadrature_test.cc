#include <patchgrip/contact/endpoint_quadrature.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

#include <boost/math/constants/constants.hpp>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::Exact;

double units(double value, double exact) { return std::abs(value / exact - 1) * 0x1p53; }

TEST(EndpointQuadrature, SingularEndsAreIntegratedToRounding) {
  const auto log = integrate_to_both_ends([](double since, double) { return -std::log(since); }, 0., 1.);
  EXPECT_LE(units(log, 1), 8);
  const auto roots =
      integrate_to_both_ends([](double since, double left) { return 1 / std::sqrt(since * left); }, 3., 5.);
  EXPECT_LE(units(roots, std::numbers::pi), 8);
  const auto exact = integrate_to_both_ends(
      [](const Exact& since, const Exact& left) -> Exact { return 1 / sqrt(since * left); }, Exact(3), Exact(5));
  EXPECT_LE(abs(exact / boost::math::constants::pi<Exact>() - 1), 1e-45);
}

// Nearly singular: a pole within 1e-9 of an end.
TEST(EndpointQuadrature, NearlySingularEndsAreIntegratedToRounding) {
  for (const double near : {1e-3, 1e-6, 1e-9}) {
    const auto value = integrate_to_both_ends([=](double since, double) { return 1 / (since + near); }, 0., 1.);
    EXPECT_LE(units(value, std::log1p(1 / near)), 8) << near;
  }
}

// The error of coarse steps swings as it falls: where the pole lies decides whether two of them agree by chance.
TEST(EndpointQuadrature, AgreementByChanceIsNotTaken) {
  std::mt19937_64 engine(436);
  double worst = 0;
  for (int i = 0; i < patchgrip::testing::cases(5000); ++i) {
    const double b = patchgrip::testing::log_uniform(engine, 1e-9, 1e-2);
    const auto slope = [b](double y, double) { return (y * std::atan(y / b) + b) / std::hypot(y, b); };
    worst = std::max(worst, units(integrate_to_both_ends(slope, 0., 1.), std::hypot(1, b) * std::atan(1 / b)));
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LE(worst, 64);
}

TEST(EndpointQuadrature, BoundHoldsAlsoWhereTheIntegrandIsNotSmooth) {
  const double expected[] = {0.37, 0.62, 0.9};
  for (const double jump : expected) {
    const auto step = bounded_integral([=](double since, double) { return since < jump ? 1. : 0.; }, 0., 1.);
    EXPECT_LE(std::abs(step.value - jump), step.error);
    const auto kink = bounded_integral([=](double since, double) { return std::abs(since - jump); }, 0., 1.);
    EXPECT_LE(std::abs(kink.value - (jump * jump + (1 - jump) * (1 - jump)) / 2), kink.error);
  }
}

TEST(EndpointQuadrature, WhatIsNotFiniteInsideIsRefused) {
  const auto pole = [](double left, double right) { return 1 / std::fabs(left - right); };
  EXPECT_THROW(integrate_to_both_ends(pole, 0., 1.), std::runtime_error);
  const auto undefined = [](double left, double) { return left == 0.5 ? std::nan("") : 1.; };
  EXPECT_THROW(integrate_to_both_ends(undefined, 0., 1.), std::runtime_error);
}

TEST(EndpointQuadrature, EmptyRangeIsZero) {
  EXPECT_EQ(integrate_to_both_ends([](double, double) { return 1.; }, 1., 1.), 0);
}

}  // namespace
}  // namespace patchgrip::contact
