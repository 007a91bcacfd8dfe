// What rounding its inputs to double does to a result, and what is left of an error without it.
//
// A table states its inputs x as decimals, the library takes the nearest doubles X; delta = x - X. Near a rim that
// difference is larger than any error of the library. To first order its effect on a result q is
//
//     q(x) - q(X) = [q(X + K delta) - q(X - K delta)] / (2 K)
//
// where K makes the inputs move visibly and keeps the rounding of q itself out of the effect. A narrow K = 2^10 is
// right near a rim, where q bends, a wide K = 2^26 where the effect is large. Of the two errors that are left the
// smaller one counts.
//
// Fails    closer than some K delta to a rim where q has no derivative (Hessians of a ring or a flat punch): the effect
//          is then wrong by a factor.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <stdexcept>

#include <patchgrip/cli/accuracy/number.h>

namespace patchgrip::cli {

// X, and X moved by K delta to and fro.
enum class Inputs : std::size_t { rounded, narrow_before, narrow_beyond, wide_before, wide_beyond };

inline constexpr std::array<double, 5> input_steps{0, -0x1p10, 0x1p10, -0x1p26, 0x1p26};  // K by Inputs

inline double as_double(const Exact& x, Inputs inputs) {
  const auto nearest = static_cast<double>(x);
  return static_cast<double>(nearest + (x - nearest) * input_steps[static_cast<std::size_t>(inputs)]);
}

inline bool rounds_to_itself(const Exact& x) { return x == static_cast<double>(x); }

template <std::size_t N>
struct Measured {
  std::array<double, N> value;             // q(X)
  std::array<double, N> narrow{}, wide{};  // q(x) - q(X) by either K
};

// `evaluate(Inputs)` gives an array of N results; where it refuses moved inputs (std::logic_error) their effect stays
// 0.
template <class Evaluate>
auto measure(Evaluate&& evaluate) {
  const auto value = evaluate(Inputs::rounded);
  constexpr std::size_t N = std::tuple_size_v<std::remove_const_t<decltype(value)>>;
  const auto effect = [&](Inputs before, Inputs beyond) {
    std::array<double, N> half_difference{};
    try {
      const auto q0 = evaluate(before);
      const auto q1 = evaluate(beyond);
      const double width = 2 * input_steps[static_cast<std::size_t>(beyond)];
      for (std::size_t i = 0; i < N; ++i) half_difference[i] = (q1[i] - q0[i]) / width;
    } catch (const std::logic_error&) {
      half_difference = {};
    }
    return half_difference;
  };
  return Measured<N>{value, effect(Inputs::narrow_before, Inputs::narrow_beyond),
                     effect(Inputs::wide_before, Inputs::wide_beyond)};
}

// Error of a value, and what is left of it without the effect of rounding the inputs.
struct Deviation {
  double as_is = 0;
  double own = 0;
};

inline constexpr Deviation failed{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};

// |value + effect - reference| / scale; infinite where the value is not finite.
double distance(std::span<const double> value, std::span<const double> effect, std::span<const Exact> reference,
                const Exact& scale);

// Of the results from `first` on, as many as there are references, taken as one vector.
template <std::size_t N>
Deviation deviation(const Measured<N>& q, std::size_t first, std::span<const Exact> reference, const Exact& scale) {
  const auto part = [&](const std::array<double, N>& all) { return std::span(all).subspan(first, reference.size()); };
  constexpr std::array<double, N> none{};
  const auto left = [&](const std::array<double, N>& effect) {
    return distance(part(q.value), part(effect), reference, scale);
  };
  return {left(none), std::fmin(left(q.narrow), left(q.wide))};
}

template <std::size_t N>
Deviation deviation(const Measured<N>& q, std::size_t which, const Exact& reference, const Exact& scale) {
  return deviation(q, which, std::span(&reference, 1), scale);
}

}  // namespace patchgrip::cli
