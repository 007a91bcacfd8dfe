// Gauge and slip of a load in 50 digits, of any pressure whose gradient is known in 50 digits and of point loads.
//
// What is found is proven: t / g is a gradient of D at the slip to 1e-35, or with the pole on a point load it differs from
// that of the rest by a force through the point that the point bears. By convexity g is the gauge then, however it was
// found.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <patchgrip/friction/patch.h>
#include <patchgrip/tests/friction/round_reference.h>

namespace patchgrip::friction {

struct PointShare50 {
  Real50 x, y, share;
};

class GaugeReference {
 public:
  using Gradient = std::function<Wrench50(const Real50& vx, const Real50& vy, const Real50& w)>;

  struct Slip {
    Real50 gauge;
    std::array<Real50, 3> twist;  // D = 1
    Real50 x, y;                  // pole
  };

  // `smooth` is the gradient of all but the points, weighted by its share; empty if there is nothing else. The moments need
  // not be exact.
  GaugeReference(Gradient smooth, std::vector<PointShare50> points, const PressureMoments& s)
      : smooth_(std::move(smooth)), points_(std::move(points)), centre_{s.x, s.y, 0}, length_(std::sqrt(s.polar)) {}

  Wrench50 gradient(const Real50& vx, const Real50& vy, const Real50& w) const { return without(nullptr, vx, vy, w); }

  // t . v / D(v): at most the gauge, and less by the second order of what the slip is wrong by.
  Real50 lower(const Wrench& t, const Twist& v) const {
    const Wrench50 g = gradient(v.vx, v.vy, v.w);
    return (Real50(t.fx) * v.vx + Real50(t.fy) * v.vy + Real50(t.m) * v.w) / (g.fx * v.vx + g.fy * v.vy + g.m * v.w);
  }

  // `near` is a slip that is nearly right, w != 0. None if no slip could be proven.
  std::optional<Slip> slip(const Wrench& load, const Twist& near) const {
    for (const PointShare50& p : points_) {
      if (const auto on = on_facet(p, load)) return on;
    }
    if (const auto found = smooth_slip(load, near)) return found;
    const Real50 w = near.w;
    const Pole pole{-near.vy / near.w, near.vx / near.w};
    const auto nearest = std::ranges::min_element(
        points_, {}, [&](const PointShare50& p) { return hypot(Real50(p.x - pole.x), Real50(p.y - pole.y)); });
    if (nearest == points_.end()) return std::nullopt;
    const PointShare50& p = *nearest;
    const int sense = near.w < 0 ? -1 : 1;
    const Real50 zx = near.vx / w - p.y, zy = near.vy / w + p.x;
    if (const auto found = slip_beside(p, load, sense, zx, zy)) return found;
    // Rounding of the twist may have turned the velocity of the point: along the force asked of it instead.
    const auto [g, ax, ay] = asked(p, load, sense, 0, 0);
    const Real50 size = sqrt(ax * ax + ay * ay);
    Real50 length = sqrt(zx * zx + zy * zy);
    if (length == 0) length = 1e-18;
    for (const double k : {1., 1e-3, 1e3, 1e-6, 1e-12, 1e-18, 1e-24}) {
      const auto found = slip_beside(p, load, sense, k * length * ax / size, k * length * ay / size);
      if (found) return found;
    }
    return std::nullopt;
  }

 private:
  using Pair = std::array<Real50, 2>;
  using Triple = std::array<Real50, 3>;

  struct Asked {
    Real50 gauge, x, y;
  };

  static Real50 dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  Wrench50 without(const PointShare50* left_out, const Real50& vx, const Real50& vy, const Real50& w) const {
    Wrench50 g{0, 0, 0};
    if (smooth_) g = smooth_(vx, vy, w);
    for (const PointShare50& p : points_) {
      if (&p == left_out) continue;
      const Real50 x = vx - w * p.y, y = vy + w * p.x, speed = sqrt(x * x + y * y);
      if (speed == 0) continue;
      g.fx += p.share * x / speed;
      g.fy += p.share * y / speed;
      g.m += p.share * (p.x * y - p.y * x) / speed;
    }
    return g;
  }

  static Real50 moment(const PointShare50& p, const Wrench& t) {
    return Real50(t.m) - (p.x * Real50(t.fy) - p.y * Real50(t.fx));
  }

  static Real50 work(const PointShare50& p, const Wrench& t, int sense, const Real50& zx, const Real50& zy) {
    return sense * (t.fx * zx + t.fy * zy + moment(p, t));
  }

  // Of a spin `sense`, p at the velocity `sense` z: g = t . v / D, and F / g less what the rest bears.
  Asked asked(const PointShare50& p, const Wrench& t, int sense, const Real50& zx, const Real50& zy) const {
    const Wrench50 r = without(&p, p.y + zx, zy - p.x, 1);
    const Real50 D = r.fx * zx + r.fy * zy + r.m - (p.x * r.fy - p.y * r.fx) + p.share * sqrt(zx * zx + zy * zy);
    const Real50 g = work(p, t, sense, zx, zy) / D;
    return {g, sense * t.fx / g - r.fx, sense * t.fy / g - r.fy};
  }

  static Slip slip_at(const PointShare50& p, const Wrench& t, int s, const Real50& g, const Real50& zx,
                      const Real50& zy) {
    const Real50 D = work(p, t, s, zx, zy) / g;
    return {g, {s * (p.y + zx) / D, s * (zy - p.x) / D, s / D}, p.x - zy, p.y + zx};
  }

  std::optional<Slip> on_facet(const PointShare50& p, const Wrench& t) const {
    const int sense = moment(p, t) < 0 ? -1 : 1;
    const auto [g, ax, ay] = asked(p, t, sense, 0, 0);
    if (!(g > 0) || ax * ax + ay * ay > p.share * p.share) return std::nullopt;
    return slip_at(p, t, sense, g, 0, 0);
  }

  // Damped Newton's method with differences for derivatives.
  template <class Residual>
  static bool solve(const Residual& residual, Pair& u) {
    const auto size = [](const Pair& a) { return Real50(sqrt(a[0] * a[0] + a[1] * a[1])); };
    const Real50 h = 1e-16;
    Pair f = residual(u);
    for (int i = 0; i < 40 && !(size(f) < 1e-44); ++i) {
      const Pair fx = residual({u[0] + h, u[1]}), fy = residual({u[0], u[1] + h});
      const Real50 a = (fx[0] - f[0]) / h, b = (fy[0] - f[0]) / h, c = (fx[1] - f[1]) / h, d = (fy[1] - f[1]) / h;
      const Real50 det = a * d - b * c;
      if (det == 0) break;
      Real50 k = 1;
      bool better = false;
      for (int tries = 0; tries < 8 && !better; ++tries, k /= 4) {
        const Pair next{u[0] - k * (d * f[0] - b * f[1]) / det, u[1] - k * (a * f[1] - c * f[0]) / det};
        const Pair e = residual(next);
        better = size(e) < size(f);
        if (better) u = next, f = e;
      }
      if (!better) break;
    }
    return size(f) < 1e-35;
  }

  // Where D is smooth: t / g - grad D = 0 in the plane of all slips next to `near`, about the centre.
  std::optional<Slip> smooth_slip(const Wrench& t, const Twist& near) const {
    const Real50 x = centre_.x, y = centre_.y;
    Triple v{near.vx - near.w * y, near.vy + near.w * x, near.w * length_};
    const Real50 n = sqrt(dot(v, v));
    for (Real50& c : v) c /= n;
    const Triple axis = abs(v[2]) < 0.7 ? Triple{0, 0, 1} : Triple{1, 0, 0};
    Triple a = cross(v, axis);
    const Real50 size = sqrt(dot(a, a));
    for (Real50& c : a) c /= size;
    const Triple b = cross(v, a);
    const auto at = [&](const Pair& u) -> Triple {
      return {v[0] + u[0] * a[0] + u[1] * b[0], v[1] + u[0] * a[1] + u[1] * b[1], v[2] + u[0] * a[2] + u[1] * b[2]};
    };
    const auto centred = [&](const Wrench50& g) -> Triple {
      return {g.fx, g.fy, (g.m - (x * g.fy - y * g.fx)) / length_};
    };
    const auto gradient_at = [&](const Triple& s) {
      const Real50 w = s[2] / length_;
      return centred(gradient(s[0] + w * y, s[1] - w * x, w));
    };
    const Triple load = centred({t.fx, t.fy, t.m});
    const auto residual = [&](const Pair& u) -> Pair {
      const Triple s = at(u), g = gradient_at(s);
      const Real50 k = dot(load, s) / dot(g, s);
      const Triple r{load[0] / k - g[0], load[1] / k - g[1], load[2] / k - g[2]};
      return {dot(r, a), dot(r, b)};
    };
    Pair u{0, 0};
    if (!solve(residual, u)) return std::nullopt;
    const Triple s = at(u), g = gradient_at(s);
    const Real50 D = dot(g, s), k = dot(load, s) / D;
    // Far from `near` the plane says too little.
    const Triple r{load[0] / k - g[0], load[1] / k - g[1], load[2] / k - g[2]};
    if (!(k > 0) || s[2] == 0 || !(dot(r, r) < 1e-60)) return std::nullopt;
    const Real50 w = s[2] / length_;
    const Triple twist{(s[0] + w * y) / D, (s[1] - w * x) / D, w / D};
    return Slip{k, twist, -twist[1] / twist[2], twist[0] / twist[2]};
  }

  // Next to a point load: F / g - F_R = w z / |z| in ln |z| and the direction of z.
  std::optional<Slip> slip_beside(const PointShare50& p, const Wrench& t, int sense, const Real50& zx,
                                  const Real50& zy) const {
    if (zx == 0 && zy == 0) return std::nullopt;
    const auto z_of = [](const Pair& u) -> Pair { return {exp(u[0]) * cos(u[1]), exp(u[0]) * sin(u[1])}; };
    const auto residual = [&](const Pair& u) -> Pair {
      const Pair z = z_of(u);
      const Asked a = asked(p, t, sense, z[0], z[1]);
      return {a.x - p.share * cos(u[1]), a.y - p.share * sin(u[1])};
    };
    Pair u{log(zx * zx + zy * zy) / 2, atan2(zy, zx)};
    if (!solve(residual, u)) return std::nullopt;
    const Pair z = z_of(u);
    const Asked a = asked(p, t, sense, z[0], z[1]);
    if (!(a.gauge > 0)) return std::nullopt;
    return slip_at(p, t, sense, a.gauge, z[0], z[1]);
  }

  Gradient smooth_;
  std::vector<PointShare50> points_;
  PointShare50 centre_;
  Real50 length_;
};

}  // namespace patchgrip::friction
