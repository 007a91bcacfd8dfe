#include <patchgrip/friction/kernels/pair_polynomial.h>

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace patchgrip::friction::kernels {
namespace {

// Coefficients k + 1 and (-1)^k: small integers, so that every order of summation is exact at t = 2 and t = -1.
template <std::size_t N>
constexpr std::array<Pair, N> coefficients() {
  std::array<Pair, N> c{};
  for (std::size_t k = 0; k < N; ++k) c[k] = Pair{static_cast<double>(k + 1), k % 2 == 0 ? 1.0 : -1.0};
  return c;
}

template <std::size_t N>
void expect_both_lanes_equal_horner() {
  const auto c = coefficients<N>();
  std::array<double, N> first{};
  for (std::size_t k = 0; k < N; ++k) first[k] = c[k][0];
  for (const double t : {2.0, -1.0, 0.0, 0.5}) {
    Pair horner{0, 0};
    for (auto k = N; k-- > 0;) horner = horner * t + c[k];
    const Pair p = polynomial(c, t);
    EXPECT_EQ(p[0], horner[0]) << N << " terms at " << t;
    EXPECT_EQ(p[1], horner[1]) << N << " terms at " << t;
    EXPECT_EQ(polynomial(first, t), horner[0]) << N << " terms at " << t;
  }
}

template <std::size_t... I>
void for_all_sizes(std::index_sequence<I...>) {
  (expect_both_lanes_equal_horner<I + 1>(), ...);
}

TEST(PairPolynomial, EqualsHornersRuleInBothLanesForEveryNumberOfTerms) {
  for_all_sizes(std::make_index_sequence<32>());
}

}  // namespace
}  // namespace patchgrip::friction::kernels
