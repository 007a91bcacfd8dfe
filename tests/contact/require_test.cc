#include <patchgrip/contact/require.h>

#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::contact {
namespace {

using ::testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

auto refused(const std::string& message) { return ThrowsMessage<std::invalid_argument>(message); }

TEST(Require, RefusalNamesParameterValueAndRange) {
  EXPECT_THAT([] { require_positive("radius", -1); },
              refused("radius = -1 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { require_non_negative("load", -0.5); },
              refused("load = -0.5 is not allowed: must be non-negative and finite"));
  EXPECT_THAT([] { require_finite("x", infinity); }, refused("x = inf is not allowed: must be finite"));
  EXPECT_THAT([] { require_in("nu", 0.7, -1, 0.5, Ends::left_open); },
              refused("nu = 0.7 is not allowed: must lie in (-1, 0.5]"));
}

TEST(Require, ValueIsPrintedWithTheFewestDigitsThatReadBack) {
  EXPECT_THAT([] { require_positive("a", -0.1); }, refused("a = -0.1 is not allowed: must be positive and finite"));
  EXPECT_THAT([] { require_positive("a", -1e300); },
              refused("a = -1e+300 is not allowed: must be positive and finite"));
}

TEST(Require, IntervalEndsAreAsWritten) {
  EXPECT_EQ(require_in("x", 0, 0, 1), 0);
  EXPECT_EQ(require_in("x", 1, 0, 1), 1);
  EXPECT_EQ(require_in("x", 1, 0, 1, Ends::left_open), 1);
  EXPECT_EQ(require_in("x", 0, 0, 1, Ends::right_open), 0);
  EXPECT_THAT([] { require_in("x", 0, 0, 1, Ends::left_open); }, refused("x = 0 is not allowed: must lie in (0, 1]"));
  EXPECT_THAT([] { require_in("x", 1, 0, 1, Ends::right_open); }, refused("x = 1 is not allowed: must lie in [0, 1)"));
  EXPECT_THAT([] { require_in("x", 1, 0, 1, Ends::open); }, refused("x = 1 is not allowed: must lie in (0, 1)"));
  EXPECT_THAT([] { require_in("x", 0, 0, 1, Ends::open); }, refused("x = 0 is not allowed: must lie in (0, 1)"));
  EXPECT_THAT([] { require_in("x", 2, 0, 1); }, refused("x = 2 is not allowed: must lie in [0, 1]"));
}

TEST(Require, NotANumberIsRefusedEverywhere) {
  EXPECT_THROW(require_positive("x", nan), std::invalid_argument);
  EXPECT_THROW(require_non_negative("x", nan), std::invalid_argument);
  EXPECT_THROW(require_finite("x", nan), std::invalid_argument);
  EXPECT_THROW(require_in("x", nan, -infinity, infinity), std::invalid_argument);
  EXPECT_THROW(require_representable("x", nan), std::invalid_argument);
}

TEST(Require, ResultsThatOverflowOrUnderflowAreNotRepresentable) {
  EXPECT_EQ(require_representable("x", std::numeric_limits<double>::min()), std::numeric_limits<double>::min());
  EXPECT_THROW(require_representable("x", std::numeric_limits<double>::denorm_min()), std::invalid_argument);
  EXPECT_THROW(require_representable("x", 0), std::invalid_argument);
  EXPECT_THROW(require_representable("x", infinity), std::invalid_argument);
}

TEST(Require, AllowedValueIsReturned) {
  EXPECT_EQ(require_positive("x", 2), 2);
  EXPECT_EQ(require_non_negative("x", 0), 0);
  EXPECT_EQ(require_finite("x", -3), -3);
}

}  // namespace
}  // namespace patchgrip::contact
