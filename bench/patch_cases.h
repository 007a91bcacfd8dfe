// Every other patch by its exact method, and what a polygon's edge is measured against.
#pragma once

#include <vector>

#include <patchgrip/bench/case.h>

namespace patchgrip::bench {

// Flat punch, uniform disc, ring, power law with n = 0.3, Xydas and Kao with alpha = 1.8; mixed poles.
std::vector<Case> round_cases();

// Hertz ellipses of the aspect ratios 2 and 100 (the label's parameter); poles about the major semi-axis, and such that
// are inside.
std::vector<Case> ellipse_cases();

// Polygons of 3, 8 and 64 edges (the label's parameter) and a rectangle; poles in the box. And std::asinh of the
// arguments that the definition of their edge sums has.
std::vector<Case> polygon_cases();

}  // namespace patchgrip::bench
