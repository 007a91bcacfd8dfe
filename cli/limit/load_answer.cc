#include <patchgrip/cli/limit/load_answer.h>

#include <algorithm>

namespace patchgrip::cli::limit {
namespace {

using friction::Gauge;
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

}  // namespace patchgrip::cli::limit
