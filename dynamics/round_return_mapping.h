// Return mapping of a round patch about its own centre, K = diag(k, k, k_r): one equation in one variable.
//
// Force and moment per L (and a) at the pole distance x = r_M / a are f(x) and m(x), m' = -x f'; beyond the rim they
// are taken over u = 1/x, where f' = -u m'. F and M are those of the trial, rho = k a^2 / k_r. With
//
//     (G, g), (H, h), y, kappa  =  (F, f), (M, m), x, rho  inside,     (M, m), (F, f), u, 1 / rho  beyond
//
// the closest point (returned.h) is where the normal of the limit curve points at the trial,
//
//     r(y) = G - g - kappa y (H - h) = 0,      lambda = [(G - g) y + H - h] / (1 + kappa y^2)
//
// and slips by w = L a lambda / k_r, V = a x w inside and by V = L lambda / k, a w = u V beyond. lambda is the distance
// along the normal: negative everywhere if the trial is inside of L B, so that its sign decides between stick and slip,
// and never the difference s* - s, which has no digits left for small overshoot.
//
// From the root of a polynomial model (limit_curve_model.h) Halley's method: where g'' is known one evaluation and a
// Taylor polynomial are mostly all. r falls with y where G >= g and H >= h; on the other side of either the sign of the
// missing part says where the root is.
//
// Domain   every trial, every limit L >= 0 (with L = 0 all of it slips); k, k_r > 0. Any RoundPatch.
// Units    k [N/m], k_r [N m].
// Error    carried: rounding of f and m, and what rounding of r leaves of y, doubled. Some 1e-15 L, of the force times
//          sqrt(rho) and of the moment times a / sqrt(rho) where those are more: the closest point is known as well as
//          that in the norm of K^-1. tests/dynamics/round_return_mapping_test.cc, also for overshoot from 1e-12 to 1e9
//          and rho from 1e-6 to 1e6.
// Cost     of a Hertz disc mostly one or two evaluations of f, m, f' and f'', 20 at most; where f'' is not known 2.3 in
//          the mean (bench/return_mapping.cc).
// Throws   nothing. A trial or a limit that is not finite, or a negative limit, gives not-a-number and an infinite
//          error.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <patchgrip/dynamics/limit_curve_model.h>
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
  explicit RoundReturnMapping(P patch)
      : patch_(std::move(patch)),
        inside_([&](double x) { return inside(x); }),
        outside_([&](double u) { return outside(u); }),
        rim_(inside(1)),
        inverse_radius_(1 / patch_.radius()),
        inverse_centre_(1 / inside(0).h),
        inner_(inner_ellipsoid()) {}

  const P& patch() const noexcept { return patch_; }

  // The closest point of L B to `trial`; `limit` L = mu F_N [N].
  Returned operator()(const friction::Wrench& trial, double limit, const RoundStiffness& K) const noexcept {
    if (!(limit > smallest && limit < largest)) [[unlikely]]
      return out_of_range(trial, limit, K);
    const double a = patch_.radius(), inverse = 1 / limit, size = length_of(trial);
    const double F = size * inverse, M = std::fabs(trial.m) * (inverse_radius_ * inverse), n = M * inverse_centre_;
    if (!(F + M < std::numeric_limits<double>::infinity())) return not_finite();
    if (F * F + n * n <= inner_) return {{trial, 0, 0}, {}, false, 0};

    const double k = K.k * a * a, inverse_k_r = 1 / K.k_r;
    // Both conditions, as the second is likely only where the first is not.
    if ((F <= rim_.g) | ((M > rim_.h) & ((F - rim_.g) * K.k_r <= k * (M - rim_.h)))) {
      const Closest c = search(F, M, k * inverse_k_r, inside_, [&](double x) { return inside(x); });
      const double w = c.lambda * (limit * a * inverse_k_r);
      return returned(trial, size, limit, {c.g, c.h, a * c.y * w, w, c.error, c.y * c.error}, c);
    }
    const Closest c = search(M, F, K.k_r / k, outside_, [&](double u) { return outside(u); });
    const double V = c.lambda * (limit / K.k);
    return returned(trial, size, limit, {c.h, c.g, V, inverse_radius_ * c.y * V, c.y * c.error, c.error}, c);
  }

 private:
  static constexpr double unit = 0x1p-53;
  static constexpr int max_steps = 80;
  static constexpr double last_step = 1e-8;  // relative: after it what Newton's method leaves is rounding
  // Relative to y and to the distance from the rim, where g''' is infinite: what Halley's method and the Taylor
  // polynomial leave out is less than rounding.
  static constexpr double small_step = 0x1p-18;
  // Of what limit and force may be without being scaled.
  static constexpr double smallest = 0x1p-900, largest = 0x1p900;

  // g, h and g' on one side of the rim; h' = -y g'.
  struct Place {
    double g, h, slope;
    double bend;  // g'', not a number where it is not known
  };

  struct Closest {
    double g, h;
    double y;
    double lambda;
    double error;  // of g; that of h is y times as much
    int evaluations;
  };

  // Sizes per L (and a).
  struct Sizes {
    double f, m;
    double V, w;
    double df, dm;
  };

  Place inside(double x) const noexcept {
    const friction::CurvePoint p = patch_.kernel().inside(x);
    return {p.f, p.m, p.slope, p.bend};
  }
  Place outside(double u) const noexcept {
    const friction::CurvePoint p = patch_.kernel().outside(u);
    return {p.m, p.f, p.slope, p.bend};
  }

  // |(fx, fy)| without hypot where squares stay finite and normal.
  static double length_of(const friction::Wrench& t) noexcept {
    const double square = t.fx * t.fx + t.fy * t.fy;
    return square > smallest && square < largest ? std::sqrt(square) : std::hypot(t.fx, t.fy);
  }

  static Returned not_finite() noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), none = std::numeric_limits<double>::infinity();
    return {{{nan, nan, nan}, none, none}, {nan, nan, nan}, true, 0};
  }

  [[gnu::noinline]] Returned out_of_range(const friction::Wrench& t, double limit,
                                          const RoundStiffness& K) const noexcept {
    if (limit == 0) return {{}, {t.fx / K.k, t.fy / K.k, t.m / K.k_r}, true, 0};
    if (!(limit > 0 && limit < std::numeric_limits<double>::infinity())) return not_finite();
    const double up = limit < 1 ? 0x1p600 : 0x1p-600, down = 1 / up;
    const Returned r = (*this)({up * t.fx, up * t.fy, up * t.m}, up * limit, K);
    const auto& [s, force_error, moment_error] = r.wrench;
    const friction::Twist& u = r.slip;
    return {{{down * s.fx, down * s.fy, down * s.m}, down * force_error, down * moment_error},
            {down * u.vx, down * u.vy, down * u.w},
            r.slips,
            r.evaluations};
  }

  Returned returned(const friction::Wrench& trial, double size, double limit, const Sizes& s,
                    const Closest& c) const noexcept {
    const double moment_limit = limit * patch_.radius(), force = limit * s.f, moment = moment_limit * s.m;
    if (!(c.lambda > 0)) return {{trial, 8 * unit * force, 8 * unit * moment}, {}, false, c.evaluations};
    const double inverse = size > smallest ? 1 / size : 0, ex = trial.fx * inverse, ey = trial.fy * inverse;
    const double sign = std::copysign(1, trial.m);
    return {{{force * ex, force * ey, sign * moment},
             12 * unit * force + 2 * limit * s.df,
             12 * unit * moment + 2 * moment_limit * s.dm},
            {s.V * ex, s.V * ey, sign * s.w},
            true,
            c.evaluations};
  }

  // Least of f^2 + (m / m_0)^2 over the limit curve, a little less: what is inside of it sticks.
  double inner_ellipsoid() const noexcept {
    constexpr int samples = 512;
    double least = 1;
    for (int i = 1; i < samples; ++i) {
      const double y = static_cast<double>(i) / samples;
      const Place p = inside(y), q = outside(y);
      const double n = p.h * inverse_centre_, l = q.g * inverse_centre_;
      least = std::min({least, p.g * p.g + n * n, q.h * q.h + l * l});
    }
    return least * (1 - 1e-3);
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

  template <class Model, class Curve>
  static Closest search(double G, double H, double kappa, const Model& model, const Curve& curve) noexcept {
    Root root{model.root(G, H, kappa)};
    Closest c;
    c.evaluations = 0;
    if (settles(G, H, kappa, curve, root, c)) [[likely]]
      return c;
    return searched_on(G, H, kappa, curve, root, c);
  }

  // Apart, so that nothing of it is made ready for those who do not need it.
  template <class Curve>
  [[gnu::noinline]] static Closest searched_on(double G, double H, double kappa, const Curve& curve, Root root,
                                               Closest c) noexcept {
    while (!settles(G, H, kappa, curve, root, c)) continue;
    return c;
  }

  // One evaluation: true if `c` is the closest point.
  template <class Curve>
  [[gnu::always_inline]] static bool settles(double G, double H, double kappa, const Curve& curve, Root& root,
                                             Closest& c) noexcept {
    double y = root.place;
    Place p = curve(y);
    ++c.evaluations;
    const double g = G - p.g, h = H - p.h, terms = 1 + kappa * y * y;
    if (g <= 0 && h <= 0) {  // it sticks
      c = {p.g, p.h, y, 0, 0, c.evaluations};
      return true;
    }
    const double r = g - kappa * y * h, rounding = 4 * unit * (G + p.g + kappa * y * (H + p.h));
    // -r', never below half of what g >= 0 and h >= 0 leave of it.
    const double curvature = p.slope * terms, fall = curvature + std::max(kappa * h, -curvature / 2);
    double inverse = 1 / fall, step = r * inverse, left = std::fabs(r);
    if (!std::isnan(p.bend)) {
      inverse = fall / (fall * fall + r / 2 * (p.bend * terms + 3 * kappa * y * p.slope));
      step = r * inverse;
      if (std::fabs(step) < small_step * (y * (1 - y))) {
        const double rise = step * (p.slope + step / 2 * p.bend);
        p.g += rise;
        p.h -= y * rise + step * step / 2 * p.slope;
        y += step;
        left = 0;
      }
    }
    if (left > 0 && root.step(r, rounding, g >= 0 && (r > 0 || h < 0), step, p.slope)) return false;
    const double share = std::isinf(p.slope) ? 1 / terms : p.slope * inverse;
    const double lambda = ((G - p.g) * y + (H - p.h)) / (1 + kappa * y * y);
    c = {p.g, p.h, y, lambda, (left + rounding) * share, c.evaluations};
    return true;
  }

  using Kernel = std::remove_cvref_t<decltype(std::declval<P>().kernel())>;
  static constexpr std::size_t model_terms = 8;
  static constexpr std::size_t inner_terms = [] {
    if constexpr (requires { Kernel::inside_terms; }) return Kernel::inside_terms;
    return model_terms;
  }();

  P patch_;
  LimitCurveModel<inner_terms> inside_;
  LimitCurveModel<model_terms> outside_;
  Place rim_;  // from inside
  double inverse_radius_;
  double inverse_centre_;  // 1 / m_0
  double inner_;           // squared radius of the inner ellipsoid with the axes 1 and m_0
};

}  // namespace patchgrip::dynamics
