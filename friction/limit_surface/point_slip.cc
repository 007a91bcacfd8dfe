#include <patchgrip/friction/limit_surface/point_slip.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;

// Further away D is smooth enough for Newton's method; in radii of gyration.
constexpr double reach = 0.3;

// Next to a point the velocity of it is what rounding leaves of two of about a radius of gyration: nearer than this, in
// such radii, its direction is off by 1e-4 and the gauge differs from that about the point by rounding alone.
constexpr double nearest = 1e4 * unit;

// A stiffness of fewer roundings of H_R than that is none.
constexpr double least_stiffness = 4;

Wrench times(double k, const Wrench& t) noexcept { return {k * t.fx, k * t.fy, k * t.m}; }

// grad R and the force q through the point, shortened to what it bears.
BoundedWrench point_of_body(const Kink& kink, const BoundedWrench& rest, const Planar& asked) noexcept {
  const double w = kink.point.share;
  const double size = length_of(asked);
  const double k = size > w ? w / size : 1;
  const Wrench q = kink.through_point({k * asked.x, k * asked.y});
  BoundedWrench b{
      {rest.value.fx + q.fx, rest.value.fy + q.fy, rest.value.m + q.m}, rest.force_error, rest.moment_error};
  // A q that is longer than the point bears by that much, and the rounding of the sums.
  const double error = 4 * unit * w + unit * std::hypot(b.value.fx, b.value.fy);
  const double arm = std::fabs(kink.point.x) + std::fabs(kink.point.y);
  b.force_error += error;
  b.moment_error += arm * error + unit * (2 * std::fabs(q.m) + std::fabs(b.value.m));
  return b;
}

// About the point itself: on its facet where the force asked of it is less than it bears, rounding included. At the rim
// of the facet the pole is next to the point, unless nothing keeps it there.
GaugeStatus status_of(const Kink& kink, const NearKink& near, const Planar& asked, double error) noexcept {
  if (near.z.x != 0 || near.z.y != 0) return GaugeStatus::converged;
  if (length_of(asked) + error < kink.point.share) return GaugeStatus::facet;
  return stiffness_along(kink.stiffness, asked) > 0 ? GaugeStatus::converged : GaugeStatus::ridge;
}

}  // namespace

double stiffness_along(const Stiffness& h, const Planar& a) noexcept {
  const Planar ha = h * a;
  const double along = (a.x * ha.x + a.y * ha.y) / (a.x * a.x + a.y * a.y);
  return along > least_stiffness * h.rounding ? along : 0;
}

PointForce point_force(const Kink& kink, const NearKink& near, const Wrench& load) noexcept {
  const double speed = length_of(near.z);
  // About the point nothing cancels that need not.
  const double tv = load.fx * near.z.x + load.fy * near.z.y + kink.moment(load);
  const Wrench& r = near.rest.value;
  const double D = r.fx * near.z.x + r.fy * near.z.y + kink.moment(r) + kink.point.share * speed;
  const double g = tv / D;
  return {g, D, {load.fx / g - r.fx, load.fy / g - r.fy}};
}

Planar velocity_of_point(const Stiffness& h, double w, const Planar& a, double longest) noexcept {
  // Along the axes of H.
  const double angle = 0.5 * std::atan2(2 * h.xy, h.xx - h.yy);
  const double c = std::cos(angle), s = std::sin(angle);
  const double mean = 0.5 * (h.xx + h.yy), apart = std::hypot(0.5 * (h.xx - h.yy), h.xy);
  const double h1 = std::max(mean + apart, 0.), h2 = std::max(mean - apart, 0.);
  const double a1 = c * a.x + s * a.y, a2 = c * a.y - s * a.x;
  // Of the length r: n(r) = |a_i / (h_i r + w)| = 1, by Newton's method for 1 / n, which is nearly linear.
  double r = 0;
  for (int i = 0; i < 20; ++i) {
    const double n1 = a1 / (h1 * r + w), n2 = a2 / (h2 * r + w);
    const double n = std::hypot(n1, n2);
    const double slope = (n1 * n1 * h1 / (h1 * r + w) + n2 * n2 * h2 / (h2 * r + w)) / (n * n * n);
    const double next = std::min(r + (1 - 1 / n) / slope, longest);
    if (!(std::fabs(next - r) > 4 * unit * r)) break;
    r = std::max(next, 0.);
  }
  double z1 = r * a1 / (h1 * r + w), z2 = r * a2 / (h2 * r + w);
  if (const double length = std::hypot(z1, z2); length > longest) z1 *= longest / length, z2 *= longest / length;
  return {c * z1 - s * z2, s * z1 + c * z2};
}

std::optional<Gauge> gauge_at(const Kink& kink, const PatchView& patch, const PressureFrame& frame, const Wrench& load,
                              const GaugeSettings& settings, int& evaluations) noexcept {
  constexpr int most_steps = 12;
  const double w = kink.point.share;
  const double sense = kink.moment(load) < 0 ? -1 : 1;
  const Wrench t = times(sense, load);
  NearKink near = kink.at_rest;
  Stiffness h = kink.stiffness;
  double lower = 0, upper = std::numeric_limits<double>::infinity(), width = upper;
  for (int steps = 0; steps < most_steps; ++steps) {
    const auto [g, D, asked] = point_force(kink, near, t);
    if (!(g > 0)) return std::nullopt;
    const bool at_rest = near.z.x == 0 && near.z.y == 0;
    const BoundedWrench b = point_of_body(kink, near.rest, asked);
    const Bracket bracket = certify(frame, t, near.twist, b);
    lower = std::max(lower, at_rest ? bracket.lower : certify(frame, t, near.twist, near.whole).lower);
    upper = std::min(upper, bracket.upper);
    const bool still = !(upper - lower < 0.5 * width);
    width = upper - lower;
    if (width <= settings.relative_gap * lower ||
        (still && Bracket{lower, upper, bracket.gap, bracket.rounding}.narrow(settings.relative_gap))) {
      const double k = sense / D;
      return Gauge{std::clamp(g, lower, upper),
                   lower,
                   upper,
                   {k * near.twist.vx, k * near.twist.vy, k * near.twist.w},
                   evaluations,
                   status_of(kink, near, asked, b.force_error)};
    }
    if (steps > 2 && still) return std::nullopt;
    if (evaluations >= settings.max_evaluations) return std::nullopt;
    const Planar hz = h * near.z;
    const Planar z = velocity_of_point(h, w, {asked.x + hz.x, asked.y + hz.y}, reach * frame.length);
    if (!(length_of(z) < 0.9 * reach * frame.length)) return std::nullopt;
    near = kink.near(patch, z);
    ++evaluations;
    if (length_of(near.z) > beside * frame.length) h = kink.stiffness_at(patch, near.twist);
  }
  return std::nullopt;
}

const Kink* likely_kink(const PressureFrame& frame, const Wrench& load) noexcept {
  const Kink* likely = nullptr;
  double least = 0.9 * reach * frame.length;
  for (const Kink& kink : frame.kinks) {
    const auto [g, D, asked] = point_force(kink, kink.at_rest, times(kink.moment(load) < 0 ? -1 : 1, load));
    if (!(g > 0)) continue;
    const double w = kink.point.share;
    if (length_of(asked) <= w) return &kink;
    const double distance = length_of(velocity_of_point(kink.stiffness, w, asked, reach * frame.length));
    if (!(distance < least)) continue;
    least = distance;
    likely = &kink;
  }
  return likely;
}

const Kink* nearest_kink(const PressureFrame& frame, const Twist& v) noexcept {
  const auto nearest =
      std::ranges::min_element(frame.kinks, {}, [&](const Kink& k) { return length_of(k.velocity(v)); });
  return nearest == frame.kinks.end() ? nullptr : &*nearest;
}

std::optional<Twist> away_from(const Kink& kink, const PatchView& patch, const PressureFrame& frame, const Wrench& load,
                               int& evaluations) noexcept {
  const double sense = kink.moment(load) < 0 ? -1 : 1;
  const Wrench t = times(sense, load);
  const PointForce about = point_force(kink, kink.at_rest, t);
  if (!(length_of(about.asked) > kink.point.share)) return std::nullopt;
  for (double longest = reach * frame.length; longest > nearest * frame.length; longest *= 0.25) {
    const Planar z = velocity_of_point(kink.stiffness, kink.point.share, about.asked, longest);
    const NearKink near = kink.near(patch, z);
    ++evaluations;
    if (point_force(kink, near, t).gauge > about.gauge) {
      return Twist{sense * near.twist.vx, sense * near.twist.vy, sense * near.twist.w};
    }
  }
  return std::nullopt;
}

}  // namespace patchgrip::friction
