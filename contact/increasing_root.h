// Root of an increasing positive function of a positive variable: y(x) = target.
//
// Newton's method on ln y against ln x, where a power law is a straight line: exact in one step for one power, and
// monotone for sums of powers. A bracket, halved in ln x when Newton leaves it, makes it converge for any increasing y.
//
//     x <- x (target / y)^(1/c),   c = x y'(x) / y(x)
//
// Error    x is within a unit of rounding of a point where the computed y crosses the target.
// Throws   std::runtime_error, naming the residual, when 300 steps do not suffice (y not increasing, or target out of
//          its range); a target beyond y(max) gives max: refuse it before.
#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace patchgrip::contact {

// value(x) and slope(x) are y and y'; a slope that is of no use is answered by a bisection. min < start < max.
template <class Value, class Slope>
double increasing_root(const Value& value, const Slope& slope, double target, double start, double min = 0,
                       double max = std::numeric_limits<double>::infinity()) {
  double lo = min;
  double hi = max;
  double x = start;
  double y = 0;
  for (int i = 0; i < 300 && x > 0 && std::isfinite(x); ++i) {
    y = value(x);
    if (y == target) return x;
    (y < target ? lo : hi) = x;
    const double growth = x * slope(x) / y;
    const double step = std::log(target / y) / growth;
    double next = x * std::exp(step);
    const bool newton = std::isfinite(growth) && growth > 0 && std::fabs(step) < 10;
    if (newton && std::fabs(step) < 0x1p-53) return next;
    if (!(newton && next > lo && next < hi)) {
      if (lo == 0) {
        next = x / 16;
      } else if (!std::isfinite(hi)) {
        next = x * 16;
      } else {
        next = std::sqrt(lo) * std::sqrt(hi);
        if (!(next > lo && next < hi)) next = lo + (hi - lo) / 2;
        if (!(next > lo && next < hi)) return next;  // lo and hi are neighbors
      }
    }
    x = next;
  }
  std::ostringstream message;
  message << "no root found: residual " << y / target - 1 << " at " << x;
  throw std::runtime_error(message.str());
}

}  // namespace patchgrip::contact
