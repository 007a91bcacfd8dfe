// Fifty digits as the judge of a double: errors in units of rounding.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace patchgrip::testing {

using Exact = boost::multiprecision::cpp_bin_float_50;

// Relative error of `value` in units of 2^-53, the rounding of double.
inline double units_of_rounding(double value, const Exact& exact) {
  if (exact == 0) return value == 0 ? 0 : INFINITY;
  return static_cast<double>(abs((Exact(value) - exact) / exact) * 0x1p53);
}

}  // namespace patchgrip::testing
