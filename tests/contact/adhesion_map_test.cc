#include <patchgrip/contact/adhesion/adhesion_map.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace patchgrip::contact {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

MaugisDugdale model_of(double lambda) {
  return MaugisDugdale::of(AdhesiveSphere::of(1, 0.75 / pi, 1), lambda / (2 * std::cbrt(pi)));
}

AdhesionModel cheapest(double lambda, double force_in_pi_w_R) {
  return AdhesionMap::of(model_of(lambda), pi * force_in_pi_w_R).cheapest_within(0.01);
}

TEST(AdhesionMap, HasTheRegionsOfJohnsonAndGreenwood) {
  EXPECT_EQ(cheapest(1e-3, 0), AdhesionModel::dmt);
  EXPECT_EQ(cheapest(1e2, 0), AdhesionModel::jkr);
  EXPECT_EQ(cheapest(1e2, -1.4), AdhesionModel::jkr);
  EXPECT_EQ(cheapest(0.7, 0), AdhesionModel::maugis_dugdale);
  EXPECT_EQ(cheapest(1e-3, 1e3), AdhesionModel::hertz);
  EXPECT_EQ(cheapest(1e2, 1e6), AdhesionModel::hertz);
}

TEST(AdhesionMap, ModelsWithoutContactAreInfinitelyWrong) {
  const auto tension = AdhesionMap::of(model_of(0.1), -1.9 * pi);
  EXPECT_EQ(tension.hertz_error, infinity);
  EXPECT_EQ(tension.jkr_error, infinity);
  EXPECT_LT(tension.dmt_error, 1);
  EXPECT_EQ(AdhesionMap::of(model_of(10), 0).hertz_error, infinity);
}

RC_GTEST_PROP(AdhesionMap, AnswersWithinTheTolerance, ()) {
  const auto model = model_of(std::pow(10, 1e-3 * *rc::gen::inRange(-3000, 3000)));
  const double force = pi * 1e-2 * *rc::gen::inRange(-140, 5000);
  const double tolerance = std::pow(10, 1e-3 * *rc::gen::inRange(-6000, 0));
  const auto map = AdhesionMap::of(model, force);
  switch (map.cheapest_within(tolerance)) {
    case AdhesionModel::hertz:
      RC_ASSERT(map.hertz_error <= tolerance);
      break;
    case AdhesionModel::dmt:
      RC_ASSERT(map.dmt_error <= tolerance && map.hertz_error > tolerance);
      break;
    case AdhesionModel::jkr:
      RC_ASSERT(map.jkr_error <= tolerance && map.dmt_error > tolerance);
      break;
    case AdhesionModel::maugis_dugdale:
      RC_ASSERT(map.jkr_error > tolerance && map.dmt_error > tolerance);
      break;
  }
}

TEST(AdhesionMap, OutOfRangeParametersAreRefused) {
  EXPECT_THROW(AdhesionMap::of(model_of(1), -3 * pi), std::invalid_argument);
  EXPECT_THROW(AdhesionMap::of(model_of(1), 0).cheapest_within(0), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
