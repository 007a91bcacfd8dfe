#include <patchgrip/bench/truth.h>

#include <cmath>

#include <patchgrip/bench/reference_truth.h>
#include <patchgrip/friction/kernels/round_functions.h>
#include <patchgrip/tests/friction/ellipse_reference.h>
#include <patchgrip/tests/friction/polygon_reference.h>
#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/friction/stack_reference.h>

namespace patchgrip::bench {
namespace {

using friction::Real50;
using friction::Twist;
using friction::Wrench;
using friction::Wrench50;

TrueWrench split(const Wrench50& w) {
  const auto head = [](const Real50& value) { return static_cast<double>(value); };
  const auto tail = [](const Real50& value) { return static_cast<double>(value - static_cast<double>(value)); };
  return {{head(w.fx), head(w.fy), head(w.m)}, {tail(w.fx), tail(w.fy), tail(w.m)}};
}

template <class Gradient>
Truth truth_of(std::span<const Twist> twists, const Gradient& gradient) {
  Truth truth;
  truth.reserve(twists.size());
  for (const Twist& v : twists) truth.push_back(split(gradient(v)));
  return truth;
}

// NaN stays.
void keep_larger(double& worst, double error) {
  if (error > worst || std::isnan(error)) worst = error;
}

}  // namespace

Truth reference_truth(const friction::Gradient50& gradient, std::span<const Twist> twists) {
  return truth_of(twists, [&](const Twist& v) { return gradient(v.vx, v.vy, v.w); });
}

Truth power_disc_truth(double radius, double exponent, std::span<const Twist> twists) {
  const friction::kernels::PowerFamily<Real50> source{Real50(exponent)};
  return truth_of(twists, [&](const Twist& v) { return friction::round_wrench(source, radius, v); });
}

Truth xydas_kao_truth(double radius, double alpha, std::span<const Twist> twists) {
  const friction::StackReference<Real50> source(alpha);
  return truth_of(twists, [&](const Twist& v) { return friction::round_wrench(source, radius, v); });
}

Truth hertz_ellipse_truth(double a, double b, std::span<const Twist> twists) {
  const friction::EllipseReference reference(a, b);
  return truth_of(twists, [&](const Twist& v) { return reference.gradient(v); });
}

Truth polygon_truth(const std::vector<friction::Point>& polygon, std::span<const Twist> twists) {
  std::vector<friction::kernels::Vertex> ring;
  ring.reserve(polygon.size());
  for (const auto& point : polygon) ring.push_back({point.x, point.y});
  const friction::PolygonReference reference({ring});
  return truth_of(twists, [&](const Twist& v) { return reference.gradient(v); });
}

WorstError worst_error(const Truth& truth, std::span<const Wrench> computed, double scale_radius) {
  WorstError worst;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto& [head, tail] = truth[i];
    const Wrench& g = computed[i];
    const double force_error = std::hypot(g.fx - head.fx - tail.fx, g.fy - head.fy - tail.fy);
    const double moment_error = std::fabs(g.m - head.m - tail.m);
    keep_larger(worst.force, force_error / std::hypot(head.fx, head.fy));
    keep_larger(worst.moment, moment_error / std::fabs(head.m));
    keep_larger(worst.force_of_scale, force_error);
    keep_larger(worst.moment_of_scale, moment_error / scale_radius);
    keep_larger(worst.wrench, std::hypot(force_error, moment_error / scale_radius) /
                                  std::hypot(head.fx, head.fy, head.m / scale_radius));
  }
  return worst;
}

}  // namespace patchgrip::bench
