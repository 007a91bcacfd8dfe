// The Hertz disc by every method there is.
#pragma once

#include <vector>

#include <patchgrip/bench/case.h>

namespace patchgrip::bench {

// Exact, the seed's polynomials, the naive 21 x 21 sum and adaptive quadrature; mixed, inside, outside and rim poles.
std::vector<Case> hertz_cases();

// Error against time, over near poles: the same, and how they trade one for the other.
std::vector<Case> work_precision_cases();

}  // namespace patchgrip::bench
