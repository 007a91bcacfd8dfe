#include <patchgrip/cli/simulate/applied.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace patchgrip::cli {
namespace {

struct Value {
  double t;

  double operator()(const ConstantCourse&) const { return 1; }
  double operator()(const DuringCourse& c) const { return t >= c.from && t < c.to ? 1 : 0; }
  double operator()(const RampCourse& c) const { return std::clamp((t - c.from) / (c.to - c.from), 0., 1.); }
  double operator()(const SineCourse& c) const { return c.mean + std::sin(c.angular_frequency * t + c.phase); }
  double operator()(const PointCourse& c) const {
    const auto after = std::ranges::upper_bound(c.points, t, {}, [](const auto& p) { return p[0]; });
    if (after == c.points.begin()) return c.points.front()[1];
    if (after == c.points.end()) return c.points.back()[1];
    const auto& [t0, y0] = *(after - 1);
    const auto& [t1, y1] = *after;
    return std::lerp(y0, y1, (t - t0) / (t1 - t0));
  }
};

// From 0 to `end`.
struct Largest {
  double end;

  double operator()(const ConstantCourse&) const { return 1; }
  double operator()(const DuringCourse& c) const { return c.from <= end && c.to > 0 ? 1 : 0; }
  double operator()(const RampCourse& c) const { return Value{end}(c); }
  double operator()(const SineCourse& c) const {
    const double turn = 2 * std::numbers::pi, to_crest = std::fmod(turn / 4 - c.phase, turn);
    const bool crests = to_crest + (to_crest < 0 ? turn : 0) <= c.angular_frequency * end;
    return crests ? c.mean + 1 : std::max(Value{0}(c), Value{end}(c));
  }
  double operator()(const PointCourse& c) const {
    double largest = std::max(Value{0}(c), Value{end}(c));
    for (const auto& [t, value] : c.points) {
      if (t > 0 && t <= end) largest = std::max(largest, value);
    }
    return largest;
  }
};

struct Corners {
  std::vector<double>& all;

  void operator()(const ConstantCourse&) const {}
  void operator()(const DuringCourse& c) const { all.insert(all.end(), {c.from, c.to}); }
  void operator()(const RampCourse& c) const { all.insert(all.end(), {c.from, c.to}); }
  void operator()(const SineCourse&) const {}
  void operator()(const PointCourse& c) const {
    for (const auto& p : c.points) all.push_back(p[0]);
  }
};

}  // namespace

double value_at(const Course& course, double t) { return std::visit(Value{t}, course); }

double largest_value(const Course& course, double end) { return std::visit(Largest{end}, course); }

void add_corners(const Course& course, std::vector<double>& corners) { std::visit(Corners{corners}, course); }

double longest_step(const Course& course) {
  const auto* sine = std::get_if<SineCourse>(&course);
  return sine != nullptr ? 2 * std::numbers::pi / sine->angular_frequency / steps_a_period
                         : std::numeric_limits<double>::infinity();
}

AppliedLoads::AppliedLoads(std::vector<Applied> loads, const std::vector<Course>& others)
    : loads_(std::move(loads)), longest_step_(std::numeric_limits<double>::infinity()) {
  const auto see = [&](const Course& course) {
    add_corners(course, corners_);
    longest_step_ = std::min(longest_step_, cli::longest_step(course));
  };
  for (const Applied& a : loads_) see(a.course);
  std::ranges::for_each(others, see);
  std::ranges::sort(corners_);
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
}

std::vector<Course> AppliedLoads::courses() const {
  std::vector<Course> all;
  for (const Applied& a : loads_) all.push_back(a.course);
  return all;
}

dynamics::Vector3 AppliedLoads::operator()(double t) const {
  dynamics::Vector3 sum = dynamics::Vector3::Zero();
  for (const Applied& a : loads_) sum += value_at(a.course, t) * a.wrench;
  return sum;
}

}  // namespace patchgrip::cli
