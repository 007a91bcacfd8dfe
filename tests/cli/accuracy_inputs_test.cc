#include <patchgrip/cli/accuracy/inputs.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace patchgrip::cli {
namespace {

constexpr double unit = 0x1p-53;

// Error of `f` at the double next to `x` against its value at x itself.
template <class F>
Deviation error_of(F f, const Exact& x, const Exact& reference) {
  const auto q = measure([&](Inputs inputs) { return std::array{f(as_double(x, inputs))}; });
  return deviation(q, 0, reference, abs(reference));
}

TEST(AccuracyInputs, RoundingOfAnIllConditionedArgumentIsTakenOut) {
  const Exact x("1.000001");
  const Deviation error = error_of([](double t) { return std::log(t); }, x, log(x));
  EXPECT_GT(error.as_is, 1e4 * unit);
  EXPECT_LT(error.own, 2 * unit);
}

TEST(AccuracyInputs, RoundingIsTakenOutNearASingularity) {
  const Exact x("1.000000000001");
  const Deviation error = error_of([](double t) { return 1 + std::log(t - 1) / 64; }, x, 1 + log(x - 1) / 64);
  EXPECT_GT(error.as_is, 1e-8);
  EXPECT_LT(error.own, error.as_is / 50);
}

TEST(AccuracyInputs, AnErrorOfTheFunctionStays) {
  const Exact x("0.1");
  const Deviation error = error_of([](double t) { return std::exp(t) * (1 + 1e-9); }, x, exp(x));
  EXPECT_NEAR(error.as_is, 1e-9, 1e-14);
  EXPECT_NEAR(error.own, 1e-9, 1e-14);
}

TEST(AccuracyInputs, NoiseOfTheFunctionStays) {
  const Exact x("0.1");
  const Deviation error = error_of([](double t) { return t + 1e-9 * std::sin(1e30 * t); }, x, x);
  EXPECT_GT(error.own, 1e-11);
}

TEST(AccuracyInputs, ExactInputsAreNotMoved) {
  for (const Inputs inputs : {Inputs::rounded, Inputs::narrow_beyond, Inputs::wide_before})
    EXPECT_EQ(as_double(0.1, inputs), 0.1);
  EXPECT_TRUE(rounds_to_itself(Exact(0.1)));
  EXPECT_FALSE(rounds_to_itself(Exact("0.1")));
}

TEST(AccuracyInputs, WhatIsNotFiniteIsInfinitelyWrong) {
  for (const double value : {std::nan(""), HUGE_VAL}) {
    const auto q = measure([&](Inputs) { return std::array{1.0, value}; });
    EXPECT_EQ(deviation(q, 0, std::array<Exact, 2>{1, 1}, 1).as_is, HUGE_VAL);
    EXPECT_EQ(deviation(q, 0, std::array<Exact, 2>{1, 1}, 1).own, HUGE_VAL);
  }
}

TEST(AccuracyInputs, WhereMovedInputsAreRefusedNothingIsTakenOut) {
  const Exact x("0.1");
  const auto q = measure([&](Inputs inputs) {
    if (inputs != Inputs::rounded) throw std::domain_error("refused");
    return std::array{as_double(x, inputs)};
  });
  const Deviation error = deviation(q, 0, x, 1);
  EXPECT_GT(error.as_is, 0);
  EXPECT_EQ(error.own, error.as_is);
}

}  // namespace
}  // namespace patchgrip::cli
