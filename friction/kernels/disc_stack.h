// A round pressure as a stack of discs of one kind: level q in (0, 1) is a disc of radius R(q) that carries the share w
// dq of the normal force. With the kind's f_k, m_k, f_k' (round_functions.h),
//
//     f(x) = int f_k(x/R) w dq,   m(x) = int R m_k(x/R) w dq,   f'(x) = int f_k'(x/R) / R w dq
//
// every integrand positive. The level whose rim passes through the pole, R = x, is a weak singularity; the integrals
// are split there and each part is done by tanh-sinh quadrature (Takahasi, Mori 1974), which takes any integrable end
// point.
//
// Levels has    conjugate(number): R(q), which falls from R(0) = 1 to R(1) = 0 and is its own inverse: also q(R);
//               share(q, R): w.
// Error   about 1 unit of rounding of double (it inherits the kind's table and the error of the shares).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <patchgrip/friction/kernels/round_table.h>

namespace patchgrip::friction::kernels {

struct StackNumber {
  double value;
  double complement;  // 1 - value, to full relative precision
};

template <class Levels>
class DiscStack {
 public:
  DiscStack(Levels levels, const RoundTable& kind) : levels_(std::move(levels)), kind_(kind) {
    for (int i = -last; i <= last; ++i) {
      const double t = step * i;
      const double s = std::numbers::pi / 2 * std::sinh(t);
      const double below = 1 / (1 + std::exp(-2 * s));
      const double above = 1 / (1 + std::exp(2 * s));
      nodes_[static_cast<std::size_t>(i + last)] = {below, above,
                                                    step * std::numbers::pi * std::cosh(t) * below * above};
    }
  }

  RoundValues<long double> inside(long double d) const {
    const StackNumber x{static_cast<double>(1 - d), static_cast<double>(d)};
    const StackNumber split = levels_.conjugate(x);
    // Levels wider than x have the pole inside.
    const auto wide = integrate({0, 1}, split, [&](const StackNumber& R) -> RoundValues<double> {
      const double gap = std::max(x.complement - R.complement, 0.0) / R.value;  // 1 - x / R
      const double ratio = std::min(x.value / R.value, 1.0);
      const Pair g = kind_.gradient(true, gap, ratio);
      return {g[0] / R.value, R.value * g[1], kind_.slope(true, gap, ratio) / R.value};
    });
    const auto narrow = integrate(split, {1, 0}, [&](const StackNumber& R) -> RoundValues<double> {
      const double gap = std::max(R.complement - x.complement, 0.0) / x.value;  // 1 - R / x
      const double u = std::min(R.value / x.value, 1.0);
      const Pair g = kind_.gradient(false, gap, u);
      return {g[0] / x.value, R.value * u * g[1], u * u / x.value * kind_.slope(false, gap, u)};
    });
    return {wide.force + narrow.force, wide.moment + narrow.moment, wide.slope + narrow.slope};
  }

  RoundValues<long double> outside(long double d) const {
    const double u = static_cast<double>(1 - d);
    return integrate({0, 1}, {1, 0}, [&](const StackNumber& R) -> RoundValues<double> {
      const double gap = static_cast<double>(d) + u * R.complement;  // 1 - R u
      const Pair g = kind_.gradient(false, gap, R.value * u);
      const double R2 = R.value * R.value;
      return {g[0], R2 * g[1], R2 * kind_.slope(false, gap, R.value * u)};
    });
  }

  long double rim_slope() const { return inside(0).slope; }

  // <r^2> / a^2, where `of_kind` is that of a disc of the stack.
  double polar(double of_kind) const {
    return static_cast<double>(integrate({0, 1}, {1, 0}, [&](const StackNumber& R) -> RoundValues<double> {
                                 return {of_kind * R.value * R.value, 0, 0};
                               }).force);
  }

 private:
  static constexpr int last = 54;
  static constexpr double step = 1.0 / 16;

  struct Node {
    double x;           // in (0, 1)
    double complement;  // 1 - x
    double weight;
  };

  template <class Integrand>
  RoundValues<long double> integrate(const StackNumber& from, const StackNumber& to, const Integrand& integrand) const {
    // The length from the two values or the two complements, whichever does not cancel.
    const double length = from.value < 0.5 ? to.value - from.value : from.complement - to.complement;
    RoundValues<long double> sum{};
    for (const Node& node : nodes_) {
      const StackNumber q{from.value + length * node.x, to.complement + length * node.complement};
      const StackNumber R = levels_.conjugate(q);
      if (!(R.value > 0)) continue;
      const RoundValues<double> g = integrand(R);
      const double weight = node.weight * levels_.share(q, R);
      sum.force += weight * g.force;
      sum.moment += weight * g.moment;
      sum.slope += weight * g.slope;
    }
    return {length * sum.force, length * sum.moment, length * sum.slope};
  }

  Levels levels_;
  const RoundTable& kind_;
  std::array<Node, 2 * last + 1> nodes_;
};

}  // namespace patchgrip::friction::kernels
