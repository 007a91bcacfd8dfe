#include <patchgrip/friction/kernels/disc_stack.h>

#include <cmath>
#include <numbers>

#include <boost/math/special_functions/beta.hpp>

namespace patchgrip::friction::kernels {

XydasKaoStack::XydasKaoStack(double alpha, const RoundTable& uniform)
    : alpha_(alpha),
      normal_force_(2 / static_cast<long double>(alpha) *
                    boost::math::beta(2 / static_cast<long double>(alpha), 1 / static_cast<long double>(alpha) + 1)),
      uniform_(uniform) {
  constexpr double step = 1.0 / 16;
  constexpr int last = 54;
  for (int i = -last; i <= last; ++i) {
    const double t = step * i;
    const double s = std::numbers::pi / 2 * std::sinh(t);
    const double below = 1 / (1 + std::exp(-2 * s));
    const double above = 1 / (1 + std::exp(2 * s));
    nodes_.push_back({below, above, step * std::numbers::pi * std::cosh(t) * below * above});
  }
}

XydasKaoStack::Number XydasKaoStack::conjugate(const Number& number) const {
  // log(1 - value^alpha), from whichever of value and complement is small.
  const double log_value = number.value < 0.5 ? std::log(number.value) : std::log1p(-number.complement);
  const double power = std::exp(alpha_ * log_value);
  const double log_rest = power < 0.5 ? std::log1p(-power) : std::log(-std::expm1(alpha_ * log_value));
  return {std::exp(log_rest / alpha_), -std::expm1(log_rest / alpha_)};
}

template <class Integrand>
RoundValues<long double> XydasKaoStack::integrate(const Number& from, const Number& to,
                                                  const Integrand& integrand) const {
  // The length from the two values or the two complements, whichever does not cancel.
  const double length = from.value < 0.5 ? to.value - from.value : from.complement - to.complement;
  RoundValues<long double> sum{};
  for (const Node& node : nodes_) {
    const Number q{from.value + length * node.x, to.complement + length * node.complement};
    const Number R = conjugate(q);
    if (!(R.value > 0)) continue;
    const RoundValues<double> g = integrand(R);
    sum.force += node.weight * g.force;
    sum.moment += node.weight * g.moment;
    sum.slope += node.weight * g.slope;
  }
  const long double scale = length / normal_force_;
  return {scale * sum.force, scale * sum.moment, scale * sum.slope};
}

RoundValues<long double> XydasKaoStack::inside(long double d) const {
  const Number x{static_cast<double>(1 - d), static_cast<double>(d)};
  const Number split = conjugate(x);
  // Levels wider than x have the pole inside.
  const auto wide = integrate({0, 1}, split, [&](const Number& R) -> RoundValues<double> {
    const double gap = std::max(x.complement - R.complement, 0.0) / R.value;  // 1 - x / R
    const double ratio = std::min(x.value / R.value, 1.0);
    const Pair g = uniform_.gradient(true, gap, ratio);
    return {R.value * g[0], R.value * R.value * R.value * g[1], R.value * uniform_.slope(true, gap, ratio)};
  });
  const auto narrow = integrate(split, {1, 0}, [&](const Number& R) -> RoundValues<double> {
    const double gap = std::max(R.complement - x.complement, 0.0) / x.value;  // 1 - R / x
    const double u = std::min(R.value / x.value, 1.0);
    const Pair g = uniform_.gradient(false, gap, u);
    const double R3 = R.value * R.value * R.value;
    return {R.value * u * g[0], R3 * u * g[1], R.value * u * u * u * uniform_.slope(false, gap, u)};
  });
  return {wide.force + narrow.force, wide.moment + narrow.moment, wide.slope + narrow.slope};
}

RoundValues<long double> XydasKaoStack::outside(long double d) const {
  const double u = static_cast<double>(1 - d);
  return integrate({0, 1}, {1, 0}, [&](const Number& R) -> RoundValues<double> {
    const double gap = static_cast<double>(d) + u * R.complement;  // 1 - R u
    const Pair g = uniform_.gradient(false, gap, R.value * u);
    const double R2 = R.value * R.value;
    return {R2 * g[0], R2 * R2 * g[1], R2 * R2 * uniform_.slope(false, gap, R.value * u)};
  });
}

}  // namespace patchgrip::friction::kernels
