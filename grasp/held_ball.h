// The largest ball of loads that a grasp holds: Ferrari and Canny's quality.
//
//     eps = min over |w| = 1 of 1 / s(w),   |w|^2 = |f|^2 + |m|^2 / l^2,   s the least grip that holds w
//         = min over |W| = 1 of H(W),       |W|^2 = |v|^2 + l^2 |omega|^2
//
// with s = min max F and H = sum rho_i+ (each finger gives at most 1), or s = min sum F and H = max rho_i+ (all give 1
// together). H is convex but the sphere is not: there are many local minima.
//
// upper    of the best of them. From W one shoots at w = W until the grasp gives way; the normal there is the next W,
//          and H never rises.
// lower    H(W) >= x . W for every load x that is held. Over a spherical simplex of twists x . W is least at a corner,
//          which bounds eps there: of x = grad H and of the largest load held along the middle of the simplex, and
//          halfway between. Simplices are halved, the lowest first, until the bounds meet or the budget is used up. What
//          is lost falls with the square of their diameter.
//
// C. Ferrari, J. Canny, "Planning optimal grasps", ICRA 1992. The ball depends on l and on the origin of moments.
//
// Units    l [m]; eps: N of load for 1 N of grip.
// Error    the bracket. Rounding of H is added to upper, of x . W taken off lower.
// Throws   std::invalid_argument on a length or a width that cannot be.
#pragma once

#include <functional>
#include <vector>

#include <patchgrip/grasp/grasp.h>

namespace patchgrip::grasp {

enum class GripMeasure { largest_force, total_force };

struct BallSettings {
  double relative_width = 0.05;  // of the bracket, in (0, 1)
  int max_simplices = 200000;    // >= 0; 0 for the upper bound alone
  bool planar = false;  // only forces in the x-y-plane and moments about z, of a grasp that is its own mirror image
  std::function<void()> check_interrupt = {};  // called for every simplex; what it throws ends the search

  // Throws std::invalid_argument, naming the setting.
  void check() const;
};

struct HeldBall {
  double lower = 0;
  double upper = 0;
  Vector6 twist = Vector6::Zero();  // unit normal where the ball touches what is held, by `upper`
  Vector6 load = Vector6::Zero();   // the weakest direction, of size 1
  int simplices = 0;
};

HeldBall held_ball(const std::vector<Contact>& contacts, GripMeasure measure, double length,
                   const BallSettings& settings = {});

}  // namespace patchgrip::grasp
