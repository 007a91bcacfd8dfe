#include <patchgrip/contact/power_sum.h>

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

#include <patchgrip/tests/contact/profile_errors.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::contact {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::Exact;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;

static_assert(Profile<PowerSum>);

PowerSum drawn(std::mt19937_64& engine) {
  std::vector<PowerProfile> powers;
  for (int k = 0; k < 3; ++k) {
    powers.push_back(PowerProfile::through(log_uniform(engine, 1e-4, 1), 1, log_uniform(engine, 0.2, 12)));
  }
  return PowerSum::of(std::move(powers));
}

// Newton in fifty digits, from the answer in double.
template <class Value, class Slope>
Exact refined(double start, const Exact& target, const Value& value, const Slope& slope) {
  Exact x(start);
  for (int i = 0; i < 3; ++i) x -= (value(x) - target) / slope(x);
  return x;
}

TEST(PowerSum, StatedErrorsHold) {
  std::mt19937_64 engine(434);
  patchgrip::testing::WorstErrors worst;
  for (int i = 0; i < cases(60); ++i) {
    const auto profile = drawn(engine);
    const double a = log_uniform(engine, 1e-3, 10);
    const double inside = i % 2 == 0 ? a * uniform(engine, 0, 1) : a * (1 - log_uniform(engine, 1e-15, 1));
    worst.of_functions(profile, a, inside, a * (1 + log_uniform(engine, 1e-15, 1e6)));
    const double f = log_uniform(engine, 1e-12, 1e6);
    const double d = log_uniform(engine, 1e-12, 1e6);
    const auto slope = [&](const Exact& x) -> Exact { return profile.approach_slope(x); };
    worst.of_inversions(
        profile, f,
        refined(
            profile.radius_of_force(f), f, [&](const Exact& x) { return profile.force(x); },
            [&](const Exact& x) -> Exact { return 2 * x * slope(x); }),
        d,
        refined(
            profile.radius_of_approach(d), d, [&](const Exact& x) { return profile.approach(x); }, slope));
  }
  worst.expect_within_stated();
}

RC_GTEST_PROP(PowerSum, SuperposesAtEqualRadius, ()) {
  const double a = *rc::gen::map(rc::gen::inRange(1, 3000), [](int i) { return 1e-3 * i; });
  const double rho = *rc::gen::map(rc::gen::inRange(1, 999), [](int i) { return 1e-3 * i; });
  const auto one = PowerProfile::of_coefficient(0.3, 1.5);
  const auto other = PowerProfile::of_coefficient(0.1, 4);
  const auto both = PowerSum::of({one, other});
  RC_ASSERT(both.force(a) == one.force(a) + other.force(a));
  RC_ASSERT(both.approach(a) == one.approach(a) + other.approach(a));
  RC_ASSERT(both.pressure(rho * a, a) == one.pressure(rho * a, a) + other.pressure(rho * a, a));
  RC_ASSERT(both.displacement(a / rho, a) == one.displacement(a / rho, a) + other.displacement(a / rho, a));
}

TEST(PowerSum, OfOnePowerIsThatPower) {
  const auto power = PowerProfile::of_coefficient(0.3, 1.5);
  const auto sum = PowerSum::of({power});
  EXPECT_NEAR(sum.radius_of_force(1e-3) / power.radius_of_force(1e-3), 1, 1e-15);
  EXPECT_NEAR(sum.radius_of_approach(1e-3) / power.radius_of_approach(1e-3), 1, 1e-15);
}

TEST(PowerSum, OutOfRangeParametersAreNamed) {
  EXPECT_THAT([] { PowerSum::of({}); }, ::testing::ThrowsMessage<std::invalid_argument>(
                                            "number of powers = 0 is not allowed: must lie in [1, 1000]"));
  EXPECT_THAT([] { PowerSum::sphere_series(1, 0); },
              ::testing::ThrowsMessage<std::invalid_argument>("terms = 0 is not allowed: must lie in [1, 500]"));
  EXPECT_THROW(PowerSum::sphere_series(-1, 2), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::contact
