// The judge of every method: grad D in 50 digits, and how far computed values are from it.
#pragma once

#include <span>
#include <vector>

#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

// A number of twice the precision of double: the sum of both.
struct TrueWrench {
  friction::Wrench head;
  friction::Wrench tail;
};

using Truth = std::vector<TrueWrench>;

// p ~ (1 - r^2/a^2)^(n - 1/2).
Truth power_disc_truth(double radius, double exponent, std::span<const friction::Twist> twists);
// p ~ (1 - (r/a)^alpha)^(1/alpha), as a stack of uniform discs: slow.
Truth xydas_kao_truth(double radius, double alpha, std::span<const friction::Twist> twists);
// Hertz pressure on an ellipse with the semi-axes a along x and b along y, a not equal to b.
Truth hertz_ellipse_truth(double a, double b, std::span<const friction::Twist> twists);
// Uniform pressure on a polygon, counterclockwise.
Truth polygon_truth(const std::vector<friction::Point>& polygon, std::span<const friction::Twist> twists);

struct WorstError {
  double force = 0;            // relative to the force
  double moment = 0;           // relative to the moment
  double force_of_scale = 0;   // relative to mu F_N
  double moment_of_scale = 0;  // relative to mu F_N a_K
  double wrench = 0;           // force and moment / a_K as one vector, relative to it
};

WorstError worst_error(const Truth& truth, std::span<const friction::Wrench> computed, double scale_radius);

}  // namespace patchgrip::bench
