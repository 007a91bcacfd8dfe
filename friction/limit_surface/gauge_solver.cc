#include <patchgrip/friction/limit_surface/gauge_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <patchgrip/contact/require.h>

namespace patchgrip::friction {

void GaugeSettings::check() const {
  contact::require_in("relative_gap", relative_gap, 1e-15, 1, contact::Ends::right_open);
  contact::require_in("max_evaluations", max_evaluations, 1, 1e6);
}

namespace {

constexpr double unit = 0x1p-53;

// Twists as (vx, vy, length w) and wrenches as (fx, fy, m / length), about the centroid.
using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) noexcept { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector moved(const Vector& a, double k, const Vector& b) noexcept {
  return {a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]};
}

double force_size(const Wrench& t) noexcept { return std::hypot(t.fx, t.fy); }

struct Bracket {
  double lower = 0;
  double upper = std::numeric_limits<double>::infinity();
  double gap = std::numeric_limits<double>::infinity();  // upper - lower but for rounding
  double rounding = 0;
};

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
        load_(load),
        arm_(std::fabs(frame.x) + std::fabs(frame.y)),
        t_(about_centroid(load)) {}

  Gauge run() noexcept {
    Iterate now = at({t_[0], t_[1], t_[2]});
    best_ = now;
    while (!narrow(best_.bracket) && evaluations_ < settings_.max_evaluations) {
      const std::optional<Vector> step = newton_step(now);
      if (!step) break;
      now = along(now, *step);
      if (better(now)) best_ = now;
    }
    return result();
  }

 private:
  Vector about_centroid(const Wrench& t) const noexcept {
    return {t.fx, t.fy, (t.m - (frame_.x * t.fy - frame_.y * t.fx)) / frame_.length};
  }

  Iterate at(const Vector& direction) noexcept {
    Iterate i;
    i.u = direction;
    const double w = direction[2] / frame_.length;
    i.v = {std::fma(w, frame_.y, direction[0]), std::fma(-w, frame_.x, direction[1]), w};
    i.g = patch_.gradient(patch_.patch, i.v);
    ++evaluations_;
    i.gradient = about_centroid(i.g.value);
    i.dissipation = power(i.g.value, i.v);
    i.value = power(load_, i.v) / i.dissipation;
    i.bracket = certify(i);
    return i;
  }

  Bracket certify(const Iterate& i) const noexcept {
    const Wrench& g = i.g.value;
    const Twist& v = i.v;
    const auto terms = [&](const Wrench& t) {
      return std::fabs(t.fx * v.vx) + std::fabs(t.fy * v.vy) + std::fabs(t.m * v.w);
    };
    const double speed = std::hypot(v.vx, v.vy);
    const double D_error = i.g.force_error * speed + i.g.moment_error * std::fabs(v.w) + 4 * unit * terms(g);
    const double tv_error = 4 * unit * terms(load_);
    Bracket b;
    const double tv = power(load_, v);
    b.lower = (1 - 4 * unit) * std::max(0.0, (tv - tv_error) / (i.dissipation + D_error));
    const double k = std::max(0.0, i.value);
    const Wrench r{load_.fx - k * g.fx, load_.fy - k * g.fy, load_.m - k * g.m};
    const double r_moment = r.m - (frame_.x * r.fy - frame_.y * r.fx);
    const double force_error = k * i.g.force_error + 2 * unit * (force_size(load_) + 2 * k * force_size(g));
    const double moment_error = k * i.g.moment_error + 2 * unit * (std::fabs(load_.m) + 2 * k * std::fabs(g.m)) +
                                arm_ * (force_error + 4 * unit * force_size(r));
    b.gap = force_size(r) + std::fabs(r_moment) / frame_.least_moment;
    b.rounding = force_error + moment_error / frame_.least_moment;
    b.upper = (1 + 8 * unit) * (k + b.gap + b.rounding);
    return b;
  }

  bool narrow(const Bracket& b) const noexcept {
    return b.gap <= std::max(settings_.relative_gap * b.lower, b.rounding);
  }

  bool better(const Iterate& i) const noexcept { return i.bracket.gap < best_.bracket.gap; }

  // Where the Hessian is infinite (the pole on a line load) it is taken with the pole a little aside.
  Twist beside(const Twist& v) const noexcept {
    const double shift = 1e-6 * frame_.length * v.w;
    return {v.vx + 0.8 * shift, v.vy - 0.6 * shift, v.w};
  }

  // Solves (D H + g g^T) s = t / k - g ... with v scaled so that D(v) = value.
  std::optional<Vector> newton_step(Iterate& i) const noexcept {
    const double k = i.value / i.dissipation;  // to the best length of the twist
    for (double& x : i.u) x *= k;
    Hessian h;
    if (!patch_.hessian(patch_.patch, i.v, h) && !patch_.hessian(patch_.patch, beside(i.v), h)) return std::nullopt;
    // About the centroid: v_origin = A v_c, A = [1 0 y; 0 1 -x; 0 0 1].
    const double x = frame_.x, y = frame_.y, L = frame_.length;
    const double xw = h.xw + y * h.xx - x * h.xy;
    const double yw = h.yw + y * h.xy - x * h.yy;
    const double ww = h.ww + y * (h.xw + xw) - x * (h.yw + yw);
    const Vector& g = i.gradient;
    const double D = i.dissipation;  // H is that of v: D(k v) H(k v) = D(v) H(v)
    const double m00 = D * h.xx + g[0] * g[0], m01 = D * h.xy + g[0] * g[1], m02 = D * xw / L + g[0] * g[2];
    const double m11 = D * h.yy + g[1] * g[1], m12 = D * yw / L + g[1] * g[2];
    const double m22 = D * ww / (L * L) + g[2] * g[2];
    const double floor = 1e-14 * (m00 + m11 + m22);
    const Vector r = moved(t_, -i.value, g);
    // Cholesky
    const double d0 = m00 + floor;
    const double l1 = m01 / d0, l2 = m02 / d0;
    const double d1 = std::max(m11 + floor - l1 * m01, floor);
    const double l3 = (m12 - l1 * m02) / d1;
    const double d2 = std::max(m22 + floor - l2 * m02 - l3 * l3 * d1, floor);
    const double z0 = r[0];
    const double z1 = r[1] - l1 * z0;
    const double z2 = r[2] - l2 * z0 - l3 * z1;
    const double s2 = z2 / d2;
    const double s1 = z1 / d1 - l3 * s2;
    const double s0 = z0 / d0 - l1 * s1 - l2 * s2;
    const Vector s{s0, s1, s2};
    if (!std::isfinite(s0) || !std::isfinite(s1) || !std::isfinite(s2)) return std::nullopt;
    return s;
  }

  // The full step, or less of it if the value falls at its end.
  Iterate along(const Iterate& from, const Vector& step) noexcept {
    const double slope = dot(t_, step) - from.value * dot(from.gradient, step);
    double a = 1;
    Iterate to = at(moved(from.u, a, step));
    for (int tries = 0; tries < 8 && evaluations_ < settings_.max_evaluations; ++tries) {
      if (narrow(to.bracket)) return to;
      // d/da of t . v - D^2 / 2
      const double D = to.dissipation;
      const double end = dot(t_, step) - D * dot(to.gradient, step);
      if (end >= -0.5 * slope || to.bracket.gap < from.bracket.gap) return to;
      a *= std::clamp(slope / (slope - end), 0.1, 0.8);
      to = at(moved(from.u, a, step));
    }
    return to;
  }

  Gauge result() const noexcept {
    Gauge g;
    const double k = 1 / best_.dissipation;
    g.value = std::clamp(best_.value, best_.bracket.lower, best_.bracket.upper);
    g.lower = best_.bracket.lower;
    g.upper = best_.bracket.upper;
    g.twist = {k * best_.v.vx, k * best_.v.vy, k * best_.v.w};
    g.evaluations = evaluations_;
    g.status = narrow(best_.bracket) ? GaugeStatus::converged : GaugeStatus::stalled;
    return g;
  }

  const PatchView& patch_;
  const PressureFrame& frame_;
  const GaugeSettings& settings_;
  Wrench load_;
  double arm_;
  Vector t_;
  Iterate best_;
  int evaluations_ = 0;
};

}  // namespace

PressureFrame::PressureFrame(const PatchView& patch, const PressureMoments& moments) noexcept
    : x(moments.x), y(moments.y), length(std::sqrt(moments.polar)) {
  const BoundedWrench g = patch.gradient(patch.patch, twist_about({x, y}, 1));
  const double S = (g.value.m - (x * g.value.fy - y * g.value.fx)) -
                   (g.moment_error + (std::fabs(x) + std::fabs(y)) * (g.force_error + 4 * unit));
  const double slope = force_size(g.value) + g.force_error;
  least_moment = (1 - 4 * unit) * S * std::max(0.5, 1 - slope);
}

Gauge maximise(const PatchView& patch, const PressureFrame& frame, const Wrench& load,
               const GaugeSettings& settings) noexcept {
  if (!std::isfinite(load.fx) || !std::isfinite(load.fy) || !std::isfinite(load.m)) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, {nan, nan, nan}, 0, GaugeStatus::not_finite};
  }
  const double arm = std::fabs(frame.x) + std::fabs(frame.y) + frame.length;
  const double size = std::max({std::fabs(load.fx), std::fabs(load.fy), std::fabs(load.m) / arm});
  if (size == 0) return {};
  const int e = std::ilogb(size);
  const Wrench scaled{std::scalbn(load.fx, -e), std::scalbn(load.fy, -e), std::scalbn(load.m, -e)};
  Gauge g = Maximiser(patch, frame, scaled, settings).run();
  g.value = std::scalbn(g.value, e);
  g.lower = std::scalbn(g.lower, e);
  g.upper = std::scalbn(g.upper, e);
  return g;
}

}  // namespace patchgrip::friction
