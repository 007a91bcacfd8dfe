// Patches and loads that cheap gauges are judged on, and the gauge of any patch as the judge.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/support_ratio.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/shapes.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {

// Two patches that share the load.
template <Patch A, Patch B>
struct Shared {
  double dissipation(const Twist& v) const noexcept { return sum(first.dissipation(v), second.dissipation(v)); }
  Wrench gradient(const Twist& v) const noexcept { return bounded_gradient(v).value; }
  BoundedWrench bounded_gradient(const Twist& v) const noexcept {
    const BoundedWrench p = first.bounded_gradient(v), q = second.bounded_gradient(v);
    const Wrench t{sum(p.value.fx, q.value.fx), sum(p.value.fy, q.value.fy), sum(p.value.m, q.value.m)};
    constexpr double rounding = 0x1p-51;
    return {t, sum(p.force_error, q.force_error) + rounding,
            sum(p.moment_error, q.moment_error) + rounding * sum(std::fabs(p.value.m), std::fabs(q.value.m))};
  }
  Hessian hessian(const Twist& v) const {
    const Hessian p = first.hessian(v), q = second.hessian(v);
    return {sum(p.xx, q.xx), sum(p.xy, q.xy), sum(p.xw, q.xw), sum(p.yy, q.yy), sum(p.yw, q.yw), sum(p.ww, q.ww)};
  }
  PressureMoments moments() const noexcept {
    const PressureMoments p = first.moments(), q = second.moments();
    const double x = sum(p.x, q.x), y = sum(p.y, q.y);
    const double apart = (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
    return {x, y, sum(p.polar, q.polar) + share * (1 - share) * apart};
  }
  double area_radius() const noexcept { return second.area_radius(); }

  double sum(double p, double q) const noexcept { return share * p + (1 - share) * q; }

  double share;  // of the first
  A first;
  B second;
};

// Most of the load in the middle, the rest on a ring far from it: a limit surface close to a cylinder.
inline auto target(double share, double radius) {
  return Shared{share, HertzDisc::of_radius(radius), Ring::of_radius(1)};
}

inline auto islands() {
  return Shared{0.7, Placed(HertzDisc::of_radius(0.1), 1, 0), Placed(HertzDisc::of_radius(0.07), -1, 0.5)};
}

// Its limit surface has a flat facet: every slip about the point load but one.
inline Several disc_and_point() {
  return Several::of_parts({{HertzDisc::of_radius(0.01), 1}, {Placed(PointLoad{}, 0.004, 0.002), 0.5}});
}

// test("name", patch) for patches of different kinds.
template <class Test>
void for_every_kind(const Test& test) {
  test("hertz_disc", HertzDisc::of_radius(0.0037));
  test("ring", Ring::of_radius(20));
  test("rectangle_4", Rectangle::of_sides(0.04, 0.01));
  test("slender_100", slender_100.patch());
  test("l_shape_away", Placed(l_shape.patch(), 0.5, -3));
  test("target", target(0.95, 1e-4));
  test("islands", islands());
}

// Directions about the centre of pressure: half of them anywhere, half close to pure forces and moments.
inline Wrench random_load(std::mt19937_64& engine, const CentredFrame& axes) {
  using testing::log_uniform, testing::uniform;
  const double phi = uniform(engine, -std::numbers::pi, std::numbers::pi);
  double m = uniform(engine, -1, 1), f = std::sqrt((1 - m) * (1 + m));
  switch (engine() % 4) {
    case 0:
      m = std::copysign(f * log_uniform(engine, 1e-12, 1), m);
      break;
    case 1:
      f = std::fabs(m) * log_uniform(engine, 1e-12, 1);
      break;
    default:
      break;
  }
  const double size = log_uniform(engine, 1e-3, 1e3);
  return axes.global(Wrench{size * f * std::cos(phi), size * f * std::sin(phi), size * m});
}

inline Wrench sum(const Wrench& s, const Wrench& t) { return {s.fx + t.fx, s.fy + t.fy, s.m + t.m}; }
inline Wrench scaled(double k, const Wrench& t) { return {k * t.fx, k * t.fy, k * t.m}; }

// The error that a model was found to have over `count` random loads; each of them within the model's bounds.
template <class Model, class P>
GaugeSides judge(const Model& model, const P& patch, int count) {
  const LimitSurface surface(patch);
  const auto axes = CentredFrame::of(patch);
  std::mt19937_64 engine(7);
  GaugeSides seen{0, 0};
  for (int i = 0; i < count; ++i) {
    const Wrench t = random_load(engine, axes);
    const Gauge truth = surface.gauge(t), cheap = model.gauge(t);
    EXPECT_LE(cheap.lower, truth.upper);
    EXPECT_GE(cheap.upper, truth.lower);
    EXPECT_LE(cheap.value, truth.upper * (1 + model.largest_excess() + 1e-13));
    EXPECT_GE(cheap.value, truth.lower * (1 - model.largest_deficit() - 1e-13));
    seen.largest_excess = std::max(seen.largest_excess, cheap.value / truth.value - 1);
    seen.largest_deficit = std::max(seen.largest_deficit, 1 - cheap.value / truth.value);
  }
  return seen;
}

// The gauge of a load of any size is that size times the gauge, and so is its bracket.
template <class Model>
void expect_every_size(const Model& model, const CentredFrame& axes) {
  std::mt19937_64 engine(17);
  for (int i = 0; i < testing::cases(50); ++i) {
    const Wrench t = random_load(engine, axes);
    const Gauge g = model.gauge(t);
    EXPECT_NEAR(model.value(t), g.value, 1e-15 * g.value);
    for (const int e : {-950, -700, -283, -100, 100, 283, 700, 900}) {
      const Wrench s{std::scalbn(t.fx, e), std::scalbn(t.fy, e), std::scalbn(t.m, e)};
      if (std::fpclassify(s.fx) == FP_SUBNORMAL || std::fpclassify(s.fy) == FP_SUBNORMAL ||
          std::fpclassify(s.m) == FP_SUBNORMAL || s.fx == 0 || s.fy == 0 || s.m == 0)
        continue;
      const Gauge at = model.gauge(s);
      EXPECT_NEAR(std::scalbn(model.value(s), -e), g.value, 4e-15 * g.value) << e;
      EXPECT_EQ(std::scalbn(at.lower, -e), g.lower) << e;
      EXPECT_EQ(std::scalbn(at.upper, -e), g.upper) << e;
      EXPECT_EQ(at.twist.w, g.twist.w) << e;
    }
  }
  // Subnormal: the bracket holds, as rough as it is.
  const double unit = std::numeric_limits<double>::denorm_min();
  const double exact = model.value({1, 0, 0});
  const Gauge small = model.gauge({5 * unit, 0, 0});
  EXPECT_LE(small.lower, 5 * exact * unit);
  EXPECT_GE(small.upper, 5 * exact * unit * (1 - model.largest_excess()));
  EXPECT_GT(small.value, 0);
}

// What holds of every convex gauge and its dissipation.
template <class Model>
void expect_convex_body(const Model& model, const CentredFrame& axes, int count) {
  constexpr double rounding = 1e-11;
  std::mt19937_64 engine(11);
  for (int i = 0; i < count; ++i) {
    const Wrench s = random_load(engine, axes), t = random_load(engine, axes);
    const double gs = model.value(s), gt = model.value(t), size = gs + gt;
    EXPECT_LE(model.value(sum(s, t)), size + rounding * size);
    EXPECT_NEAR(model.value(scaled(-3, t)), 3 * gt, rounding * gt);

    const Twist n = model.twist(t);  // supports the body at t
    EXPECT_NEAR(power(t, n), gt, rounding * gt);
    EXPECT_LE(power(s, n), gs + rounding * size);
    EXPECT_NEAR(model.dissipation(n), 1, 1e-9);

    const Twist v = twist_about({axes.x + 3 * axes.length * s.fx / gs, axes.y + axes.length * s.fy / gs}, s.m);
    const Wrench g = model.gradient(v);
    const double D = model.dissipation(v);
    EXPECT_NEAR(power(g, v), D, 1e-9 * D);
    EXPECT_NEAR(model.value(g), 1, 1e-9);
    EXPECT_LE(power(t, v), gt * D * (1 + 1e-9));
  }
}

}  // namespace patchgrip::friction
