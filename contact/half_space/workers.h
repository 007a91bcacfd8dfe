// Threads that share the parts of a loop.
//
// run() hands out the parts 0 ... parts - 1 to its threads, the calling one among them, and returns when all are done.
// Each has a share of neighbouring parts, the same in all loops of as many parts: its cache has seen them, and what it
// reads ahead is its own. It takes them in order, then what is left of other shares: a thread that the machine does not
// let run is not waited for. Who takes a part is so left to chance, and it must not care: results then do not depend on
// the number of threads. Nothing is allocated.
//
// Domain   1 <= threads <= 64; a part must not throw. run() is for one caller at a time if there are several
//          threads.
// Throws   std::invalid_argument outside the domain, std::system_error when a thread cannot be started.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

namespace patchgrip::contact {

class Workers {
 public:
  static constexpr int most_threads = 64;

  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const noexcept { return static_cast<int>(shares_.size()); }

  // part(index, thread), thread in [0, count()).
  template <class Part>
  void run(int parts, const Part& part) {
    if (threads_.empty() || parts <= 1) {
      for (int i = 0; i < parts; ++i) part(i, 0);
      return;
    }
    share(
        parts,
        [](const void* function, int index, int thread) { (*static_cast<const Part*>(function))(index, thread); },
        std::addressof(part));
  }

  // act(row, thread) for the rows 0 ... rows - 1, a few at a time.
  template <class Act>
  void each_row(int rows, const Act& act) {
    constexpr int at_once = 8;
    run((rows + at_once - 1) / at_once, [&](int part, int thread) {
      const int end = std::min(rows, (part + 1) * at_once);
      for (int row = part * at_once; row < end; ++row) act(row, thread);
    });
  }

 private:
  using Call = void (*)(const void* part, int index, int thread);

  void share(int parts, Call call, const void* part);
  void take_parts(int thread);
  std::uint32_t take_share(int share, int thread);  // how many parts it took
  // The first part of a thread's share.
  int begin(int thread) const noexcept {
    return static_cast<int>(static_cast<std::int64_t>(parts_) * thread / count());
  }
  void serve(int thread);
  void stop() noexcept;

  static constexpr std::size_t line = 64;  // of the cache: what one thread writes must not disturb who reads another

  alignas(line) Call call_ = nullptr;
  const void* part_ = nullptr;
  int parts_ = 0;
  std::atomic<std::uint32_t> round_ = 0;  // a change wakes the threads
  std::atomic<bool> stopped_ = false;
  struct alignas(line) Share {
    // The round in the upper half, how many parts are left to take in the lower.
    std::atomic<std::uint64_t> tickets = 0;
  };

  alignas(line) std::atomic<std::uint32_t> undone_ = 0;  // parts of this round
  std::vector<Share> shares_;
  std::vector<std::thread> threads_;
};

}  // namespace patchgrip::contact
