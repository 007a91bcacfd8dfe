#include <patchgrip/contact/round_pressure.h>

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

#include <patchgrip/contact/cone.h>
#include <patchgrip/contact/flat_punch.h>
#include <patchgrip/contact/power_profile.h>
#include <patchgrip/contact/rotational_pressure.h>
#include <patchgrip/contact/sphere.h>
#include <patchgrip/tests/support/cases.h>

#include <boost/math/special_functions/ellint_2.hpp>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;

auto refused(const std::string& message) { return ::testing::ThrowsMessage<std::invalid_argument>(message); }

void expect_bounded(const Estimate& result, double truth) {
  EXPECT_LE(std::abs(result.value - truth), result.error + 4e-15 * std::abs(truth));
  EXPECT_LE(result.error, 1e-11 * std::abs(truth));
}

const double points[] = {0., 0.2, 0.55, 0.999, 1., 1.001, 1.6, 30.};

TEST(RoundPressure, FindsTheFamilyOfHertz) {
  for (const int n : {1, 2, 4}) {
    const auto family = RotationalPressure::of_curvature(n, 1, 2, 3);
    const auto given = RoundPressure::of(
        1, 3, [&](double r, double left) { return family.peak_pressure * std::pow(left * (1 + r), n - 0.5); });
    expect_bounded(given.force(), family.force);
    for (const double r : points) expect_bounded(given.displacement(r), family.displacement(r));
  }
}

TEST(RoundPressure, FindsTheFlatPunch) {
  const auto punch = FlatPunch::under_force(1, 2, 3);
  const auto given =
      RoundPressure::of(1, 3, [](double r, double left) { return 1 / (std::numbers::pi * std::sqrt(left * (1 + r))); });
  expect_bounded(given.force(), punch.force);
  for (const double r : points) expect_bounded(given.displacement(r), punch.displacement(r));
  for (const double r : {0.3, 0.9}) {
    const Estimate f = given.height(r);
    EXPECT_LE(std::abs(f.value), f.error);
  }
}

// The forward and the inverse problem are inverse: cone (a singular tip), blunt power, exact sphere.
TEST(RoundPressure, UndoesTheForwardProblem) {
  const auto check = [](const auto& profile, double a) {
    const auto given = RoundPressure::of(a, 1, [&](double r, double) { return r < a ? profile.pressure(r, a) : 0; });
    expect_bounded(given.force(), profile.force(a));
    for (const double rho : {0.1, 0.6, 1.3, 5.}) {
      const Estimate u = given.displacement(rho * a);
      // The profile knows r, not a - r: its rounding next to the rim is not seen.
      EXPECT_NEAR(u.value, profile.displacement(rho * a, a), u.error + 1e-12 * profile.approach(a));
    }
    const Estimate f = given.height(0.6 * a);
    EXPECT_NEAR(f.value, profile.height(0.6 * a), f.error + 2e-12 * profile.approach(a));
  };
  check(Cone::of_slope(0.4), 0.7);
  check(PowerProfile::of_coefficient(2, 2.7), 0.7);
  check(Sphere::of_radius(1), 0.7);
}

// Uniform pressure, Johnson 3.29a: u_z = (4 p a / (pi E*)) E(r/a).
TEST(RoundPressure, FindsTheDishUnderAUniformPressure) {
  const auto given = RoundPressure::of(2, 3, [](double, double) { return 5.; });
  expect_bounded(given.force(), 5 * std::numbers::pi * 4);
  for (const double r : {0., 0.4, 1.5, 1.999}) {
    expect_bounded(given.displacement(r), 4 * 5 * 2 / (std::numbers::pi * 3) * boost::math::ellint_2(r / 2));
  }
}

TEST(RoundPressure, FarAwayIsAPointLoad) {
  const auto given = RoundPressure::of(1, 1, [](double r, double) { return 1 + r; });
  const double F = given.force().value;
  EXPECT_NEAR(given.displacement(1e7).value * std::numbers::pi * 1e7 / F, 1, 1e-12);
}

// A jump inside is beyond the rule: the bound grows by orders, and still holds.
TEST(RoundPressure, JumpInsideIsNoticed) {
  const auto ring = RoundPressure::of(1, 1, [](double r, double) { return r < 0.37 ? 0. : 1.; });
  const Estimate F = ring.force();
  EXPECT_GT(F.error, 1e-9);
  EXPECT_LE(std::abs(F.value - std::numbers::pi * (1 - 0.37 * 0.37)), F.error);
}

TEST(RoundPressure, BadInputIsNamed) {
  const auto one = [](double, double) { return 1.; };
  EXPECT_THAT([&] { RoundPressure::of(0, 1, one); },
              refused("contact_radius = 0 is not allowed: must be positive and finite"));
  EXPECT_THAT([&] { RoundPressure::of(1, -1, one); },
              refused("contact_modulus = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT([&] { RoundPressure::of(1, 1, one).displacement(-1); },
              refused("r = -1 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([&] { RoundPressure::of(1, 1, one).height(1.1); }, refused("r = 1.1 is not allowed: must lie in [0, 1]"));
  EXPECT_THROW(RoundPressure::of(1, 1, [](double, double) { return std::nan(""); }).force(), std::runtime_error);
}

}  // namespace
}  // namespace patchgrip::contact
