// Return mapping of a round patch about its own centre, K = diag(k, k, k_r): one equation in one variable.
//
// Force and moment per L (and a) at the pole distance x = r_M / a are f(x) and m(x), m' = -x f'. With F and M those of
// the trial and rho = k a^2 / k_r the closest point (returned.h) is where the normal (x, 1) of the limit curve points
// at the trial,
//
//     r(x) = F - f(x) - rho x [M - m(x)] = 0,        u = 1/x beyond the rim:  u (F - f) - rho (M - m) = 0
//
//     lambda = [(F - f) x + M - m] / (1 + rho x^2),      w = L a lambda / k_r,   V = a x w
//
// lambda is the distance along the normal: negative for every x if the trial is inside, so that its sign decides
// between stick and slip, and never the difference s* - s, which has no digits left for small overshoot.
//
// Newton's method from the closest point of the ellipsoid with the same axes. r falls with x where F >= f and M >= m;
// on the other side of either the sign of the missing part says where the root is.
//
// Domain   every trial, every limit L >= 0 (with L = 0 all of it slips); k, k_r > 0. Any RoundPatch.
// Units    k [N/m], k_r [N m].
// Error    carried: rounding of f and m, and what rounding of r leaves of x, doubled. Some 1e-15 L, of the force times
//          sqrt(rho) and of the moment times a / sqrt(rho) where those are more: the closest point is known as well as
//          that in the norm of K^-1. tests/dynamics/round_return_mapping_test.cc, also for overshoot from 1e-12 to 1e9
//          and rho from 1e-6 to 1e6.
// Cost     2.7 evaluations of f, m and f' in the mean, 12 at most (bench/return_mapping.cc).
// Throws   nothing. A trial or a limit that is not finite, or a negative limit, gives not-a-number and an infinite
//          error.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <patchgrip/dynamics/returned.h>
#include <patchgrip/friction/round_patch.h>

namespace patchgrip::dynamics {

struct RoundStiffness {
  double k;    // [N/m]
  double k_r;  // [N m]
};

template <class P>
class RoundReturnMapping {
 public:
  explicit RoundReturnMapping(P patch) : patch_(std::move(patch)) {
    const Point rim = at_inside(1);
    rim_force_ = rim.f;
    rim_moment_ = rim.m;
    centre_moment_ = at_inside(0).m;
    inner_ = inner_ellipsoid();
  }

  const P& patch() const noexcept { return patch_; }

  // The closest point of L B to `trial`; `limit` L = mu F_N [N].
  Returned operator()(const friction::Wrench& trial, double limit, const RoundStiffness& K) const noexcept {
    if (limit == 0) return {{}, {trial.fx / K.k, trial.fy / K.k, trial.m / K.k_r}, true, 0};
    const double a = patch_.radius();
    const double size = length_of(trial);
    const double F = size / limit, M = std::fabs(trial.m) / (a * limit), n = M / centre_moment_;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(limit > 0 && limit < infinity && F + M < infinity)) return not_finite();
    if (F * F + n * n <= inner_) return {{trial, 0, 0}, {}, false, 0};

    Search s{F, M, K.k * a * a / K.k_r};
    if (F <= rim_force_ || (M > rim_moment_ && F - rim_force_ <= s.rho * (M - rim_moment_))) {
      search_inside(s);
    } else {
      search_outside(s);
    }
    const double force = s.f * limit, moment = s.m * a * limit;
    if (!(s.lambda > 0 || s.lambda_x > 0))
      return {{trial, 8 * unit * force, 8 * unit * moment}, {}, false, s.evaluations};
    const double ex = size > 0 ? trial.fx / size : 0, ey = size > 0 ? trial.fy / size : 0;
    const double w = limit * a / K.k_r * s.lambda, V = a * limit * a / K.k_r * s.lambda_x;
    return {{{force * ex, force * ey, std::copysign(moment, trial.m)},
             12 * unit * force + 2 * limit * s.df,
             12 * unit * moment + 2 * limit * a * s.dm},
            {V * ex, V * ey, std::copysign(w, trial.m)},
            true,
            s.evaluations};
  }

 private:
  static constexpr double unit = 0x1p-53;
  static constexpr int max_steps = 80;
  static constexpr double last_step = 1e-8;  // relative: after it what Newton's method leaves is rounding

  struct Point {
    double f, m;
  };

  struct Search {
    double F, M, rho;
    double f = 0, m = 0;
    double lambda = 0, lambda_x = 0;  // lambda x
    double df = 0, dm = 0;            // errors of f and m
    int evaluations = 0;

    void set(const Point& p, double l, double l_x, double error_f, double error_m) noexcept {
      f = p.f, m = p.m, lambda = l, lambda_x = l_x, df = error_f, dm = error_m;
    }
  };

  static Returned not_finite() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), none = std::numeric_limits<double>::infinity();
    return {{{nan, nan, nan}, none, none}, {nan, nan, nan}, true, 0};
  }

  // |(fx, fy)| without hypot where squares stay finite and normal.
  static double length_of(const friction::Wrench& t) noexcept {
    const double square = t.fx * t.fx + t.fy * t.fy;
    return square > 0x1p-900 && square < 0x1p900 ? std::sqrt(square) : std::hypot(t.fx, t.fy);
  }

  Point at(double V, double W) const noexcept {
    const friction::RoundTwist t({V, 0, W}, 1);
    const friction::RoundGradient g = patch_.kernel().gradient(t);
    return {g.force_per_speed * V, g.moment_per_radius};
  }
  Point at_inside(double x) const noexcept { return at(x, 1); }
  Point at_outside(double u) const noexcept { return at(1, u); }
  // f' inside, f' / u^3 outside; infinite with the pole on a line load.
  double slope(double V, double W) const noexcept { return patch_.kernel().slope(friction::RoundTwist({V, 0, W}, 1)); }

  // Least of f^2 + (m / m_0)^2 over the limit curve, a little less: what is inside of it sticks.
  double inner_ellipsoid() const noexcept {
    constexpr int samples = 512;
    double least = 1;
    for (int i = 1; i < samples; ++i) {
      const double share = static_cast<double>(i) / samples;
      for (const Point& p : {at_inside(share), at_outside(share)}) {
        const double n = p.m / centre_moment_;
        least = std::min(least, p.f * p.f + n * n);
      }
    }
    return least * (1 - 1e-3);
  }

  // V and W of the closest point of the ellipsoid f^2 + (m / m_0)^2 = 1: f = F / (1 + t), m = M / (1 + q t), one step
  // of Newton's method from t = 0 for 1 / sqrt(f^2 + (m / m_0)^2), which is almost straight.
  std::pair<double, double> start(const Search& s) const noexcept {
    const double n2 = s.M * s.M / (centre_moment_ * centre_moment_), F2 = s.F * s.F, N = F2 + n2;
    const double e2rho = centre_moment_ * centre_moment_ * s.rho;
    const double t = std::max(0., (std::sqrt(N) - 1) * N * e2rho / (F2 * e2rho + n2));
    return {s.F * (e2rho + t), s.rho * s.M * (1 + t)};
  }

  void search_inside(Search& s) const noexcept {
    const auto [V, W] = start(s);
    Root root{V < W ? V / W : 1};
    for (;;) {
      const double x = root.place;
      const Point p = at_inside(x);
      ++s.evaluations;
      const double F = s.F - p.f, M = s.M - p.m, terms = 1 + s.rho * x * x, swing = s.rho * std::max(M, 0.);
      if (F <= 0 && M <= 0) return s.set(p, 0, 0, 0, 0);  // it sticks
      const double r = F - s.rho * x * M, rounding = 4 * unit * (s.F + p.f + s.rho * x * (s.M + p.m));
      const double curvature = slope(x, 1);
      if (root.step(r, rounding, M < 0 || (r > 0 && F >= 0), r / (curvature * terms + swing), curvature)) continue;
      const double df = (std::fabs(r) + rounding) * share(curvature, terms, swing), lambda = (F * x + M) / terms;
      s.set(p, lambda, lambda * x, df, x * df);
      return;
    }
  }

  void search_outside(Search& s) const noexcept {
    const auto [V, W] = start(s);
    Root root{W < V ? W / V : 1};
    for (;;) {
      const double u = root.place;
      const Point p = at_outside(u);
      ++s.evaluations;
      const double F = s.F - p.f, M = s.M - p.m, terms = u * u + s.rho, swing = std::max(F, 0.);
      if (F <= 0 && M <= 0) return s.set(p, 0, 0, 0, 0);
      const double r = s.rho * M - u * F, rounding = 4 * unit * (u * (s.F + p.f) + s.rho * (s.M + p.m));
      const double curvature = slope(1, u);
      if (root.step(r, rounding, M >= 0 && (r > 0 || F < 0), r / (curvature * terms + swing), curvature)) continue;
      const double dm = (std::fabs(r) + rounding) * share(curvature, terms, swing), lambda_x = (F + u * M) / terms;
      s.set(p, lambda_x * u, lambda_x, u * dm, dm);
      return;
    }
  }

  // In [0, 1], of a function that is positive below it and negative beyond.
  struct Root {
    double place;
    double lo = 0, hi = 1;
    double last = std::numeric_limits<double>::infinity();
    bool settled = false;
    int steps = 0;

    // False where the function is down to its rounding, or does not fall any more. `below`: the root is farther up.
    bool step(double value, double rounding, bool below, double newton, double curvature) noexcept {
      const double size = std::fabs(value);
      if (size <= rounding || (settled && !(size < last / 2)) || ++steps > max_steps) return false;
      last = size;
      (below ? lo : hi) = place;
      const double next = place + newton;
      settled = next >= lo && next <= hi && !std::isinf(curvature);
      const double to = settled ? next : lo + (hi - lo) / 2;
      if (to == place) return false;
      settled = settled && std::fabs(to - place) <= last_step * to;
      place = to;
      return true;
    }
  };

  // c / (c a + b), also where c is infinite.
  static double share(double c, double a, double b) noexcept { return std::isinf(c) ? 1 / a : c / (c * a + b); }

  P patch_;
  double rim_force_;  // f and m with the pole on the rim
  double rim_moment_;
  double centre_moment_;  // m_0
  double inner_;          // squared radius of the inner ellipsoid with the axes 1 and m_0
};

}  // namespace patchgrip::dynamics
