#include <patchgrip/bench/poles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <patchgrip/bench/random.h>

namespace patchgrip::bench {
namespace {

// Poles at `distance(random)` radii from the centre, in any direction.
template <class Distance>
PoleSet round_poles(std::string mix, double radius, std::size_t count, const Distance& distance) {
  std::mt19937_64 random(1);
  PoleSet poles{std::move(mix), {}, {}};
  poles.x.reserve(count);
  poles.y.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double r = radius * distance(random);
    const double angle = uniform(random, -std::numbers::pi, std::numbers::pi);
    poles.x.push_back(r * std::cos(angle));
    poles.y.push_back(r * std::sin(angle));
  }
  return poles;
}

}  // namespace

PoleSet PoleSet::first(std::size_t count) const {
  const auto n = static_cast<std::ptrdiff_t>(std::min(count, x.size()));
  return {mix, {x.begin(), x.begin() + n}, {y.begin(), y.begin() + n}};
}

PoleSet mixed_poles(double radius, std::size_t count) {
  return round_poles("mixed", radius, count, [](auto& random) { return log_uniform(random, 1e-6, 1e6); });
}

PoleSet near_poles(double radius, std::size_t count) {
  return round_poles("near", radius, count, [](auto& random) { return log_uniform(random, 0.1, 10); });
}

PoleSet inside_poles(double radius, std::size_t count) {
  return round_poles("inside", radius, count, [](auto& random) { return uniform(random, 0, 1); });
}

PoleSet outside_poles(double radius, std::size_t count) {
  return round_poles("outside", radius, count,
                     [](auto& random) { return 1 / uniform(random, std::numeric_limits<double>::epsilon(), 1); });
}

PoleSet rim_poles(double radius, std::size_t count) {
  return round_poles("rim", radius, count, [](auto& random) {
    const double distance = log_uniform(random, 1e-15, 0.5);
    return uniform(random, -1, 1) < 0 ? 1 - distance : 1 + distance;
  });
}

PoleSet box_poles(const std::vector<friction::Point>& polygon, std::size_t count) {
  constexpr double widening = 1.5;
  const auto [left, right] = std::ranges::minmax(polygon, {}, &friction::Point::x);
  const auto [low, high] = std::ranges::minmax(polygon, {}, &friction::Point::y);
  const double x = (left.x + right.x) / 2;
  const double y = (low.y + high.y) / 2;
  const double half_width = widening * (right.x - left.x) / 2;
  const double half_height = widening * (high.y - low.y) / 2;
  std::mt19937_64 random(1);
  PoleSet poles{"box", {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    poles.x.push_back(x + uniform(random, -half_width, half_width));
    poles.y.push_back(y + uniform(random, -half_height, half_height));
  }
  return poles;
}

std::vector<friction::Twist> twists_about(const PoleSet& poles) {
  std::vector<friction::Twist> twists;
  twists.reserve(poles.x.size());
  for (std::size_t i = 0; i < poles.x.size(); ++i) {
    twists.push_back(friction::twist_about({poles.x[i], poles.y[i]}, 1));
  }
  return twists;
}

}  // namespace patchgrip::bench
