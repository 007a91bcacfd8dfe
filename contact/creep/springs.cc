#include <patchgrip/contact/creep/springs.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace patchgrip::contact {
namespace {

// The springs in touch from the axis on, and the parabola through the last three of them: where it meets zero beyond
// the last, in distances, and its integral up to there.
struct Edge {
  std::size_t touching;  // springs with q > 0 from the axis on
  double beyond = 0;     // in [0, 1]
  double share = 0;      // of the integral, per distance
};

Edge edge_of(std::span<const double> q) {
  Edge edge{0};
  while (edge.touching < q.size() && q[edge.touching] > 0) ++edge.touching;
  if (edge.touching < 2) return edge;
  const std::size_t n = edge.touching - 1;
  const double slope = edge.touching > 2 ? (3 * q[n] - 4 * q[n - 1] + q[n - 2]) / 2 : q[n] - q[n - 1];
  const double curvature = edge.touching > 2 ? q[n] - 2 * q[n - 1] + q[n - 2] : 0;
  // q + slope z + curvature z^2 / 2 = 0
  const double root = slope * slope - 2 * curvature * q[n];
  double z = slope < 0 && root >= 0 ? 2 * q[n] / (-slope + std::sqrt(root)) : 1;
  z = std::clamp(z, 0., 1.);
  edge.beyond = z;
  edge.share = std::max(0., z * (q[n] + z * (slope / 2 + z * curvature / 6)));
  return edge;
}

// int over 0 .. n of values at whole numbers, Simpson; an odd last cell by the parabola of the last three.
double simpson(std::span<const double> q) {
  if (q.size() < 2) return 0;
  if (q.size() == 2) return (q[0] + q[1]) / 2;
  const std::size_t cells = q.size() - 1;
  double sum = 0;
  for (std::size_t k = 0; k + 2 <= cells; k += 2) sum += (q[k] + 4 * q[k + 1] + q[k + 2]) / 3;
  if (cells % 2 == 1) sum += (5 * q[cells] + 8 * q[cells - 1] - q[cells - 2]) / 12;
  return sum;
}

}  // namespace

Springs::Springs(SpringLaw law, double distance, std::vector<double> heights)
    : law_(std::move(law)),
      distance_(distance),
      heights_(std::move(heights)),
      state_{std::vector<Spring>(heights_.size()), std::vector<double>(heights_.size() * law_.modes())},
      stresses_(heights_.size()) {}

Springs::Response Springs::step(const State& from, double approach, double duration) {
  const std::size_t modes = law_.modes();
  state_ = from;
  double stiffness = 0;
  for (const auto& mode : law_.creep().modulus.modes()) {
    const double z = duration / mode.time;
    stiffness += mode.strength * (z > 0 ? -std::expm1(-z) / z : 1);
  }
  stiffness += law_.creep().modulus.equilibrium();
  for (std::size_t k = 0; k < heights_.size(); ++k) {
    const std::span<double> relaxing(state_.relaxing.data() + k * modes, modes);
    Spring& spring = state_.springs[k];
    if (duration > 0) {
      law_.advance(spring, relaxing, approach_ - heights_[k], (approach - approach_) / duration, duration);
    } else {
      law_.jump(spring, relaxing, approach - heights_[k]);
    }
    stresses_[k] = law_.stress(spring, relaxing);
  }
  const Edge edge = edge_of(stresses_);
  const double touching = edge.touching > 0 ? static_cast<double>(edge.touching) - 1 + edge.beyond : 0;
  const double force = simpson(std::span(stresses_).first(edge.touching)) + edge.share;
  return {2 * distance_ * force, 2 * distance_ * std::max(touching, 0.5) * stiffness};
}

void Springs::advance_to_approach(double duration, double approach) {
  require_non_negative("duration", duration);
  require_finite("approach", approach);
  require_in("approach", approach, -heights_.back(), heights_.back());
  const State from = state_;
  step(from, approach, duration);
  approach_ = approach;
}

void Springs::advance_to_force(double duration, double force) {
  require_non_negative("duration", duration);
  require_non_negative("force", force);
  largest_force_ = std::max(largest_force_, force);
  const State from = state_;
  const double before = approach_;
  double lo = -heights_.back(), hi = heights_.back();
  double approach = before;
  Response response{0, 0};
  for (int iteration = 0; iteration < 200; ++iteration) {
    response = step(from, approach, duration);
    const double lack = force - response.force;
    (lack > 0 ? lo : hi) = approach;
    const double change = lack / response.stiffness;
    const bool is_exact = std::fabs(lack) <= 4 * 0x1p-53 * largest_force_;
    const bool is_narrow = hi - lo <= 4 * 0x1p-53 * std::max(std::fabs(lo), std::fabs(hi));
    if (is_exact || is_narrow || std::fabs(change) <= 0x1p-53 * std::fabs(approach)) {
      if (force > 0 && lo >= heights_.back() * (1 - 8 * 0x1p-53)) {
        step(from, before, 0);
        state_ = from;
        refuse("force", force, "must leave the radius within `widest`");
      }
      approach_ = approach;
      return;
    }
    approach += change;
    if (!(approach > lo && approach < hi)) approach = lo + (hi - lo) / 2;
  }
  throw std::runtime_error("the approach of a force did not settle: residual " +
                           std::to_string(force - response.force));
}

Estimate Springs::force() const {
  const Edge edge = edge_of(stresses_);
  const auto q = std::span(stresses_).first(edge.touching);
  const double value = 2 * distance_ * (simpson(q) + edge.share);
  if (edge.touching < 6) return {value, value};
  // A kink in a cell shows in one second difference, smooth curvature in all of them. Four times what they say: several
  // kinks, and layers thinner than a cell. A layer between the last spring and the edge shows in none, and brings the
  // edge nearer than the parabola says: half of what lies beyond, as where q falls twice as steeply.
  const auto bend = [&](std::size_t k) { return q[k - 1] - 2 * q[k] + q[k + 1]; };
  const std::size_t last = edge.touching - 2;
  double error = 0;
  for (std::size_t k = 1; k <= last; ++k) {
    const double before = k > 1 ? bend(k - 1) : bend(k + 1);
    const double after = k < last ? bend(k + 1) : bend(k - 1);
    error += std::fabs(bend(k) - (before + after) / 2) / 3;
  }
  // Beyond the last spring: the parabola against the straight line, and what the last third difference leaves open.
  const double fall = q[last] - q[last + 1];
  const double straight = fall > 0 ? std::min(1., q[last + 1] / fall) * q[last + 1] / 2 : q[last + 1];
  error += std::fabs(edge.share - straight) + std::fabs(bend(last) - bend(last - 1));
  return {value, 2 * distance_ * (4 * error + edge.share / 2) + 64 * 0x1p-53 * value};
}

double Springs::radius() const {
  const Edge edge = edge_of(stresses_);
  return edge.touching > 0 ? distance_ * (static_cast<double>(edge.touching) - 1 + edge.beyond) : 0;
}

double Springs::pressure(double r) const {
  require_non_negative("r", r);
  const Edge edge = edge_of(stresses_);
  const double a = radius();
  if (r >= a) return 0;
  double sum = 0;
  for (std::size_t k = 0; k < edge.touching; ++k) {
    const bool is_last = k + 1 == edge.touching;
    const double lo = distance_ * static_cast<double>(k);
    const double hi = is_last ? a : lo + distance_;
    if (hi <= r || !(hi > lo)) continue;
    const double slope = ((is_last ? 0 : stresses_[k + 1]) - stresses_[k]) / (hi - lo);
    // int dx / sqrt(x^2 - r^2) = arcosh(x / r); the first cell of r = 0 is a parabola, not a line.
    if (r > 0) {
      sum -= slope * (std::acosh(std::max(1., hi / r)) - std::acosh(std::max(1., lo / r)));
    } else {
      sum -= slope * (k == 0 ? 2 : std::log(hi / lo));
    }
  }
  return std::numbers::inv_pi * sum;
}

bool Springs::is_one_circle() const {
  const Edge edge = edge_of(stresses_);
  return std::all_of(stresses_.begin() + static_cast<std::ptrdiff_t>(edge.touching), stresses_.end(),
                     [](double q) { return q <= 0; });
}

bool Springs::stress_falls() const {
  const double rounding = 64 * 0x1p-53 * stresses_.front();
  for (std::size_t k = 1; k < stresses_.size(); ++k) {
    if (stresses_[k] > stresses_[k - 1] + rounding) return false;
  }
  return true;
}

}  // namespace patchgrip::contact
