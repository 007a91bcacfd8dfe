#include <patchgrip/contact/half_space/pieces.h>
#include <patchgrip/contact/half_space/workers.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
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

// Nobody goes on before all have begun.
TEST(Workers, EachBeginsWithItsOwnShare) {
  constexpr int threads = 3;
  Workers workers(threads);
  for (int round = 0; round < 50; ++round) {
    std::array<int, threads> first{-1, -1, -1};
    std::atomic<int> begun = 0;
    workers.run(31, [&](int part, int thread) {
      int& mine = first[static_cast<std::size_t>(thread)];
      if (mine >= 0) return;
      mine = part;
      for (++begun; begun < threads;) std::this_thread::yield();
    });
    EXPECT_THAT(first, ::testing::ElementsAre(0, 10, 20));
  }
}

TEST(Workers, TakeTheirShareInOrder) {
  Workers workers(2);
  for (int round = 0; round < 300; ++round) {
    std::array<int, 2> own{-1, 99};  // the last part taken of the own share
    workers.run(200, [&](int part, int thread) {
      if (part / 100 != thread) return;
      EXPECT_GT(part, std::exchange(own[static_cast<std::size_t>(thread)], part));
    });
  }
}

// The first part of a share ends last.
TEST(Workers, WhatIsLeftOfAShareIsTakenByOthers) {
  Workers workers(3);
  for (const int held : {0, 10, 20}) {
    std::atomic<int> others = 0;
    workers.run(30, [&](int part, int) {
      if (part != held) {
        ++others;
        return;
      }
      const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
      while (others < 29 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
      EXPECT_EQ(others, 29);
    });
  }
}

// After a pause the threads sleep.
TEST(Workers, WakeUpAgain) {
  Workers workers(3);
  for (int round = 0; round < 5; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    std::atomic<int> begun = 0;
    workers.run(3, [&](int, int) {
      for (++begun; begun < 3;) std::this_thread::yield();
    });
    EXPECT_EQ(begun, 3);
  }
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
