// The point loads among the pressure of a patch: where its dissipation has kinks.
//
// A share w of the pressure that acts in a point P adds w |v_P| to D. With the pole on P this has no gradient: all
// forces through P up to w are subgradients, and the limit surface has a flat facet there. What is written for every
// patch (limit_surface/) asks for these parts here; a patch that has some tells them by a member
//
//     std::vector<PointShare> point_shares() const;
//
// and a patch without that member has none.
//
// Units    x, y [m]; share [1] of D's integral.
// Error    x, y are exact: a twist (w y, -w x, w), |w| a power of 2, is to the patch at rest at the point. A point
//          whose place has to be rounded is not told; share is good to 3 units of rounding a nesting.
#pragma once

#include <concepts>
#include <vector>

#include <patchgrip/friction/patch.h>

namespace patchgrip::friction {

struct PointShare {
  double x = 0;      // [m]
  double y = 0;      // [m]
  double share = 0;  // w [1]
};

template <Patch P>
std::vector<PointShare> point_shares(const P& patch) {
  if constexpr (requires {
                  { patch.point_shares() } -> std::same_as<std::vector<PointShare>>;
                }) {
    return patch.point_shares();
  } else {
    return {};
  }
}

}  // namespace patchgrip::friction
