// The worst of a set of loads: how much grip the hardest of them asks for, or by how little all may be multiplied.
//
//     set        w = sum b_j c_j + sum y_k a_k,   b_j >= 0, sum b_j = 1,   |y| <= 1
//
// the convex hull of corners c_j, with an ellipsoid of semi-axes a_k about each of its loads: corners alone make a
// polytope, one corner with axes an ellipsoid or a ball. The axes need not be orthogonal.
//
//     worst_grip          max s(w)        s = min max F or min sum F
//     worst_load_factor   min lambda(w)   lambda = the largest for which w_0 + lambda w is carried, F_i <= limits_i
//
// What is held is convex, so s is convex in the load, and so is 1 / lambda (the gauge of what is held beside w_0, if
// w_0 itself is held). A convex function is largest at an extreme point of the set: at c_j + sum y_k a_k with |y| = 1.
//
// lower    of worst_grip: the grip of the hardest load found. From a load one goes to the farthest one along its escape
//          twist, and the grip never falls. `answer` has its forces and its twist.
// upper    over a piece of the sphere |y| = 1: with u_j its corners and m . u_j = 1, all of it lies in the convex hull
//          of u_j and |m| u_j, where a convex function is at most its value at y = 0 or the largest at |m| u_j. Pieces are
//          halved, the highest first, until the bounds meet or the budget is used up; what is lost falls with the
//          square of their diameter: a bracket of 1 % takes hundreds of pieces with 3 axes, one of 10 % takes 1e5 with 6. Of a
//          polytope nothing is lost: both bounds are those of its corners.
//
// A load that cannot be held is enough for `cannot_hold`; `holds` says that every load of the set is held.
//
// Units    as grasp.h. Corners and axes [N, N m].
// Error    the bracket; |m| is taken 1e-12 too long for its rounding and that of loads.
// Throws   std::invalid_argument on what is not finite, no corner, more than 6 axes, limits that are not positive.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <patchgrip/grasp/grasp.h>
#include <patchgrip/grasp/held_ball.h>

namespace patchgrip::grasp {

struct LoadSet {
  std::vector<Vector6> corners;
  std::vector<Vector6> axes = {};

  // All loads with |f|^2 + |m|^2 / l^2 <= r^2 about `centre`; r [N] and l [m] > 0.
  static LoadSet ball(const Vector6& centre, double radius, double length);
};

struct WorstLoadSettings {
  double relative_width = 0.01;                // of the bracket, in (0, 1)
  int max_simplices = 20000;                   // >= 0
  std::function<void()> check_interrupt = {};  // called for every simplex; what it throws ends the search

  // Throws std::invalid_argument, naming the setting.
  void check() const;
};

struct WorstLoad {
  Verdict verdict = Verdict::undecided;
  double lower = 0;
  double upper = 0;
  Vector6 load = Vector6::Zero();  // the worst that was found, or one that cannot be held
  GripAnswer answer;               // of that load
  int simplices = 0;
};

WorstLoad worst_grip(const std::vector<Contact>& contacts, const LoadSet& loads, GripMeasure measure,
                     const WorstLoadSettings& settings = {});

// Beside `load`, which is not multiplied. Where that cannot be held by itself the answer is that of holds_within.
WorstLoad worst_load_factor(const std::vector<Contact>& contacts, const Vector6& load, const LoadSet& loads,
                            std::span<const double> limits, const WorstLoadSettings& settings = {});

}  // namespace patchgrip::grasp
