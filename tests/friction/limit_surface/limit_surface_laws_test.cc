// What holds of every limit surface, whatever the pressure: a convex body that contains its centre, and its gauge.
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/tests/friction/any_patch.h>
#include <patchgrip/tests/friction/motions.h>

namespace patchgrip::friction {

inline std::ostream& operator<<(std::ostream& out, const Wrench& t) {
  const auto precision = out.precision(17);
  out << "load {" << t.fx << ", " << t.fy << ", " << t.m << '}';
  out.precision(precision);
  return out;
}

namespace {

Gauge gauge_of(const NamedPatch& p, const Wrench& t) {
  return std::visit([&](const auto& patch) { return LimitSurface(patch).gauge(t); }, p.patch);
}

// Of any size; a third each nearly pure forces, nearly pure moments about the centroid, and anything between.
rc::Gen<Wrench> load_on(const NamedPatch& p) {
  return rc::gen::exec([&p] {
    const PressureMoments s = p.moments();
    const double size = *log_uniform(1e-6, 1e6);
    const double small = *log_uniform(1e-9, 1);
    const int kind = *rc::gen::inRange(0, 3);
    const double angle = kind == 0 ? *uniform(0, 1.57) : kind == 1 ? small : std::numbers::pi / 2 - small;
    const double direction = *uniform(-std::numbers::pi, std::numbers::pi);
    const double sense = *rc::gen::inRange(0, 2) == 0 ? 1 : -1;
    const double fx = size * std::cos(angle) * std::cos(direction), fy = size * std::cos(angle) * std::sin(direction);
    return Wrench{fx, fy, sense * size * std::sin(angle) * std::sqrt(s.polar) + (s.x * fy - s.y * fx)};
  });
}

Wrench operator+(const Wrench& s, const Wrench& t) { return {s.fx + t.fx, s.fy + t.fy, s.m + t.m}; }
Wrench operator*(double k, const Wrench& t) { return {k * t.fx, k * t.fy, k * t.m}; }

RC_GTEST_PROP(LimitSurfaceLaws, BracketIsNarrow, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Gauge g = gauge_of(p, *load_on(p));
    RC_ASSERT(g.status == GaugeStatus::converged || (p.is_line() && g.status == GaugeStatus::ridge));
    RC_ASSERT(g.lower <= g.value && g.value <= g.upper);
    RC_ASSERT(g.upper - g.lower <= 2e-12 * g.value);
    RC_ASSERT(g.evaluations <= 15);
  }
}

RC_GTEST_PROP(LimitSurfaceLaws, GaugeIsHomogeneousAndEven, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Wrench t = *load_on(p);
    const double k = *log_uniform(1e-9, 1e9);
    const Gauge g = gauge_of(p, t);
    for (const double factor : {k, -k}) {
      const Gauge scaled = gauge_of(p, factor * t);
      RC_ASSERT(std::fabs(scaled.value - k * g.value) <= 1e-13 * scaled.value);
      RC_ASSERT(scaled.lower <= k * g.upper * (1 + 1e-15) && scaled.upper * (1 + 1e-15) >= k * g.lower);
    }
  }
}

RC_GTEST_PROP(LimitSurfaceLaws, GaugeIsConvex, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Wrench s = *load_on(p), t = *load_on(p);
    RC_ASSERT(gauge_of(p, s + t).lower <= (gauge_of(p, s).upper + gauge_of(p, t).upper) * (1 + 1e-15));
  }
}

RC_GTEST_PROP(LimitSurfaceLaws, WrenchOfAMotionLiesOnTheSurface, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Twist v = *motion_of(p);
    const BoundedWrench t = p.bounded_gradient(v);
    const Gauge g = gauge_of(p, t.value);
    // |t - true t| <= the bounds, each of which asks for so much more at most.
    const double S = gauge_of(p, {0, 0, 1}).upper;
    const PressureMoments s = p.moments();
    const double uncertain =
        t.force_error + S * (t.moment_error + (std::fabs(s.x) + std::fabs(s.y)) * t.force_error) + 1e-15;
    RC_ASSERT(g.lower <= 1 + uncertain);
    RC_ASSERT(g.upper >= 1 - uncertain);
  }
}

// D(twist) = 1, so twist is the gradient of g: the plane of its loads of power g(t) touches the surface at t.
RC_GTEST_PROP(LimitSurfaceLaws, SlipIsNormalToTheSurface, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Wrench t = *load_on(p), other = *load_on(p);
    const Gauge g = gauge_of(p, t);
    RC_ASSERT(std::fabs(p.dissipation(g.twist) - 1) <= 1e-12);
    RC_ASSERT(std::fabs(power(t, g.twist) - g.value) <= 1e-12 * g.value);
    RC_ASSERT(power(other, g.twist) <= gauge_of(p, other).upper * (1 + 1e-12));
  }
}

// The friction wrench of the slip is opposed to the load, and as large as mu F_N = g(t) can make it.
RC_GTEST_PROP(LimitSurfaceLaws, SlipIsTheOneThatTheLoadStarts, ()) {
  for (const NamedPatch& p : every_patch()) {
    const Wrench t = *load_on(p);
    const Gauge g = gauge_of(p, t);
    const Wrench r = t + -g.value * p.gradient(g.twist);
    const PressureMoments s = p.moments();
    const double arm = std::fabs(s.x) + std::fabs(s.y) + std::sqrt(s.polar);
    RC_ASSERT(std::hypot(r.fx, r.fy) <= 3e-12 * g.value);
    RC_ASSERT(std::fabs(r.m) <= 3e-12 * g.value * arm);
  }
}

RC_GTEST_PROP(LimitSurfaceLaws, ForceNeedsLeastThroughTheCentroid, ()) {
  for (const NamedPatch& p : every_patch()) {
    const double phi = *uniform(-std::numbers::pi, std::numbers::pi);
    const PressureMoments s = p.moments();
    const double fx = std::cos(phi), fy = std::sin(phi);
    const double through = s.x * fy - s.y * fx;
    const Gauge g = gauge_of(p, {fx, fy, through});
    RC_ASSERT(std::fabs(g.value - 1) <= 1e-14);
    const double off = *log_uniform(1e-3, 10) * std::sqrt(s.polar);
    RC_ASSERT(gauge_of(p, {fx, fy, through + off}).lower > 1);
    RC_ASSERT(gauge_of(p, {fx, fy, through - off}).lower > 1);
  }
}

RC_GTEST_PROP(LimitSurfaceLaws, MovesWithThePatch, ()) {
  for (const NamedPatch& p : every_patch()) {
    const double x = *uniform(-1, 1) * p.size(), y = *uniform(-1, 1) * p.size();
    const Wrench t = *load_on(p);
    const Gauge g = gauge_of(p, t);
    const Wrench moved{t.fx, t.fy, t.m + (x * t.fy - y * t.fx)};
    const Gauge other =
        std::visit([&](const auto& patch) { return LimitSurface(Placed(patch, x, y)).gauge(moved); }, p.patch);
    RC_ASSERT(std::fabs(other.value - g.value) <= 1e-12 * g.value);
  }
}

RC_GTEST_PROP(LimitSurfaceLaws, TurnsAndGrowsWithThePatch, ()) {
  const PointRing& ring = l_ring;
  const double angle = *uniform(-3, 3), k = *log_uniform(1e-3, 1e3);
  const LimitSurface plain(Polygon::uniform(ring)), changed(Polygon::uniform(scaled(turned(ring, angle), k)));
  const Wrench t{*uniform(-1, 1), *uniform(-1, 1), *uniform(-1, 1)};
  RC_PRE(t.fx != 0 || t.fy != 0 || t.m != 0);
  const double c = std::cos(angle), s = std::sin(angle);
  const double g = plain.gauge(t).value;
  RC_ASSERT(std::fabs(changed.gauge({c * t.fx - s * t.fy, s * t.fx + c * t.fy, k * t.m}).value - g) <= 1e-13 * g);
}

}  // namespace
}  // namespace patchgrip::friction
