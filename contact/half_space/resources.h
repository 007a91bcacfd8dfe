// What a solution works with: threads, and memory for its fields; others may set it up while the threads are busy.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <span>
#include <type_traits>
#include <utility>

#include <patchgrip/contact/half_space/page_memory.h>
#include <patchgrip/contact/half_space/workers.h>

namespace patchgrip::contact {

struct Resources {
  Workers& workers;
  std::pmr::memory_resource& memory = *std::pmr::get_default_resource();
  Workers& set_up = workers;  // not more than workers
};

// Numbers without a value at first: the thread that works on them touches them first.
template <class Number>
class Array {
  static_assert(std::is_trivially_destructible_v<Number>);

 public:
  Array() = default;
  Array(std::size_t size, std::pmr::memory_resource& memory)
      : memory_(&memory),
        size_(size),
        data_(static_cast<Number*>(memory.allocate(size * sizeof(Number), PageMemory::alignment))) {}
  ~Array() {
    if (data_ != nullptr) memory_->deallocate(data_, size_ * sizeof(Number), PageMemory::alignment);
  }
  Array(Array&& other) noexcept { swap(other); }
  Array& operator=(Array&& other) noexcept {
    swap(other);
    return *this;
  }

  std::size_t size() const noexcept { return size_; }
  Number* data() noexcept { return data_; }
  const Number* data() const noexcept { return data_; }
  Number* begin() noexcept { return data_; }
  const Number* begin() const noexcept { return data_; }
  Number* end() noexcept { return data_ + size_; }
  const Number* end() const noexcept { return data_ + size_; }
  Number& operator[](std::size_t k) noexcept { return data_[k]; }
  const Number& operator[](std::size_t k) const noexcept { return data_[k]; }

 private:
  void swap(Array& other) noexcept {
    std::swap(memory_, other.memory_);
    std::swap(size_, other.size_);
    std::swap(data_, other.data_);
  }

  std::pmr::memory_resource* memory_ = nullptr;
  std::size_t size_ = 0;
  Number* data_ = nullptr;
};

}  // namespace patchgrip::contact
