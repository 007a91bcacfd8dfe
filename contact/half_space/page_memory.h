// Memory for the fields of one solution: one block on large pages, handed out first fit.
//
// The first touch of a page costs microseconds, on small pages more than all the work on them. Large pages (Linux:
// 2 MiB, where the system gives them on advice) cost a fiftieth for each byte, and what one grid gives back serves the
// next one without another touch. Address space that nobody asks for is never touched. When the block is full, the heap
// helps out.
//
// Threads may allocate at the same time, but not touch().
//
// Domain   alignments up to that of a line of the cache.
// Throws   std::bad_alloc.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <memory_resource>
#include <mutex>
#include <new>

#include <patchgrip/contact/half_space/workers.h>

namespace patchgrip::contact {

// Asks for large pages in memory that nobody has touched yet; nothing happens where there are none.
void prefer_large_pages(void* begin, std::size_t bytes) noexcept;

class PageMemory : public std::pmr::memory_resource {
 public:
  static constexpr std::size_t alignment = 64;

  explicit PageMemory(std::size_t bytes);

  // Touches the first `bytes`, not in use yet: two threads that meet on a page would both clear it.
  void touch(std::size_t bytes, Workers& workers);

 private:
  struct Free {
    void operator()(std::byte* block) const noexcept;
  };

  void* do_allocate(std::size_t bytes, std::size_t alignment) override;
  void do_deallocate(void* p, std::size_t bytes, std::size_t alignment) override;
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
  bool holds(const std::byte* p) const noexcept { return p >= block_.get() && p < block_.get() + size_; }

  std::size_t size_;
  std::unique_ptr<std::byte, Free> block_;
  std::mutex lock_;
  std::map<std::byte*, std::size_t> gaps_;  // free bytes from each address on, never side by side
};

}  // namespace patchgrip::contact
