// Counts every operator new of the program that includes it, in one of its sources.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace patchgrip::testing {

inline std::atomic<long> allocations = 0;

inline void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* p = std::aligned_alloc(alignment, rounded > 0 ? rounded : alignment)) return p;
  throw std::bad_alloc();
}

template <class Function>
long allocations_of(const Function& function) {
  const long before = allocations;
  function();
  return allocations - before;
}

}  // namespace patchgrip::testing

// Not inlined: GCC would take free() for a mismatch of new.
[[gnu::noinline]] void* operator new(std::size_t size) {
  return patchgrip::testing::counted(size, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return patchgrip::testing::counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
