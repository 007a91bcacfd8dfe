// The pressure of Xydas and Kao as a stack of uniform discs, in the precision of Real: reference of xydas_kao_disc.h.
//
// The average over the levels of kernels/disc_stack.h, with the uniform disc from its hypergeometric functions and as
// many tanh-sinh nodes as Real asks for. Slow (milliseconds a pole); nothing is shared with the double code but the
// idea.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <boost/math/constants/constants.hpp>

#include <patchgrip/friction/kernels/round_functions.h>

namespace patchgrip::friction {

template <class Real>
class StackReference {
 public:
  explicit StackReference(double alpha) : alpha_(alpha), uniform_(Real(0.5)) {
    using std::exp;
    using std::log;
    const double digits = std::numeric_limits<Real>::digits10;
    const int per_unit = static_cast<int>(std::ceil(0.8 * digits));  // nodes per unit of t
    const Real step = Real(1) / per_unit;
    const double reach = std::asinh(digits * std::log(10) / std::acos(-1.0)) + 0.2;
    const Real& pi = boost::math::constants::pi<Real>();
    for (int i = -static_cast<int>(reach * per_unit); i <= static_cast<int>(reach * per_unit); ++i) {
      const Real e = exp(step * i);
      const Real s = pi / 2 * (e - 1 / e);  // pi sinh t
      const Real above = 1 / (1 + exp(s));
      const Real below = 1 / (1 + exp(-s));
      nodes_.push_back({below, above, step * pi / 2 * (e + 1 / e) * below * above});
    }
    normal_force_ = average({0, 1}, {1, 0}, [](const Number& R) { return Pair{R.value * R.value, Real(0)}; }).first;
  }

  // <r^2> / a^2 = int R^4 / 2 dq / int R^2 dq
  Real polar() const {
    return average({0, 1}, {1, 0},
                   [](const Number& R) {
                     return Pair{R.value * R.value * R.value * R.value / 2, Real(0)};
                   })
               .first /
           normal_force_;
  }

  kernels::RoundValues<Real> inside(const Real& d) const {
    const Number x{1 - d, d};
    if (d == 1) {
      const auto g = average({0, 1}, {1, 0}, [&](const Number& R) {
        return Pair{R.value * f0(), R.value * R.value * R.value * m0()};
      });
      return {g.first / normal_force_, g.second / normal_force_, Real(0)};
    }
    const Number split = conjugate(x);
    const auto wide = average({0, 1}, split, [&](const Number& R) {
      const auto g = uniform_.inside(at_least_zero(x.complement - R.complement) / R.value);
      return Pair{R.value * g.force, R.value * R.value * R.value * g.moment};
    });
    const auto narrow = average(split, {1, 0}, [&](const Number& R) {
      const auto g = uniform_.outside(at_least_zero(R.complement - x.complement) / x.value);
      return Pair{R.value * R.value / x.value * g.force, R.value * R.value * R.value * R.value / x.value * g.moment};
    });
    return {(wide.first + narrow.first) / normal_force_, (wide.second + narrow.second) / normal_force_, Real(0)};
  }

  kernels::RoundValues<Real> outside(const Real& d) const {
    const auto g = average({0, 1}, {1, 0}, [&](const Number& R) {
      const auto u = uniform_.outside(d + (1 - d) * R.complement);
      return Pair{R.value * R.value * u.force, R.value * R.value * R.value * R.value * u.moment};
    });
    return {g.first / normal_force_, g.second / normal_force_, Real(0)};
  }

 private:
  struct Number {
    Real value, complement;
  };
  struct Node {
    Real x, complement, weight;
  };
  struct Pair {
    Real first, second;
  };

  static Real at_least_zero(const Real& x) { return x > 0 ? x : Real(0); }
  Real f0() const { return uniform_.inside(Real(1)).force; }
  Real m0() const { return uniform_.inside(Real(1)).moment; }

  Number conjugate(const Number& number) const {
    using std::exp;
    using std::expm1;
    using std::log;
    using std::log1p;
    const Real log_value = number.value < 0.5 ? Real(log(number.value)) : Real(log1p(-number.complement));
    const Real power = exp(alpha_ * log_value);
    const Real log_rest = power < 0.5 ? Real(log1p(-power)) : Real(log(-expm1(alpha_ * log_value)));
    return {exp(log_rest / alpha_), -expm1(log_rest / alpha_)};
  }

  template <class Integrand>
  Pair average(const Number& from, const Number& to, const Integrand& integrand) const {
    const Real length = from.value < 0.5 ? Real(to.value - from.value) : Real(from.complement - to.complement);
    Pair sum{Real(0), Real(0)};
    for (const Node& node : nodes_) {
      const Number R = conjugate({from.value + length * node.x, to.complement + length * node.complement});
      if (!(R.value > 0)) continue;
      const Pair g = integrand(R);
      sum.first += node.weight * g.first;
      sum.second += node.weight * g.second;
    }
    return {length * sum.first, length * sum.second};
  }

  Real alpha_;
  kernels::PowerFamily<Real> uniform_;
  std::vector<Node> nodes_;
  Real normal_force_;
};

}  // namespace patchgrip::friction
