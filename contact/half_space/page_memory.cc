#include <patchgrip/contact/half_space/page_memory.h>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include <algorithm>
#include <functional>
#include <iterator>

namespace patchgrip::contact {
namespace {

constexpr std::size_t page = std::size_t{1} << 21;
constexpr std::align_val_t on_a_page{page};

// A line more than needed: fields whose size is a power of two must not evict each other.
std::size_t spaced(std::size_t bytes) { return (bytes / PageMemory::alignment + 2) * PageMemory::alignment; }

}  // namespace

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__)
  std::size_t space = bytes;
  if (std::align(page, page, begin, space) != nullptr) madvise(begin, space / page * page, MADV_HUGEPAGE);
#endif
}

void PageMemory::Free::operator()(std::byte* block) const noexcept { ::operator delete(block, on_a_page); }

PageMemory::PageMemory(std::size_t bytes)
    : size_((bytes + page - 1) / page * page), block_(static_cast<std::byte*>(::operator new(size_, on_a_page))) {
  prefer_large_pages(block_.get(), size_);
  gaps_.emplace(block_.get(), size_);
}

void PageMemory::touch(std::size_t bytes, Workers& workers) {
  workers.run(static_cast<int>((std::min(bytes, size_) + page - 1) / page),
              [&](int k, int) { block_.get()[static_cast<std::size_t>(k) * page] = std::byte{}; });
}

void* PageMemory::do_allocate(std::size_t bytes, std::size_t wanted_alignment) {
  const std::size_t taken = spaced(bytes);
  const std::lock_guard guard(lock_);
  const auto gap = std::ranges::find_if(gaps_, [&](const auto& free) { return free.second >= taken; });
  if (wanted_alignment > alignment || gap == gaps_.end()) {
    return std::pmr::new_delete_resource()->allocate(bytes, wanted_alignment);
  }
  const auto [begin, size] = *gap;
  gaps_.erase(gap);
  if (size > taken) gaps_.emplace(begin + taken, size - taken);
  return begin;
}

void PageMemory::do_deallocate(void* p, std::size_t bytes, std::size_t wanted_alignment) {
  auto* begin = static_cast<std::byte*>(p);
  if (!holds(begin)) {
    std::pmr::new_delete_resource()->deallocate(p, bytes, wanted_alignment);
    return;
  }
  const std::lock_guard guard(lock_);
  const auto gap = gaps_.emplace(begin, spaced(bytes)).first;
  const auto join = [&](auto first, auto second) {
    if (first->first + first->second != second->first) return;
    first->second += second->second;
    gaps_.erase(second);
  };
  if (const auto next = std::next(gap); next != gaps_.end()) join(gap, next);
  if (gap != gaps_.begin()) join(std::prev(gap), gap);
}

}  // namespace patchgrip::contact
