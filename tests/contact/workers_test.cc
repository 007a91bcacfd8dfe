#include <patchgrip/contact/half_space/pieces.h>
#include <patchgrip/contact/half_space/workers.h>

#include <atomic>
#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace patchgrip::contact {
namespace {

TEST(Workers, DoEveryPartOnce) {
  for (const int threads : {1, 2, 5}) {
    Workers workers(threads);
    EXPECT_EQ(workers.count(), threads);
    for (int round = 0; round < 300; ++round) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(round % 40));
      workers.run(round % 40, [&](int part, int thread) {
        EXPECT_GE(thread, 0);
        EXPECT_LT(thread, threads);
        ++done[static_cast<std::size_t>(part)];
      });
      for (const auto& count : done) ASSERT_EQ(count, 1);
    }
  }
}

TEST(Workers, NoTwoPartsShareAThreadAtOnce) {
  Workers workers(4);
  std::vector<std::atomic<bool>> busy(4);
  workers.run(2000, [&](int, int thread) {
    EXPECT_FALSE(busy[static_cast<std::size_t>(thread)].exchange(true));
    busy[static_cast<std::size_t>(thread)] = false;
  });
}

TEST(Workers, TakeEveryRowOnce) {
  Workers workers(3);
  for (const int rows : {0, 1, 8, 9, 1000}) {
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(rows));
    workers.each_row(rows, [&](int row, int) { ++done[static_cast<std::size_t>(row)]; });
    for (const auto& count : done) ASSERT_EQ(count, 1);
  }
}

TEST(Workers, NumberOfThreadsIsLimited) {
  EXPECT_THAT([] { Workers workers(0); },
              ::testing::ThrowsMessage<std::invalid_argument>("threads = 0 is not allowed: must lie in [1, 64]"));
  EXPECT_THROW(Workers(65), std::invalid_argument);
}

TEST(Pieces, SumsDoNotDependOnTheThreads) {
  for (const std::size_t size : {std::size_t{1}, std::size_t{8192}, std::size_t{100001}}) {
    std::vector<Tally> totals;
    for (const int threads : {1, 3}) {
      Workers workers(threads);
      Pieces pieces(size, workers);
      totals.push_back(pieces.total([](std::size_t begin, std::size_t count) {
        Tally tally;
        for (std::size_t i = begin; i < begin + count; ++i) {
          tally.sums[0] += 1;
          tally.sums[6] += std::sin(static_cast<double>(i));
          tally.largest = std::max(tally.largest, std::fmod(static_cast<double>(i), 977));
        }
        return tally;
      }));
    }
    EXPECT_EQ(totals[0].sums[0], static_cast<double>(size));
    EXPECT_EQ(totals[0].sums, totals[1].sums);
    EXPECT_EQ(totals[0].largest, std::min(static_cast<double>(size - 1), 976.));
  }
}

}  // namespace
}  // namespace patchgrip::contact
