#include <patchgrip/contact/increasing_root.h>

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

namespace patchgrip::contact {
namespace {

double drawn(int lo, int hi) {
  return *rc::gen::map(rc::gen::inRange(lo * 1000, hi * 1000), [](int i) { return std::pow(10, 1e-3 * i); });
}

RC_GTEST_PROP(IncreasingRoot, PowersAreExactFromAnyStart, ()) {
  const double m = drawn(-1, 2);
  const double truth = drawn(-3, 3) / 10;
  const double start = drawn(-6, 6);
  int evaluations = 0;
  const auto value = [&](double x) {
    ++evaluations;
    return std::pow(x, m);
  };
  const double root = increasing_root(
      value, [&](double x) { return m * std::pow(x, m - 1); }, std::pow(truth, m), start);
  RC_ASSERT(std::abs(root / truth - 1) <= (2 / m + 4) * 0x1p-52);
  if (m < 20) RC_ASSERT(evaluations < 40);
}

RC_GTEST_PROP(IncreasingRoot, SumsOfPowersAreSolvedToRounding, ()) {
  const double target = drawn(-12, 12);
  const auto value = [](double x) { return x + 3 * x * x * x; };
  const double root = increasing_root(
      value, [](double x) { return 1 + 9 * x * x; }, target, drawn(-3, 3));
  RC_ASSERT(std::abs(value(root) / target - 1) <= 4 * 0x1p-52);
}

// A wrong or infinite slope costs steps, not digits.
TEST(IncreasingRoot, BisectsWhereTheSlopeIsUseless) {
  const auto value = [](double x) { return x < 1 ? x : x + std::sqrt(x - 1); };
  for (const double slope : {std::numeric_limits<double>::infinity(), 0., 1e-9}) {
    const double root = increasing_root(
        value, [=](double) { return slope; }, 2., 1.);
    EXPECT_NEAR(value(root), 2, 1e-14);
  }
}

TEST(IncreasingRoot, StaysWithinItsBounds) {
  const double root = increasing_root([](double x) { return x * x; }, [](double x) { return 2 * x; }, 4., 1.5, 1., 1.9);
  EXPECT_NEAR(root, 1.9, 1e-15);
}

TEST(IncreasingRoot, NoRootIsAnError) {
  EXPECT_THROW(increasing_root([](double) { return 1.; }, [](double) { return 0.; }, 2., 1.), std::runtime_error);
}

}  // namespace
}  // namespace patchgrip::contact
