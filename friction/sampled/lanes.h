// How many doubles a vector register of this processor holds: kernels are compiled for each, the widest is taken.
#pragma once

namespace patchgrip::friction::kernels {

enum class Lanes { two, four, eight };  // SSE2, AVX2, AVX-512

inline Lanes widest_lanes() noexcept {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (__builtin_cpu_supports("x86-64-v4")) return Lanes::eight;
  if (__builtin_cpu_supports("x86-64-v3")) return Lanes::four;
#endif
  return Lanes::two;
}

}  // namespace patchgrip::friction::kernels

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define PATCHGRIP_FOUR_LANES [[gnu::target("arch=x86-64-v3")]]
#define PATCHGRIP_EIGHT_LANES [[gnu::target("arch=x86-64-v4,prefer-vector-width=512")]]
#else
#define PATCHGRIP_FOUR_LANES
#define PATCHGRIP_EIGHT_LANES
#endif
