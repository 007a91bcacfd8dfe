// Slips of a patch that show all of its limit surface: samples for fits.
#pragma once

#include <vector>

#include <patchgrip/friction/limit_surface/support_function.h>

namespace patchgrip::friction {

// A slip with D = 1, a point of the surface polar to the limit surface, and its wrench, a point of the limit surface.
struct Slip {
  Twist twist;
  Wrench wrench;
};

// `count` slips, one of v and -v each, so that neither the twists nor the wrenches leave wide gaps: cones of twists are
// bisected along the edge over which both together differ most, the one of the longest such edge first.
std::vector<Slip> spread_slips(const SupportFunction& D, std::size_t count);

}  // namespace patchgrip::friction
