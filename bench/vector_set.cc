#include <patchgrip/bench/vector_set.h>

namespace patchgrip::bench {

VectorSet vector_set() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (__builtin_cpu_supports("x86-64-v4")) return VectorSet::avx512;
  if (__builtin_cpu_supports("x86-64-v3")) return VectorSet::avx2;
#endif
  return VectorSet::sse2;
}

std::string name_of(VectorSet set) {
  switch (set) {
    case VectorSet::avx512:
      return "AVX-512";
    case VectorSet::avx2:
      return "AVX2";
    case VectorSet::sse2:
      break;
  }
  return "SSE2";
}

}  // namespace patchgrip::bench
