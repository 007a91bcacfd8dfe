// Two polynomials in the same variable at once.
//
// The force and the moment of a patch are two polynomials in one variable: as the two lanes of an SSE2 register they
// cost one. Estrin's scheme keeps the chain of dependent operations short.
#pragma once

#include <array>
#include <cstddef>

namespace patchgrip::friction::kernels {

using Pair [[gnu::vector_size(16)]] = double;

namespace detail {

template <std::size_t First, std::size_t Count, class Value, std::size_t N>
[[gnu::always_inline]] inline Value estrin(const std::array<Value, N>& c, const std::array<Value, 5>& powers) noexcept {
  if constexpr (Count == 1) {
    return c[First];
  } else {
    constexpr std::size_t log2 = Count > 16 ? 4 : Count > 8 ? 3 : Count > 4 ? 2 : Count > 2 ? 1 : 0;
    constexpr std::size_t low = std::size_t{1} << log2;
    return estrin<First, low>(c, powers) + powers[log2] * estrin<First + low, Count - low>(c, powers);
  }
}

}  // namespace detail

// sum c_k t^k in every lane; N <= 32.
template <class Value, std::size_t N>
[[gnu::always_inline]] inline Value polynomial(const std::array<Value, N>& c, Value t) noexcept {
  const Value t2 = t * t;
  const Value t4 = t2 * t2;
  const Value t8 = t4 * t4;
  return detail::estrin<0, N>(c, {t, t2, t4, t8, t8 * t8});
}

template <std::size_t N>
[[gnu::always_inline]] inline Pair polynomial(const std::array<Pair, N>& c, double t) noexcept {
  return polynomial(c, Pair{t, t});
}

// The same by Horner's rule: for short polynomials whose leading terms may cancel.
template <std::size_t N>
[[gnu::always_inline]] constexpr double horner(const std::array<double, N>& c, double t) noexcept {
  double sum = c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) sum = sum * t + c[k];
  return sum;
}

// The two polynomials as one of pairs.
template <std::size_t N>
constexpr std::array<Pair, N> paired(const std::array<double, N>& first, const std::array<double, N>& second) noexcept {
  std::array<Pair, N> result{};
  for (std::size_t k = 0; k < N; ++k) result[k] = Pair{first[k], second[k]};
  return result;
}

}  // namespace patchgrip::friction::kernels
