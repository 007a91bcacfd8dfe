#include <patchgrip/cli/scene/sequence.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace patchgrip::cli {
namespace {

TEST(Sequence, ListIsItself) {
  const Sequence list = Sequence::of_values({3, 1, 2});
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0], 3);
  EXPECT_EQ(list[2], 2);
}

TEST(Sequence, RangeHasExactEnds) {
  const Sequence steps = Sequence::equal_steps(0.1, 0.7, 1000);
  EXPECT_EQ(steps[0], 0.1);
  EXPECT_EQ(steps[999], 0.7);
  const Sequence ratios = Sequence::equal_ratios(0.1, 0.7, 1000);
  EXPECT_EQ(ratios[0], 0.1);
  EXPECT_EQ(ratios[999], 0.7);
}

RC_GTEST_PROP(Sequence, SymmetricRangeHasAnExactZero, ()) {
  const double end = std::ldexp(1 + *rc::gen::inRange(0, 1'000'000) * 1e-6, *rc::gen::inRange(-60, 60));
  const auto half = static_cast<std::size_t>(*rc::gen::inRange(1, 100'000));
  const Sequence range = Sequence::equal_steps(-end, end, 2 * half + 1);
  RC_ASSERT(range[half] == 0);
}

RC_GTEST_PROP(Sequence, RangesGrowStrictly, ()) {
  const double from = 1e-3 * *rc::gen::inRange(1, 1000);
  const double to = from * (1 + 1e-2 * *rc::gen::inRange(1, 1000));
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(2, 10'000));
  const auto i = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(count) - 1));
  for (const Sequence& range : {Sequence::equal_steps(from, to, count), Sequence::equal_ratios(from, to, count)}) {
    RC_ASSERT(range[i] < range[i + 1]);
    RC_ASSERT(from <= range[i]);
    RC_ASSERT(range[i + 1] <= to);
  }
}

TEST(Sequence, NegativeEndsMayHaveEqualRatios) {
  const Sequence range = Sequence::equal_ratios(-1, -100, 3);
  EXPECT_NEAR(range[1], -10, 1e-14);
}

}  // namespace
}  // namespace patchgrip::cli
