// Integrals of several functions at once, smooth inside and possibly singular at either end, without allocation.
//
// Tanh-sinh quadrature (Takahasi, Mori 1974) as in contact/endpoint_quadrature.h, for an integrand that gives N numbers
// and is told its distances from both ends without cancellation.
//
// The numbers are to be of one unit: errors are judged against the largest of them.
//
// Domain   at an end no worse than the inverse of a root.
// Error    an estimate: the step is halved, which nearly doubles the digits. What is left of a number I after the
//          differences d', d of three results is at most
//
//              |I| max((d / |I|)^(3/2), (d' / |I|)^(9/4))
//
//          where |I| is no less than d and d': d alone may be small by chance. It ends where d is twelve digits below the
//          largest number and what is left is rounding, of which 8 units of the integral of |f| come on top. Without
//          twelve digits 16 d is left. tests/friction/vector_quadrature_test.cc.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace patchgrip::friction::kernels {

template <std::size_t N>
struct BoundedIntegrals {
  std::array<double, N> value{};
  std::array<double, N> error{};
};

class TanhSinhNodes {
 public:
  static constexpr int coarsest = 2;  // 1 / step
  static constexpr int finest = 128;
  static constexpr int reach = 4;  // of the variable: the last nodes are 1e-37 of the interval from its ends

  struct Node {
    double from_lo, to_hi;  // of the interval [0, 1]
    double weight;          // per step
  };

  static const TanhSinhNodes& shared() {
    static const TanhSinhNodes nodes;
    return nodes;
  }

  // Node i = -reach / step .. reach / step at the step 1 / finest.
  const Node& operator[](int i) const noexcept { return nodes_[static_cast<std::size_t>(i + reach * finest)]; }

 private:
  TanhSinhNodes() {
    for (int i = -reach * finest; i <= reach * finest; ++i) {
      const double t = static_cast<double>(i) / finest;
      const double s = std::numbers::pi / 2 * std::sinh(t);
      const double x = 1 / (1 + std::exp(-2 * s)), complement = 1 / (1 + std::exp(2 * s));
      nodes_[static_cast<std::size_t>(i + reach * finest)] = {x, complement,
                                                              std::numbers::pi * std::cosh(t) * x * complement};
    }
  }

  std::array<Node, 2 * reach * finest + 1> nodes_;
};

// `f(x - lo, hi - x)` gives a std::array<double, N>.
template <std::size_t N, class Integrand>
BoundedIntegrals<N> integrate(const Integrand& f, double lo, double hi) {
  constexpr int finest = TanhSinhNodes::finest;
  constexpr double unit = 0x1p-53;
  BoundedIntegrals<N> result;
  const double length = hi - lo;
  if (!(length > 0)) return result;
  const TanhSinhNodes& nodes = TanhSinhNodes::shared();
  std::array<double, N> sum{}, absolute{};
  const auto add = [&](int first, int every) {
    for (int i = first; i <= TanhSinhNodes::reach * finest; i += every) {
      const auto& node = nodes[i];
      const std::array<double, N> g = f(length * node.from_lo, length * node.to_hi);
      for (std::size_t j = 0; j < N; ++j) {
        sum[j] += node.weight * g[j];
        absolute[j] += node.weight * std::fabs(g[j]);
      }
    }
  };
  constexpr int first = -TanhSinhNodes::reach * finest;
  add(first, finest / TanhSinhNodes::coarsest);
  std::array<double, N> difference;
  difference.fill(std::numeric_limits<double>::infinity());
  for (int per_unit = TanhSinhNodes::coarsest; per_unit < finest;) {
    const std::array<double, N> before = sum, difference_before = difference;
    add(first + finest / (2 * per_unit), finest / per_unit);
    per_unit *= 2;
    for (std::size_t j = 0; j < N; ++j) {
      result.value[j] = length * sum[j] / per_unit;
      difference[j] = std::fabs(result.value[j] - 2 * length * before[j] / per_unit);
    }
    const double size = length * *std::max_element(absolute.begin(), absolute.end()) / per_unit;
    const bool agree = *std::max_element(difference.begin(), difference.end()) <= 1e-12 * size;
    double most = 0;
    for (std::size_t j = 0; j < N; ++j) {
      const auto left_of = [&](double d, double power) {
        return d > 0 ? d * std::pow(std::min(1.0, d / std::fabs(result.value[j])), power - 1) : 0;
      };
      const double left =
          agree ? std::max(left_of(difference[j], 1.5), left_of(difference_before[j], 2.25)) : 16 * difference[j];
      result.error[j] = left + 8 * unit * length * absolute[j] / per_unit;
      most = std::max(most, left);
    }
    if (agree && most <= 8 * unit * size) break;
  }
  return result;
}

}  // namespace patchgrip::friction::kernels
