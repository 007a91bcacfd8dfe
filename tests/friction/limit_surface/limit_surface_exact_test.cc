// Brackets of the gauge against 80 digits: random polygons and slender rectangles.
//
// At the double's own twist v the lower bound t . v / D(v) is taken in many digits: the gauge exceeds it by the second
// order of what v is wrong by, about 1e-24.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/friction/limit_surface/loads.h>
#include <patchgrip/tests/friction/polygon_reference.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

using ::patchgrip::testing::cases;
using ::patchgrip::testing::log_uniform;
using ::patchgrip::testing::uniform;

PointRing draw_ring(std::mt19937_64& engine, double aspect) {
  const int n = std::uniform_int_distribution<>(3, 9)(engine);
  PointRing ring;
  for (int k = 0; k < n; ++k) {
    const double r = uniform(engine, 0.5, 1), phi = 2 * std::numbers::pi * (k + uniform(engine, 0, 0.8)) / n;
    ring.push_back({r * std::cos(phi), aspect * r * std::sin(phi)});
  }
  const double size = log_uniform(engine, 1e-4, 10);
  return moved(scaled(turned(ring, uniform(engine, -3, 3)), size), size * uniform(engine, -2, 2),
               size * uniform(engine, -2, 2));
}

Real50 lower_bound(const PolygonReference& exact, const Wrench& t, const Twist& v) {
  const Wrench50 g = exact.gradient(v);
  const Real50 D = g.fx * v.vx + g.fy * v.vy + g.m * v.w;
  return (Real50(t.fx) * v.vx + Real50(t.fy) * v.vy + Real50(t.m) * v.w) / D;
}

void expect_bracketed(const PointRing& ring, std::mt19937_64& engine, int loads, double rounding) {
  const Shape shape{"", ring};
  const PolygonReference exact(shape.rings());
  const LimitSurface surface(shape.patch());
  const PressureMoments s = surface.patch().moments();
  for (int i = 0; i < loads; ++i) {
    const Wrench t = draw_load(engine, s);
    const Gauge g = surface.gauge(t);
    ASSERT_EQ(g.status, GaugeStatus::converged);
    const Real50 truth = lower_bound(exact, t, g.twist);
    ASSERT_LE(g.lower, truth);
    ASSERT_GE(g.upper, truth);
    ASSERT_LE(std::fabs(static_cast<double>(g.value / truth - 1)), rounding) << t.fx << ' ' << t.fy << ' ' << t.m;
  }
}

TEST(LimitSurfaceExact, BracketsHoldOfRandomPolygons) {
  std::mt19937_64 engine(1);
  for (int i = 0; i < cases(60); ++i) expect_bracketed(draw_ring(engine, 1), engine, 5, 1e-14);
}

TEST(LimitSurfaceExact, BracketsHoldOfSlenderPolygons) {
  std::mt19937_64 engine(2);
  for (int i = 0; i < cases(60); ++i) {
    expect_bracketed(draw_ring(engine, log_uniform(engine, 1e-2, 1)), engine, 5, 1e-13);
  }
}

TEST(LimitSurfaceExact, BracketsHoldOfRectangles) {
  std::mt19937_64 engine(3);
  for (const double aspect : {1.0, 3.0, 10.0, 100.0}) {
    expect_bracketed(box(-aspect / 2, -0.5, aspect / 2, 0.5), engine, cases(100), 1e-13);
  }
}

// Every gauge converges to 1e-12, whatever the load: nearly pure forces and moments are two thirds of them.
template <class P>
void expect_all_converge(const P& patch, unsigned seed, double mean_at_most) {
  const LimitSurface surface(patch);
  std::mt19937_64 engine(seed);
  const int count = cases(4000);
  long sum = 0;
  std::vector<int> evaluations;
  for (int i = 0; i < count; ++i) {
    const Gauge g = surface.gauge(draw_load(engine, patch.moments()));
    ASSERT_EQ(g.status, GaugeStatus::converged);
    ASSERT_LE(g.upper - g.lower, 1e-12 * g.value);
    sum += g.evaluations;
    evaluations.push_back(g.evaluations);
  }
  std::ranges::sort(evaluations);
  EXPECT_LE(double(sum) / count, mean_at_most);
  EXPECT_LE(evaluations[static_cast<std::size_t>(0.99 * count)], 10);
  EXPECT_LE(evaluations.back(), 16);
}

TEST(LimitSurfaceExact, FewEvaluationsConvergeForEveryLoad) {
  for (const double aspect : {1.0, 2.0, 10.0, 100.0}) expect_all_converge(Rectangle::of_sides(aspect, 1), 4, 4.2);
  expect_all_converge(l_shape.patch(), 5, 4.7);
}

}  // namespace
}  // namespace patchgrip::friction
