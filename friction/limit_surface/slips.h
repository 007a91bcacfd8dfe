// Slips of a patch that show all of its limit surface: samples for fits.
//
// Cones of twists are bisected along the edge over which twist and wrench together differ most, the one of the longest
// such edge first, so that neither leave wide gaps. Over a kink of D (a point load) wrenches differ at one twist: an
// edge is not cut any more where its twists agree to `finest`, and what is beyond stays the facet that it is.
//
// Domain   support functions with h > 0 for every twist but 0 (CentredFrame::of() refuses others).
// Units    those of the frame (support_function.h): D = 1, wrenches per mu F_N.
// Error    that of the support function.
// Throws   nothing of its own.
#pragma once

#include <vector>

#include <patchgrip/friction/limit_surface/support_function.h>

namespace patchgrip::friction {

// A slip with D = 1, a point of the surface polar to the limit surface, and its wrench, a point of the limit surface.
struct Slip {
  Twist twist;
  Wrench wrench;
};

// `count` slips, one of v and -v each; fewer only where all edges are finest.
std::vector<Slip> spread_slips(const SupportFunction& D, std::size_t count);

}  // namespace patchgrip::friction
