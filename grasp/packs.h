// Numbers of four contacts side by side, and short vectors of them: what the kernels of interior_point_kernels.h compute
// with. The same code runs on a double.
//
// Everything is inlined where it is used: sources compiled for different processors share no function.
#pragma once

#include <cstddef>

namespace patchgrip::grasp {

using Pack [[gnu::vector_size(32)]] = double;
inline constexpr int lanes = 4;

#define PATCHGRIP_PACKED [[gnu::always_inline]] inline

template <class S>
PATCHGRIP_PACKED S root(const S& x) {
  if constexpr (sizeof(S) == sizeof(double)) {
    return __builtin_sqrt(x);
  } else {
    return S{__builtin_sqrt(x[0]), __builtin_sqrt(x[1]), __builtin_sqrt(x[2]), __builtin_sqrt(x[3])};
  }
}

template <class S>
PATCHGRIP_PACKED S larger(const S& a, const S& b) {
  return a > b ? a : b;
}
template <class S>
PATCHGRIP_PACKED S smaller(const S& a, const S& b) {
  return a < b ? a : b;
}
template <class S>
PATCHGRIP_PACKED S size(const S& a) {
  return larger<S>(a, -a);
}

PATCHGRIP_PACKED double sum(double x) { return x; }
PATCHGRIP_PACKED double sum(const Pack& x) { return (x[0] + x[2]) + (x[1] + x[3]); }
PATCHGRIP_PACKED double largest(double x) { return x; }
PATCHGRIP_PACKED double largest(const Pack& x) { return larger(larger(x[0], x[2]), larger(x[1], x[3])); }

// Of a comparison.
template <class Mask>
PATCHGRIP_PACKED bool all(const Mask& x) {
  if constexpr (sizeof(Mask) == sizeof(Pack)) {
    return (x[0] & x[1] & x[2] & x[3]) != 0;
  } else {
    return x != 0;
  }
}

template <std::size_t n, class S>
struct alignas(sizeof(S)) Packed {  // the alignment of S alone depends on the processor
  S c[n];

  PATCHGRIP_PACKED S& operator[](std::size_t i) { return c[i]; }
  PATCHGRIP_PACKED const S& operator[](std::size_t i) const { return c[i]; }
};

template <std::size_t n, class S>
PATCHGRIP_PACKED void operator+=(Packed<n, S>& a, const Packed<n, S>& b) {
  for (std::size_t i = 0; i < n; ++i) a[i] += b[i];
}
template <std::size_t n, class S>
PATCHGRIP_PACKED Packed<n, S> operator+(Packed<n, S> a, const Packed<n, S>& b) {
  a += b;
  return a;
}
template <std::size_t n, class S>
PATCHGRIP_PACKED Packed<n, S> operator-(Packed<n, S> a, const Packed<n, S>& b) {
  for (std::size_t i = 0; i < n; ++i) a[i] -= b[i];
  return a;
}
template <std::size_t n, class S, class Factor>
PATCHGRIP_PACKED Packed<n, S> operator*(const Factor& k, Packed<n, S> a) {
  for (std::size_t i = 0; i < n; ++i) a[i] *= k;
  return a;
}

// Sum of a_i b_i from i = first on.
template <std::size_t first = 0, std::size_t n, class S, class B>
PATCHGRIP_PACKED S dot(const Packed<n, S>& a, const B& b) {
  S s = a[first] * b[first];
  for (std::size_t i = first + 1; i < n; ++i) s += a[i] * b[i];
  return s;
}

}  // namespace patchgrip::grasp
