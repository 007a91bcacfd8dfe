// The gauge of a round patch in one variable, to rounding.
//
// About its centre a round limit surface is a surface of revolution: force and moment at the pole distance x = r_M / a
// are f(x) and m(x) per mu F_N (and a), the slip is along the force, and with the load's ratio q = a |F| / |M|
//
//     f(x) = q m(x),      g(t) = (|F| x + |M| / a) / S(x),      S = x f + m
//
// f - q m rises with x, as m' = -x f': one root, by Newton's method in x up to the rim and in u = 1/x beyond, from the
// start of gauge_solver.h. g is stationary in x there, so an error dx of the root costs g only dx^2.
//
// Domain   every load, also pure forces (x infinite) and pure moments (x = 0); any RoundPatch, also Placed.
// Units    load [N], [N], [N m] about the origin; g [N].
// Error    <= 8 units of 2^-53; of a Placed patch besides what rounding the moment about the centre costs. The bracket
//          is below 1e-14 of g. tests/friction/limit_surface/round_gauge_test.cc.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <patchgrip/friction/limit_surface/scaled_load.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::friction {

template <class P>
class RoundLimitSurface {
 public:
  explicit RoundLimitSurface(P patch) : patch_(std::move(patch)) {
    const CurvePoint rim = patch_.kernel().inside(1);
    rim_ratio_ = rim.f / rim.m;
    centre_moment_ = patch_.kernel().inside(0).m;
    spread_ = patch_.moments().polar / (2 * patch_.radius() * patch_.radius());
  }

  const P& patch() const noexcept { return patch_; }

  Gauge gauge(const Wrench& load) const noexcept {
    if (const auto known = trivial_gauge(load)) return *known;
    const double a = patch_.radius();
    const ScaledLoad scaled(load, a);
    const Wrench& t = scaled.load;
    const double F = std::hypot(t.fx, t.fy);
    const double M = std::fabs(t.m) / a;
    const bool inside = F <= rim_ratio_ * M;
    Gauge g;
    const double root = inside ? inside_root(F / M, g.evaluations) : outside_root(M / F, g.evaluations);
    const CurvePoint p = inside ? patch_.kernel().inside(root) : patch_.kernel().outside(root);
    ++g.evaluations;
    const double V = inside ? root : 1, W = inside ? 1 : root;
    const double D = V * p.f + W * p.m;
    const double k = (F * V + M * W) / D;
    const double shift = std::fabs(F - k * p.f) + std::fabs(M - k * p.m) / centre_moment_;
    const double terms = F + k * p.f + (M + k * p.m) / centre_moment_;
    g.value = k;
    g.lower = k * (1 - 20 * unit);
    g.upper = (1 + 4 * unit) * (k + shift + 12 * unit * terms);
    const double speed = F > 0 ? V / (D * F) : 0;
    g.twist = {speed * t.fx, speed * t.fy, std::copysign(W / (D * a), t.m)};
    g.status = shift <= GaugeSettings{}.relative_gap * k ? GaugeStatus::converged : GaugeStatus::stalled;
    return scaled.back(g);
  }

 private:
  static constexpr double unit = 0x1p-53;
  static constexpr int max_steps = 60;

  // f - q m = 0: d/dx of it is f' (1 + q x).
  double inside_root(double q, int& evaluations) const noexcept {
    const double z = 3 * spread_ * q * q;
    return root(q * spread_ * (1 + 3 / (1 + std::sqrt(1 + z))), evaluations, [&](double x) {
      const CurvePoint p = patch_.kernel().inside(x);
      return std::pair{p.f - q * p.m, p.slope * (1 + q * x)};
    });
  }

  // m - f / q = 0: d/du of it is f' / u^3 (1 + u / q), and `slope` is f' / u^3 there.
  double outside_root(double inverse_q, int& evaluations) const noexcept {
    const double r = inverse_q;
    const double start = r > 0 ? r / (spread_ * (1 + 3 * r / (r + std::sqrt(r * r + 3 * spread_)))) : 0;
    return root(start, evaluations, [&](double u) {
      const CurvePoint p = patch_.kernel().outside(u);
      return std::pair{p.m - r * p.f, p.slope * (1 + r * u)};
    });
  }

  // In [0, 1], of a function that rises.
  template <class Function>
  static double root(double x, int& evaluations, const Function& function) noexcept {
    double lower = 0, upper = 1;
    x = std::min(x, 1.0);
    for (int step = 0; step < max_steps; ++step) {
      const auto [y, slope] = function(x);
      ++evaluations;
      (y < 0 ? lower : upper) = x;
      double next = x - y / slope;
      // The slope of a line load is infinite on it: then halve.
      if (!(next >= lower && next <= upper) || (std::isinf(slope) && y != 0)) next = lower + (upper - lower) / 2;
      const double change = std::fabs(next - x);
      x = next;
      if (change <= 0x1p-40 * x) break;
    }
    return x;
  }

  P patch_;
  double rim_ratio_;      // f / m with the pole on the rim
  double centre_moment_;  // m with the pole at the centre
  double spread_;         // second moment in one direction, per a^2
};

// The load is moved to the centre, the slip back from there.
template <class P>
class RoundLimitSurface<Placed<P>> {
 public:
  explicit RoundLimitSurface(Placed<P> patch)
      : patch_(std::move(patch)), centred_(patch_.patch()), least_moment_(1 / centred_.gauge({0, 0, 1}).upper) {}

  const Placed<P>& patch() const noexcept { return patch_; }

  Gauge gauge(const Wrench& load) const noexcept {
    if (const auto known = trivial_gauge(load)) return *known;
    const double x = patch_.x(), y = patch_.y();
    const ScaledLoad scaled(load, patch_.area_radius());
    const Wrench& t = scaled.load;
    Gauge g = centred_.gauge({t.fx, t.fy, t.m - (x * t.fy - y * t.fx)});
    // A moment that is wrong by d asks for d / m_0 at most.
    const double error = 0x1p-53 * (std::fabs(t.m) + 3 * (std::fabs(x * t.fy) + std::fabs(y * t.fx))) / least_moment_;
    g.lower = std::max(0.0, g.lower - error);
    g.upper += error;
    g.twist.vx += g.twist.w * y;
    g.twist.vy -= g.twist.w * x;
    return scaled.back(g);
  }

 private:
  Placed<P> patch_;
  RoundLimitSurface<P> centred_;
  double least_moment_;  // m_0 [m], the moment at the centre
};

}  // namespace patchgrip::friction
