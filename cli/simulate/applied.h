// Loads that act on a body over time: a wrench times a course, and the sum of several.
//
//     constant   1
//     during     1 from t_1 on and before t_2, else 0
//     ramp       from 0 at t_1 to 1 at t_2, and 1 from there on
//     sine       mean + sin(w t + phase)
//     course     straight between points (t, value), constant before the first and after the last; two points at one
//                time are a jump, and the value there is that after it
//
// Units    t [s]; wrench [N], [N], [N m], in axes of space about the centre of mass.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include <patchgrip/dynamics/bristle_metric.h>

namespace patchgrip::cli {

struct ConstantCourse {};
struct DuringCourse {
  double from, to;
};
struct RampCourse {
  double from, to;
};
struct SineCourse {
  double mean, angular_frequency, phase;
};
struct PointCourse {
  std::vector<std::array<double, 2>> points;
};

using Course = std::variant<ConstantCourse, DuringCourse, RampCourse, SineCourse, PointCourse>;

double value_at(const Course& course, double t);

// The largest that it comes to from 0 to `end`, also from before a jump.
double largest_value(const Course& course, double end);

// Where it jumps or has a corner, in any order.
void add_corners(const Course& course, std::vector<double>& corners);

constexpr double steps_a_period = 40;

// A step that sees it: 1 / steps_a_period of the period of a sine, else infinite.
double longest_step(const Course& course);

struct Applied {
  dynamics::Vector3 wrench;
  Course course;
};

class AppliedLoads {
 public:
  // `others` are courses of what else changes, whose corners and steps count, too.
  explicit AppliedLoads(std::vector<Applied> loads, const std::vector<Course>& others = {});

  dynamics::Vector3 operator()(double t) const;

  std::vector<Course> courses() const;
  const std::vector<double>& corners() const noexcept { return corners_; }  // increasing
  double longest_step() const noexcept { return longest_step_; }

 private:
  std::vector<Applied> loads_;
  std::vector<double> corners_;
  double longest_step_;
};

}  // namespace patchgrip::cli
