#include <patchgrip/friction/limit_surface/gauge_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <patchgrip/friction/limit_surface/certificate.h>
#include <patchgrip/friction/limit_surface/cutting_planes.h>
#include <patchgrip/friction/limit_surface/newton_step.h>
#include <patchgrip/friction/limit_surface/point_slip.h>
#include <patchgrip/friction/limit_surface/scaled_load.h>

namespace patchgrip::friction {
namespace {

constexpr double unit = 0x1p-53;

// Newton's method needs up to 15, with the pole on a line load; more, and D has a kink.
constexpr int smooth_evaluations = 25;

// The same where kinks are known, and away from them D is smooth.
constexpr int kinked_evaluations = 12;

// Of all evaluations, what kinks may take; cutting planes have the rest. Of kinks close together none has the slip.
constexpr double kinks_share = 0.4;

// Of the pressure along a force across a line load, in squared radii of gyration: a start with the pole off the line,
// as a zone of that width has it.
constexpr double least_spread = beside * beside;

// At a kink rounding turns the gradient however it likes. This far aside, of |v|, about the root of 2^-53, it is turned
// by no more than the gauge is less there.
constexpr double aside = 1e-8;

double force_size(const Wrench& t) noexcept { return std::hypot(t.fx, t.fy); }

// A twist, the gradient there and what they say of the load.
struct Iterate {
  Vector u;            // the twist
  Twist v;             // the same about the origin: exactly what the patch was asked
  BoundedWrench g;     // about the origin
  Vector gradient;     // the same, scaled, about the centroid
  double dissipation;  // D(v)
  double value;        // t . v / D(v)
  Bracket bracket;
};

class Maximiser {
 public:
  Maximiser(const PatchView& patch, const PressureFrame& frame, const Wrench& load,
            const GaugeSettings& settings) noexcept
      : patch_(patch),
        frame_(frame),
        settings_(settings),
        kinks_settings_(settings),
        load_(load),
        arm_(std::fabs(frame.x) + std::fabs(frame.y)),
        t_(frame.about_centroid(load)) {
    kinks_settings_.max_evaluations = static_cast<int>(kinks_share * settings.max_evaluations);
  }

  Gauge run() noexcept {
    if (const Kink* kink = likely_kink(frame_, load_)) {
      if (const auto gauge = gauge_at(*kink, patch_, frame_, load_, settings_, evaluations_)) return *gauge;
    }
    climb(start());
    const int last = kinks_settings_.max_evaluations;
    for (std::size_t i = 0; i < frame_.kinks.size() && !narrow(best_.bracket) && evaluations_ < last; ++i) {
      // It got stuck at a kink, to stay there or not.
      const Kink& kink = *nearest_kink(frame_, best_.v);
      if (const auto gauge = gauge_at(kink, patch_, frame_, load_, kinks_settings_, evaluations_)) return *gauge;
      const auto away = away_from(kink, patch_, frame_, load_, evaluations_);
      if (!away || evaluations_ >= last) break;
      climb(frame_.about_centroid(*away));
    }
    if (narrow(best_.bracket)) {
      polish();
      if (frame_.is_line()) step_from(best_);
      return result(ridge_ ? GaugeStatus::ridge : GaugeStatus::converged);
    }
    return result(cut() ? GaugeStatus::converged : GaugeStatus::stalled);
  }

 private:
  // Newton's method from u.
  void climb(const Vector& u) noexcept {
    Iterate now = best_ = at(u);
    const int most = frame_.kinks.empty() ? smooth_evaluations : kinked_evaluations;
    const int last = std::min(settings_.max_evaluations, evaluations_ + most);
    while (!narrow(best_.bracket) && evaluations_ < last) {
      const std::optional<Vector> step = step_from(now);
      if (!step) break;
      now = along(now, *step);
      if (now.bracket.gap < best_.bracket.gap) best_ = now;
    }
  }

  // The pole's distance times |M|, in the direction of the force: finite for pure forces and pure moments.
  Vector start() const noexcept {
    const double F2 = t_[0] * t_[0] + t_[1] * t_[1];
    if (F2 == 0) return {0, 0, t_[2]};
    const double xx = frame_.xx, xy = frame_.xy, yy = frame_.yy;
    const double along = (t_[0] * t_[0] * xx + 2 * t_[0] * t_[1] * xy + t_[1] * t_[1] * yy) / F2;
    const double across = std::max(3 * (xx + yy - along), 0.);
    const double M = std::fabs(t_[2]);
    const double root = M + std::sqrt(M * M + across * F2);
    // Both are 0 on a line load: the first for a force across it, the second along it.
    const double k = std::max(along, least_spread) + (root > 0 ? across * M / root : 0);
    return {k * t_[0], k * t_[1], t_[2]};
  }

  Iterate at(const Vector& direction) noexcept {
    Iterate i;
    i.u = direction;
    i.v = frame_.about_origin(direction);
    i.g = patch_.gradient(patch_.patch, i.v);
    ++evaluations_;
    i.gradient = frame_.about_centroid(i.g.value);
    i.dissipation = power(i.g.value, i.v);
    i.value = power(load_, i.v) / i.dissipation;
    i.bracket = certify(frame_, load_, i.v, i.g);
    lower_ = std::max(lower_, i.bracket.lower);
    upper_ = std::min(upper_, i.bracket.upper);
    return i;
  }

  bool narrow(const Bracket& b) const noexcept { return b.narrow(settings_.relative_gap); }

  // One step more leaves of the bracket what the patch's own bounds are wide.
  void polish() noexcept {
    const auto width = [](const Bracket& b) { return b.upper - b.lower; };
    if (width(best_.bracket) <= settings_.relative_gap * best_.bracket.lower) return;
    if (evaluations_ >= settings_.max_evaluations) return;
    const std::optional<Vector> step = step_from(best_);
    if (!step) return;
    const Iterate next = along(best_, *step);
    if (width(next.bracket) < width(best_.bracket)) best_ = next;
  }

  // Scales the twist of `i` to its best length and steps from there.
  std::optional<Vector> step_from(Iterate& i) noexcept {
    i.u = scaled(i.u, i.value / i.dissipation);
    const auto next = newton_step(patch_, frame_, t_, i.v, i.gradient, i.dissipation, i.value);
    if (!next) return std::nullopt;
    ridge_ = frame_.is_line() && next->flat;
    return next->step;
  }

  // The full step; where D has passed its least along it, less: to where the tangents of both ends meet, which finds
  // kinks, then to the least of the cubic through both. On the plane of all twists with the same t . v.
  Iterate along(const Iterate& from, Vector step) noexcept {
    const double gain = dot(t_, step) / dot(t_, from.u);
    const double share = gain < -0.9 ? -0.9 / gain : 1;
    for (std::size_t i = 0; i < 3; ++i) step[i] = share / (1 + share * gain) * (step[i] - gain * from.u[i]);
    const double slope = dot(from.gradient, step);
    double a = 1;
    Iterate to = at(moved(from.u, a, step));
    for (int tries = 0; tries < 8 && evaluations_ < settings_.max_evaluations; ++tries) {
      const double end = dot(to.gradient, step);
      if (narrow(to.bracket) || end <= -0.5 * slope || to.bracket.gap < 0.1 * from.bracket.gap) return to;
      const double rise = (to.dissipation - from.value) / a;
      const double c = slope + end - 3 * rise;
      const double root = std::sqrt(c * c - slope * end);
      const double least = tries == 0 ? (rise - end) / (slope - end) : 1 - (end + root - c) / (end - slope + 2 * root);
      a *= least > 0 && least < 0.9 ? least : 0.5;
      to = at(moved(from.u, a, step));
    }
    return to;
  }

  CuttingPlanes::Plane plane(const Iterate& i) const noexcept {
    const double rounding = 2 * unit * force_size(i.g.value);
    return {i.gradient, i.g.force_error + rounding,
            i.g.moment_error + arm_ * (i.g.force_error + 2 * rounding) + 2 * unit * std::fabs(i.g.value.m)};
  }

  // True if three planes agree on the gauge as closely as asked for.
  bool cut() noexcept {
    CuttingPlanes planes(t_, plane(at({0, 0, 1})));
    // Where Newton's method got to, if that is beyond them.
    if (dot(best_.gradient, planes.twist()) > 1) planes.add(plane(best_));
    do {
      best_ = at(planes.twist());
      upper_ = std::min(upper_, upper_bound(planes));
      // Close to the kink rounding turns the gradient by more than it lies beyond the planes.
    } while (dot(best_.gradient, best_.u) - 1 > best_.g.force_error && evaluations_ < settings_.max_evaluations &&
             planes.add(plane(best_)));
    // There D is bounded worse than a little aside of it.
    at(moved(best_.u, aside * std::sqrt(dot(best_.u, best_.u)), {1, 0, 0}));
    best_.bracket.lower = lower_;
    best_.bracket.upper = upper_;
    return upper_ - lower_ <= settings_.relative_gap * lower_;
  }

  double upper_bound(const CuttingPlanes& planes) const noexcept {
    double sum = 0, force_error = 0, moment_error = 0;
    Vector r = t_;
    for (std::size_t i = 0; i < 3; ++i) {
      const double k = planes.weights()[i];
      const CuttingPlanes::Plane& p = planes.planes()[i];
      sum += k;
      r = moved(r, -k, p.g);
      force_error += k * (p.force_error + 2 * unit);
      moment_error += k * (p.moment_error + 4 * unit * std::fabs(p.g[2]) * frame_.length);
    }
    force_error += std::hypot(r[0], r[1]) + unit * force_size(load_);
    moment_error += std::fabs(r[2]) * frame_.length + 2 * unit * (std::fabs(load_.m) + arm_ * force_size(load_));
    return (1 + 8 * unit) * (sum + force_error + moment_error / frame_.least_moment);
  }

  Gauge result(GaugeStatus status) const noexcept {
    const Bracket& b = best_.bracket;
    const double k = 1 / best_.dissipation;
    return {std::clamp(best_.value, b.lower, b.upper),       b.lower,      b.upper,
            {k * best_.v.vx, k * best_.v.vy, k * best_.v.w}, evaluations_, status};
  }

  const PatchView& patch_;
  const PressureFrame& frame_;
  const GaugeSettings& settings_;
  GaugeSettings kinks_settings_;
  Wrench load_;
  double arm_;
  Vector t_;
  Iterate best_;
  double lower_ = 0, upper_ = std::numeric_limits<double>::infinity();  // of all that was asked
  int evaluations_ = 0;
  bool ridge_ = false;
};

}  // namespace

Gauge maximise(const PatchView& patch, const PressureFrame& frame, const Wrench& load,
               const GaugeSettings& settings) noexcept {
  if (const auto known = trivial_gauge(load)) return *known;
  const ScaledLoad scaled(load, std::fabs(frame.x) + std::fabs(frame.y) + frame.length);
  return scaled.back(Maximiser(patch, frame, scaled.load, settings).run());
}

}  // namespace patchgrip::friction
