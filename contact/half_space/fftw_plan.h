// What transforms by FFTW share: plans, made one at a time in a process, and lines of the cache.
//
// Throws   std::runtime_error when FFTW makes no plan.
#pragma once

#include <complex>
#include <cstddef>
#include <mutex>
#include <stdexcept>

#include <fftw3.h>

#include <patchgrip/contact/half_space/resources.h>

namespace patchgrip::contact::fft {

using Complex = std::complex<double>;

inline constexpr int aligned = 4;  // complex numbers: rows and columns start on a line of the cache

inline std::mutex& planner() {
  static std::mutex lock;
  return lock;
}

struct Plan {
  template <class Make>
  explicit Plan(const Make& make) {
    const std::lock_guard guard(planner());
    plan = make();
    if (plan == nullptr) throw std::runtime_error("FFTW made no plan");
  }
  ~Plan() {
    const std::lock_guard guard(planner());
    fftw_destroy_plan(plan);
  }
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;

  fftw_plan plan;
};

inline fftw_complex* raw(Complex* z) { return reinterpret_cast<fftw_complex*>(z); }

inline std::size_t threads(Resources resources) { return static_cast<std::size_t>(resources.workers.count()); }

inline std::size_t round_up(int n, int unit) { return static_cast<std::size_t>((n + unit - 1) / unit * unit); }

// What is changed next often lies changed in the cache of another thread: asked for in time, to be changed.
template <class Number>
void fetch(Number* z, int count) {
  constexpr int on_a_line = static_cast<int>(PageMemory::alignment / sizeof(Number));
  const auto one = [z](int k) {
#if defined(__x86_64__)
    asm volatile("prefetchw %0" : : "m"(z[k]));  // __builtin_prefetch only reads for processors of any age
#else
    __builtin_prefetch(z + k, 1);
#endif
  };
  for (int k = 0; k < count - 1; k += on_a_line) one(k);
  one(count - 1);
}

}  // namespace patchgrip::contact::fft
