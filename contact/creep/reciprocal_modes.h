// Roots of the secular equation that turns one Prony series into the other.
//
// A modulus and its compliance are reciprocal in the Laplace domain, s^2 E(s) J(s) = 1. With the poles tau_i, weights
// w_i = E_i tau_i (a dashpot is a pole at 0) and c = E_inf, the times of the compliance are the roots of
//
//     f(lambda) = c - sum w_i / (lambda - tau_i) = 0,      J_j = 1 / (lambda_j sum w_i / (lambda_j - tau_i)^2)
//
// one between each two neighbouring poles and one above all of them if c > 0. The way back is the same equation: poles
// 1 / lambda_j, weights J_j / lambda_j (a fluidity is a pole at 0), c = J_0, roots 1 / tau_i.
//
// Each root is solved for 1 / (its distance from the nearer pole), in which f is nearly linear near that pole: Newton's
// method, kept in a bracket. No digits are lost where a weak mode leaves its root close to a pole.
//
// Error    relative, of root and strength: about 4 units of rounding of Real, times up to 1 + root / distance where a
//          root is close to a pole by the balance of other modes. contact/creep/conversion.cc takes 113 bits.
// Throws   std::runtime_error with the residual if Newton's method should not converge.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace patchgrip::contact {

template <class Real>
struct SecularPole {
  Real place;
  Real weight;
};

template <class Real>
struct SecularRoot {
  Real place;
  Real strength;  // 1 / (place f'(place))
};

namespace secular {

template <class Real>
struct Value {
  Real f;
  Real slope;  // f'
  Real size;   // sum of the moduli of its terms: f rounds to some 2^-k of it
};

// f at the place that lies `offset` beyond the pole `origin`.
template <class Real>
Value<Real> evaluate(const Real& c, const std::vector<SecularPole<Real>>& poles, const Real& origin,
                     const Real& offset) {
  using std::abs;
  Value<Real> sum{c, 0, c};
  for (const auto& pole : poles) {
    const Real distance = offset + (origin - pole.place);
    const Real term = pole.weight / distance;
    sum.f -= term;
    sum.slope += term / distance;
    sum.size += abs(term);
  }
  return sum;
}

// The root at origin + 1 / y, y between lo and hi (of one sign). f falls with y.
template <class Real>
SecularRoot<Real> solve(const Real& c, const std::vector<SecularPole<Real>>& poles, const Real& origin, Real lo,
                        Real hi) {
  using std::abs;
  const Real rounding = 4 * std::numeric_limits<Real>::epsilon();
  Real y = (lo + hi) / 2;
  for (int iteration = 0; iteration < 400; ++iteration) {
    const auto value = evaluate<Real>(c, poles, origin, 1 / y);
    const Real step = y * (y * (value.f / value.slope));  // df/dy = -f' / y^2
    if (abs(step) <= rounding * abs(y) || abs(value.f) <= rounding * value.size) {
      const Real place = origin + 1 / y;
      return {place, 1 / (place * value.slope)};
    }
    (value.f > 0 ? lo : hi) = y;
    y += step;
    if (!(y > lo && y < hi)) y = (lo + hi) / 2;
  }
  throw std::runtime_error("a root of a Prony series did not settle: residual " +
                           std::to_string(static_cast<double>(evaluate<Real>(c, poles, origin, 1 / y).f)));
}

}  // namespace secular

// The poles ascend; places and constant are >= 0, weights > 0. The roots ascend.
template <class Real>
std::vector<SecularRoot<Real>> reciprocal_modes(const Real& constant, const std::vector<SecularPole<Real>>& poles) {
  std::vector<SecularRoot<Real>> roots;
  for (std::size_t k = 0; k + 1 < poles.size(); ++k) {
    const Real half = (poles[k + 1].place - poles[k].place) / 2;
    const bool left = secular::evaluate<Real>(constant, poles, poles[k].place, half).f >= 0;
    const Real origin = poles[left ? k : k + 1].place;
    // At the root the pull of the near pole, weight |y|, is at most what balances it at half way.
    Real balance = left ? constant : Real(0);
    for (std::size_t i = 0; i < poles.size(); ++i) {
      if (left == (i > k)) {
        using std::abs;
        balance += poles[i].weight / abs((poles[i].place - poles[k].place) - half);
      }
    }
    const Real steepest = std::max<Real>(2 * balance / poles[left ? k : k + 1].weight, 2 / half);
    roots.push_back(left ? secular::solve<Real>(constant, poles, origin, Real(1) / (2 * half), steepest)
                         : secular::solve<Real>(constant, poles, origin, -steepest, Real(-1) / (2 * half)));
  }
  if (constant > 0 && !poles.empty()) {
    Real total = 0;
    for (const auto& pole : poles) total += pole.weight;
    roots.push_back(secular::solve<Real>(constant, poles, poles.back().place, constant / (2 * total),
                                         2 * constant / poles.back().weight));
  }
  return roots;
}

}  // namespace patchgrip::contact
