// How far one convex body sticks out of another: the largest ratio of their support functions, proven.
//
//     max over v of a(v) / b(v) = the smallest s such that the body of a lies in s times the body of b
//
// Both functions are convex, positively homogeneous and even. On the cone of three twists v_i, with t a wrench of the
// body of b,
//
//     a(v) <= sum of l_i a(v_i),   b(v) >= sum of l_i t . v_i     =>     a / b <= max over i of a(v_i) / (t . v_i)
//
// With t the wrench of the middle of the cone the bound exceeds the ratio by second order in the width. Cones are
// bisected, the one of the largest bound first, along the edge over which the wrenches turn most, until the bound
// exceeds a ratio that is seen by no more than the tolerance. The errors of both functions are counted in.
//
// Domain   support functions in a frame where both bodies are close to the unit ball (support_function.h), not 0.
// Units    none: twists and wrenches of that frame.
// Error    bound >= the maximum >= attained. They differ by the tolerance and twice the errors of both functions,
//          unless `most_cones` ended the search: that is not hidden, the numbers show it.
#pragma once

#include <patchgrip/friction/limit_surface/support_function.h>

namespace patchgrip::friction {

struct LargestRatio {
  double bound;
  double attained;
};

LargestRatio largest_ratio(const SupportFunction& a, const SupportFunction& b, double tolerance,
                           int most_cones = 1 << 20);

// A gauge that approximates g errs on two sides: (1 - largest_deficit) g <= approximation <= (1 + largest_excess) g.
struct GaugeSides {
  double largest_excess;   // >= 0: asks for too much grip, safe
  double largest_deficit;  // >= 0: asks for too little, unsafe
  double slack = 0;        // what either may be above the true maximum by

  GaugeSides scaled(double factor) const;  // of `factor` times the approximation
};

// Of the body of `model` against `truth`, to a slack of 1e-5 and the errors of both unless the search ends early.
GaugeSides gauge_sides(const SupportFunction& model, const SupportFunction& truth);

}  // namespace patchgrip::friction
