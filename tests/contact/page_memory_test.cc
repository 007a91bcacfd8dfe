#include <patchgrip/contact/half_space/page_memory.h>
#include <patchgrip/contact/half_space/resources.h>

#if defined(__linux__)
#include <malloc.h>
#include <sys/mman.h>
#endif

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/support/cases.h>

namespace patchgrip::contact {
namespace {

constexpr std::size_t block = std::size_t{1} << 21;  // the least that PageMemory takes
constexpr std::size_t line = PageMemory::alignment;

struct Taken {
  unsigned char* begin;
  std::size_t bytes;
  unsigned char mark;
};

// Each keeps what was written into it, whatever the others do, also beyond the block.
TEST(PageMemory, NothingOverlaps) {
  std::mt19937_64 engine(20061205);
  PageMemory memory(1);
  std::vector<Taken> taken;
  for (int k = 0; k < patchgrip::testing::cases(4000); ++k) {
    const bool takes = taken.empty() || std::uniform_real_distribution<double>(0, 1)(engine) < 0.52;
    if (takes) {
      const std::size_t bytes = std::uniform_int_distribution<std::size_t>(0, block / 8)(engine);
      auto* begin = static_cast<unsigned char*>(memory.allocate(bytes, line));
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(begin) % line, 0U);
      taken.push_back({begin, bytes, static_cast<unsigned char>(k)});
      std::fill_n(begin, bytes, taken.back().mark);
    } else {
      std::swap(taken[std::uniform_int_distribution<std::size_t>(0, taken.size() - 1)(engine)], taken.back());
      const auto [begin, bytes, mark] = taken.back();
      ASSERT_TRUE(std::all_of(begin, begin + bytes, [mark = mark](unsigned char c) { return c == mark; }));
      memory.deallocate(begin, bytes, line);
      taken.pop_back();
    }
  }
  for (const auto& [begin, bytes, mark] : taken) memory.deallocate(begin, bytes, line);
}

// Given back in any order, pieces become one again: it fits where it was.
TEST(PageMemory, WhatIsGivenBackServesAgain) {
  std::mt19937_64 engine(20061206);
  PageMemory memory(1);
  const std::size_t most = block - 2 * line;
  void* const all = memory.allocate(most, line);
  memory.deallocate(all, most, line);
  for (int round = 0; round < 20; ++round) {
    std::vector<Taken> taken;
    for (std::size_t k = 0; k < 16; ++k) {
      taken.push_back({static_cast<unsigned char*>(memory.allocate(block / 20, line)), block / 20, 0});
    }
    std::ranges::shuffle(taken, engine);
    for (const Taken& piece : taken) memory.deallocate(piece.begin, piece.bytes, line);
    EXPECT_EQ(memory.allocate(most, line), all);
    memory.deallocate(all, most, line);
  }
}

TEST(PageMemory, HeapHelpsOut) {
  PageMemory memory(1);
  const std::size_t bytes = 3 * block;
  void* const large = memory.allocate(bytes, line);
  std::memset(large, 1, bytes);
  memory.deallocate(large, bytes, line);
}

TEST(Array, GivesItsMemoryBackOnce) {
  PageMemory memory(1);
  const double* place = nullptr;
  {
    Array<double> one(1000, memory), other(10, memory);
    place = one.data();
    other = std::move(one);
    EXPECT_EQ(other.data(), place);
    EXPECT_EQ(other.size(), 1000U);
  }
  EXPECT_EQ(Array<double>(1000, memory).data(), place);
}

TEST(PageMemory, ThreadsTakeAndGiveBackAtTheSameTime) {
  PageMemory memory(1);
  Workers workers(3);
  std::atomic<int> torn = 0;
  workers.run(patchgrip::testing::cases(3000), [&](int k, int) {
    const std::size_t bytes = line * static_cast<std::size_t>(1 + k % 300);
    auto* begin = static_cast<unsigned char*>(memory.allocate(bytes, line));
    const auto mark = static_cast<unsigned char>(k);
    std::fill_n(begin, bytes, mark);
    torn += std::all_of(begin, begin + bytes, [mark](unsigned char c) { return c == mark; }) ? 0 : 1;
    memory.deallocate(begin, bytes, line);
  });
  EXPECT_EQ(torn, 0);
  void* const all = memory.allocate(block - 2 * line, line);  // all pieces are one again
  memory.deallocate(all, block - 2 * line, line);
  EXPECT_EQ(memory.allocate(block - 2 * line, line), all);
  memory.deallocate(all, block - 2 * line, line);
}

#if defined(__linux__)
// The sanitizer touches the first page of whatever is allocated, and always asks for fresh ones.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t touched_before = 1;
#else
constexpr std::size_t touched_before = 0;
#endif

// Of a block so large that the heap has not used it before.
TEST(PageMemory, TouchesWhatItIsToldAndNoMore) {
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
  // Else the C library may hand on pages that were given back to it, touched already.
  ASSERT_EQ(mallopt(M_MMAP_THRESHOLD, static_cast<int>(block)), 1);
#endif
  constexpr std::size_t pages = 40;
  for (const int threads : {1, 3}) {
    for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, 3 * block, 3 * block + 1, 1000 * block}) {
      PageMemory memory(pages * block);
      Workers workers(threads);
      memory.touch(bytes, workers);
      auto* const begin = static_cast<std::byte*>(memory.allocate(1, line));
      for (std::size_t k = touched_before; k < pages; ++k) {
        unsigned char resident = 0;
        ASSERT_EQ(mincore(begin + k * block, 1, &resident), 0);
        EXPECT_EQ(resident & 1, k * block < bytes ? 1 : 0) << k << " of " << bytes;
      }
      memory.deallocate(begin, 1, line);
    }
  }
}
#endif

}  // namespace
}  // namespace patchgrip::contact
