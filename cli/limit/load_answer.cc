#include <patchgrip/cli/limit/load_answer.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <patchgrip/cli/input_error.h>

namespace patchgrip::cli::limit {
namespace {

using friction::Gauge;
using friction::Twist;
using friction::Wrench;

constexpr double unit = 0x1p-53;
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Slip slip_of(const Gauge& gauge, const Wrench& load, const friction::PatchView& patch,
             const friction::PressureFrame& frame, double shape_error) noexcept {
  const friction::SlipError error = friction::slip_error(gauge, load, patch, frame, shape_error);
  return {gauge.twist, error.speed, error.spin, error.pole, error.pole_error};
}

LoadAnswer answer_of(const Wrench& load, const Gauge& gauge, const Slip& slip, double area_radius,
                     const Capacity& capacity) noexcept {
  const double g = gauge.value;
  const double grown = capacity.shape_error < 1 ? capacity.shape_error / (1 - capacity.shape_error) : infinity;
  const double upper = gauge.upper * (1 + grown);
  const double lower = gauge.lower * (1 - grown);
  LoadAnswer answer{load, gauge, std::max(upper - g, g - lower), {infinity, 0}, {}, Verdict::undecided, slip};
  answer.stick_radius = {std::numeric_limits<double>::quiet_NaN(), 0};
  const double least = capacity.value * (1 - capacity.relative_error);
  const double most = capacity.value * (1 + capacity.relative_error);
  if (upper <= least) answer.verdict = Verdict::holds;
  if (lower > most) answer.verdict = Verdict::slips;
  if (!answer.loaded()) return answer;
  const double margin = capacity.value / g;
  answer.margin = {margin, std::max(most / lower - margin, margin - least / upper) + unit * margin};
  if (area_radius > 0) {
    const double radius = std::hypot(load.fx, load.fy, load.m / area_radius) / g;
    answer.stick_radius = {radius, radius * (answer.gauge_error / lower + 4 * unit)};
  }
  return answer;
}

LoadAnswer answer_between(const LoadAnswer& answer, double area_radius, const LoadAnswer& narrow, double narrow_radius,
                          const LoadAnswer& wide, const friction::Pole& centre, const Capacity& capacity) noexcept {
  // D = |w| S(distance of the pole) grows with the radius, and S is convex: the gauge falls, the pole of the slip moves
  // off along its ray, the spin falls and the speed of the centre grows.
  Gauge gauge = answer.gauge;
  gauge.upper = std::max(gauge.upper, narrow.gauge.upper);
  gauge.lower = std::min(gauge.lower, wide.gauge.lower);
  Slip slip = answer.slip;
  const Twist own = moved_to(centre, slip.twist);
  const double arm = std::hypot(centre.x, centre.y);
  double speed = 0;
  for (const LoadAnswer* end : {&narrow, &wide}) {
    const Slip& other = end->slip;
    const Twist moved = moved_to(centre, other.twist);
    const double pole = std::hypot(other.pole.x - slip.pole.x, other.pole.y - slip.pole.y);
    slip.spin_error = std::max(slip.spin_error, std::fabs(own.w - moved.w) + other.spin_error);
    slip.pole_error = std::max(slip.pole_error, std::isinf(other.pole_error) ? infinity : pole + other.pole_error);
    speed =
        std::max(speed, std::hypot(own.vx - moved.vx, own.vy - moved.vy) + other.speed_error + arm * other.spin_error);
  }
  slip.speed_error = std::max(slip.speed_error, speed + arm * slip.spin_error);
  LoadAnswer between = answer_of(answer.load, gauge, slip, area_radius, capacity);
  // Its force and moment over a_K falls with the radius, no faster than when it shrinks to the narrow one.
  const auto wrench_over = [&](double radius) {
    return std::hypot(answer.load.fx, answer.load.fy, answer.load.m / radius);
  };
  const double grown = wrench_over(narrow_radius) / wrench_over(area_radius) - 1;
  between.stick_radius.error = std::max(
      between.stick_radius.error, between.stick_radius.value * (grown + answer.gauge_error / gauge.lower + 8 * unit));
  return between;
}

}  // namespace patchgrip::cli::limit
