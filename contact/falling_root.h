// Root of a function that is >= 0 at lo and < 0 at hi, to the last digits: f falls through it.
//
// Algorithm 748 of Alefeld, Potra and Shi, as Boost has it. Where f has the sign of its other end already at one end,
// that end is the root.
//
// Error    a bracket of 4 times the scalar's epsilon, relative, around a change of sign of the computed f.
// Throws   std::runtime_error, naming the residual, when 200 evaluations do not suffice.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <boost/math/tools/toms748_solve.hpp>

namespace patchgrip::contact {

template <class Real, class Function>
Real falling_root(const Function& f, const Real& lo, const Real& hi) {
  const Real at_lo = f(lo), at_hi = f(hi);
  if (at_lo <= 0) return lo;
  if (at_hi >= 0) return hi;
  std::uintmax_t iterations = 200;
  const auto [left, right] =
      boost::math::tools::toms748_solve(f, lo, hi, at_lo, at_hi, boost::math::tools::eps_tolerance<Real>(), iterations);
  if (iterations >= 200)
    throw std::runtime_error("no root found: residual " + std::to_string(static_cast<double>(f(left))));
  return left + (right - left) / 2;
}

}  // namespace patchgrip::contact
