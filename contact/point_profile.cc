#include <patchgrip/contact/point_profile.h>

#include <algorithm>
#include <cmath>

#include <patchgrip/contact/increasing_root.h>
#include <patchgrip/contact/numbered.h>
#include <patchgrip/contact/require.h>

namespace patchgrip::contact {
namespace {

// The segment between two nodes that holds the target, then its root.
template <class Value, class Slope>
double root_between(const std::vector<double>& nodes, const Value& value, const Slope& slope, const char* name,
                    double target) {
  require_in(name, target, 0, value(nodes.back()));
  const auto hi = std::partition_point(nodes.begin(), nodes.end(), [&](double r) { return value(r) < target; });
  if (hi == nodes.end()) return nodes.back();
  const double lo = hi == nodes.begin() ? 0 : *(hi - 1);
  return increasing_root(value, slope, target, lo + (*hi - lo) / 2, lo, *hi);
}

}  // namespace

PointProfile PointProfile::through(std::span<const ProfilePoint> points) {
  require_in("number of points", static_cast<double>(points.size()), 2, 1e6);
  require_in("r_0", points[0].radius, 0, 0);
  require_in("f_0", points[0].height, 0, 0);
  PointProfile profile;
  // Extended precision: a small kink is the difference of two slopes.
  long double before = 0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    require_finite(numbered("r", k), points[k].radius);
    require_finite(numbered("f", k), points[k].height);
    if (!(points[k].radius > points[k - 1].radius)) {
      refuse(numbered("r", k), points[k].radius, "must be greater than the radius before");
    }
    const long double rise = static_cast<long double>(points[k].height) - points[k - 1].height;
    const long double slope = rise / (static_cast<long double>(points[k].radius) - points[k - 1].radius);
    // Two slopes that differ by the rounding of the points are one.
    const double width = points[k].radius - points[k - 1].radius;
    const double rounding = 4 * 0x1p-53 * (points[k].height + static_cast<double>(slope) * points[k].radius) / width;
    const auto difference = static_cast<double>(slope - before);
    const double kink = k > 1 && std::fabs(difference) <= rounding ? 0 : difference;
    if (k == 1 && slope > 0) {
      profile.tip_slope_ = static_cast<double>(slope);
    } else if (kink > 0) {
      profile.kinks_.push_back(FlatEndCone::of(points[k - 1].radius, kink));
    } else if (kink < 0) {
      refuse(numbered("f", k), points[k].height, "must keep the slope from falling: contact is lost at a concave kink");
    }
    before = slope;
    profile.nodes_.push_back(points[k].radius);
  }
  if (!(before > 0))
    refuse(numbered("f", points.size() - 1), points.back().height, "must be positive: the stamp is flat");
  return profile;
}

double PointProfile::radius_of_approach(double approach) const {
  return root_between(
      nodes_, [&](double a) { return this->approach(a); }, [&](double a) { return approach_slope(a); }, "approach",
      approach);
}

double PointProfile::radius_of_force(double force) const {
  return root_between(
      nodes_, [&](double a) { return this->force(a); }, [&](double a) { return 2 * a * approach_slope(a); },
      "force / modulus", force);
}

}  // namespace patchgrip::contact
