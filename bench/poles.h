// The poles that a benchmark draws. Which side of the rim they lie on decides which branch a method takes, and with it
// time and error.
//
//     mixed    r_M / a log-uniform from 1e-6 to 1e6
//     near     r_M / a log-uniform from 0.1 to 10
//     inside   r_M / a uniform in (0, 1)
//     outside  a / r_M uniform in (0, 1)
//     rim      |r_M / a - 1| log-uniform from 1e-15 to 0.5
//     box      uniform in the bounding box of a polygon, widened 1.5 times
//
// Every set is the same in every run.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/twist.h>

namespace patchgrip::bench {

struct PoleSet {
  std::string mix;
  std::vector<double> x, y;  // [m]

  // The first `count` poles, all of them if there are fewer.
  PoleSet first(std::size_t count) const;
};

PoleSet mixed_poles(double radius, std::size_t count);
PoleSet near_poles(double radius, std::size_t count);
PoleSet inside_poles(double radius, std::size_t count);
PoleSet outside_poles(double radius, std::size_t count);
PoleSet rim_poles(double radius, std::size_t count);
PoleSet box_poles(const std::vector<friction::Point>& polygon, std::size_t count);

// Rotations about the poles with 1 rad/s, counterclockwise.
std::vector<friction::Twist> twists_about(const PoleSet& poles);

}  // namespace patchgrip::bench
