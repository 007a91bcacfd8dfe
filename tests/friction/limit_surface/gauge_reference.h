// Gauge and slip of a load in 50 digits, of any pressure whose gradient is known in 50 digits and of point loads.
//
// With the pole on a point load that bears what the rest leaves to it, |F / g - F_R| <= w, the gauge is |M_P| / R_P.
// Other loads start slips at which D is smooth. Those are found by Newton's method for the least of D^2 / 2 - t . v,
// from a slip said to be near, or else with sqrt(|v_P|^2 + epsilon^2) for |v_P| and epsilon towards 0: convex, without
// kinks, no start is a bad one. Proven: t / g is the gradient of D itself there, to 1e-27; by convexity g is the gauge.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <limits>
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
  using Triple = std::array<Real50, 3>;

  struct Slip {
    Real50 gauge;
    Triple twist;  // D = 1
    Real50 x, y;   // of the pole
  };

  // `smooth` is the gradient of all but the points, weighted by its share; empty if there is nothing else. The moments
  // need not be exact.
  GaugeReference(Gradient smooth, std::vector<PointShare50> points, const PressureMoments& s)
      : smooth_(std::move(smooth)), points_(std::move(points)), x_(s.x), y_(s.y), length_(std::sqrt(s.polar)) {}

  // None if nothing could be proven.
  std::optional<Slip> slip(const Wrench& t, const Twist& near) const {
    for (const PointShare50& p : points_) {
      if (const auto on = on_facet(p, t)) return on;
    }
    const Triple load = centred({t.fx, t.fy, t.m});
    const Real50 size = length_of(load);
    const Triple unit = combined(1 / size, load, 0, load);
    const Real50 k = size / dot(load, of_twist(near));  // D^2 is to be t . v
    if (const auto found = smooth_slip(unit, size, combined(k, of_twist(near), 0, load))) return found;
    Triple u = unit;
    for (Real50 epsilon = 0.1; epsilon > 1e-40; epsilon /= 10) {
      if (descend(unit, epsilon, u).least_speed < 1e3 * epsilon) continue;
      if (const auto found = smooth_slip(unit, size, u)) return found;
    }
    return std::nullopt;
  }

 private:
  using Matrix = std::array<Triple, 3>;

  // D and its derivatives about the centre, spins times the length.
  struct State {
    Real50 D = 0;
    Triple gradient{};
    Matrix hessian{};
    Real50 least_speed = std::numeric_limits<double>::max();  // of a point
  };

  static Real50 dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Real50 length_of(const Triple& a) { return sqrt(dot(a, a)); }
  static Triple combined(const Real50& j, const Triple& a, const Real50& k, const Triple& b) {
    return {j * a[0] + k * b[0], j * a[1] + k * b[1], j * a[2] + k * b[2]};
  }

  Triple centred(const Wrench50& g) const { return {g.fx, g.fy, (g.m - (x_ * g.fy - y_ * g.fx)) / length_}; }

  Triple smooth_gradient(const Triple& u) const {
    const Real50 w = u[2] / length_;
    return centred(smooth_(u[0] + w * y_, u[1] - w * x_, w));
  }

  void add_smooth(const Triple& u, State& s) const {
    s.gradient = smooth_gradient(u);
    s.D = dot(s.gradient, u);
    const Real50 h = 1e-20 * length_of(u);
    for (std::size_t i = 0; i < 3; ++i) {
      Triple aside = u;
      aside[i] += h;
      s.hessian[i] = combined(1 / h, smooth_gradient(aside), -1 / h, s.gradient);
    }
  }

  State at(const Triple& u, const Real50& epsilon) const {
    State s;
    if (smooth_) add_smooth(u, s);
    for (const PointShare50& p : points_) {
      const Real50 a = (p.x - x_) / length_, b = (p.y - y_) / length_;
      const Real50 zx = u[0] - u[2] * b, zy = u[1] + u[2] * a;
      const Real50 z2 = zx * zx + zy * zy, size = sqrt(z2 + epsilon * epsilon);
      s.least_speed = std::min(s.least_speed, Real50(sqrt(z2)));
      if (size == 0) continue;
      s.D += p.share * size;
      // The velocity of the point is (x . u, y . u).
      const Triple x{1, 0, -b}, y{0, 1, a};
      const Triple along = combined(zx / size, x, zy / size, y);
      s.gradient = combined(1, s.gradient, p.share, along);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          s.hessian[i][j] += p.share / size * (x[i] * x[j] + y[i] * y[j] - along[i] * along[j]);
        }
      }
    }
    return s;
  }

  Triple of_twist(const Twist& v) const { return {v.vx - v.w * y_, v.vy + v.w * x_, v.w * length_}; }

  std::optional<Slip> smooth_slip(const Triple& unit, const Real50& size, Triple u) const {
    const State s = descend(unit, 0, u);
    const Real50 k = dot(unit, u) / s.D;
    if (!(k > 0) || !(length_of(combined(1 / k, unit, -1, s.gradient)) < 1e-27)) return std::nullopt;
    const Real50 w = u[2] / length_, vx = u[0] + w * y_, vy = u[1] - w * x_;
    return Slip{size * k, {vx / s.D, vy / s.D, w / s.D}, -vy / w, vx / w};
  }

  // A symmetric and positive; a little more than that where it is not.
  static Triple solved(Matrix A, Triple b) {
    const Real50 least = 1e-46 * (A[0][0] + A[1][1] + A[2][2]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (A[k][k] < least) A[k][k] = least;
      for (std::size_t i = k + 1; i < 3; ++i) {
        const Real50 c = A[i][k] / A[k][k];
        for (std::size_t j = k; j < 3; ++j) A[i][j] -= c * A[k][j];
        b[i] -= c * b[k];
      }
    }
    b[2] /= A[2][2];
    b[1] = (b[1] - A[1][2] * b[2]) / A[1][1];
    b[0] = (b[0] - A[0][1] * b[1] - A[0][2] * b[2]) / A[0][0];
    return b;
  }

  // Newton's method for the least of D^2 / 2 - t . u; a step that overshoots is cut to where the secant of the slopes
  // at its ends says.
  State descend(const Triple& t, const Real50& epsilon, Triple& u) const {
    State s = at(u, epsilon);
    Triple fall = combined(1, t, -s.D, s.gradient);
    for (int i = 0; i < 20 && length_of(fall) > 1e-44; ++i) {
      Matrix A;
      for (std::size_t j = 0; j < 3; ++j) A[j] = combined(s.D, s.hessian[j], s.gradient[j], s.gradient);
      const Triple step = solved(A, fall);
      const Real50 slope = dot(fall, step);
      Real50 k = 1;
      for (int tries = 0; tries < 60; ++tries) {
        const Triple to = combined(1, u, k, step);
        const State next = at(to, epsilon);
        const Triple next_fall = combined(1, t, -next.D, next.gradient);
        const Real50 end = dot(next_fall, step);
        if (-end <= 0.9 * slope) {
          u = to, s = next, fall = next_fall;
          break;
        }
        k *= std::max(Real50(0.1), Real50(slope / (slope - end)));
      }
      if (k < 1e-40) break;
    }
    return s;
  }

  // Forces and moments about the point.
  std::optional<Slip> on_facet(const PointShare50& p, const Wrench& t) const {
    const auto moment = [&](const Real50& fx, const Real50& fy, const Real50& m) {
      return Real50(m - (p.x * fy - p.y * fx));
    };
    const Real50 M = moment(t.fx, t.fy, t.m);
    const int sense = M < 0 ? -1 : 1;
    Wrench50 r{0, 0, 0};
    if (smooth_) r = smooth_(p.y, -p.x, 1);
    for (const PointShare50& q : points_) {
      const Real50 zx = p.y - q.y, zy = q.x - p.x, speed = sqrt(zx * zx + zy * zy);
      if (speed == 0) continue;
      r.fx += q.share * zx / speed;
      r.fy += q.share * zy / speed;
      r.m += q.share * (q.x * zy - q.y * zx) / speed;
    }
    const Real50 D = moment(r.fx, r.fy, r.m), g = abs(M) / D;
    if (!(g > 0)) return std::nullopt;
    const Real50 qx = sense * t.fx / g - r.fx, qy = sense * t.fy / g - r.fy;
    if (qx * qx + qy * qy > p.share * p.share) return std::nullopt;
    return Slip{g, {sense * p.y / D, -sense * p.x / D, sense / D}, p.x, p.y};
  }

  Gradient smooth_;
  std::vector<PointShare50> points_;
  Real50 x_, y_, length_;
};

}  // namespace patchgrip::friction
