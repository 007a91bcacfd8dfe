// Where D has kinks or straight pieces: point loads, loads on a line, a ring.
#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/tests/friction/limit_surface/loads.h>
#include <patchgrip/tests/friction/limit_surface/point_loads.h>

namespace patchgrip::friction {
namespace {

using ::patchgrip::testing::cases;

const PointLoads three({{-1, 0, 0.3}, {1, 0, 0.3}, {0, 1.3, 0.4}});

// A load on the facet of the third point: what the others bear slipping about it, and half of what it can bear itself.
Wrench on_facet() {
  const Wrench others = three.gradient(twist_about({0, 1.3}, 1));
  return {others.fx + 0.12, others.fy - 0.16, others.m - 1.3 * 0.12};
}

TEST(PointLoads, FacetIsToldAndItsGaugeBracketed) {
  const LimitSurface surface(three);
  const Gauge g = surface.gauge(on_facet());
  EXPECT_EQ(g.status, GaugeStatus::facet);
  EXPECT_NEAR(g.value, 1, 1e-9);
  EXPECT_LE(g.lower, 1);
  EXPECT_GE(g.upper, 1);
  EXPECT_LE(g.upper - g.lower, 1e-6);
  EXPECT_NEAR(-g.twist.vy / g.twist.w, 0, 1e-8);
  EXPECT_NEAR(g.twist.vx / g.twist.w, 1.3, 1e-8);
}

TEST(PointLoads, EveryLoadIsBracketed) {
  for (const PointLoads& patch :
       {three, PointLoads({{-1, 0, 0.5}, {1, 0, 0.5}}), PointLoads({{-1, 0.1, 0.2}, {1, 0, 0.1}, {0, 1.3, 0.7}}),
        PointLoads({{-1, 0.1, 0.2}, {1, 0, 0.1}, {0, 1.3, 0.3}, {0.1, 0.2, 0.4}})}) {
    const LimitSurface surface(patch);
    std::mt19937_64 engine(1);
    int facets = 0;
    for (int i = 0; i < cases(1000); ++i) {
      const Wrench t = draw_load(engine, patch.moments());
      const Gauge g = surface.gauge(t);
      ASSERT_TRUE(g.status == GaugeStatus::converged || g.status == GaugeStatus::facet)
          << t.fx << ' ' << t.fy << ' ' << t.m;
      ASSERT_LE(g.lower, g.value);
      ASSERT_GE(g.upper, g.value);
      ASSERT_LE(g.upper - g.lower, 1e-6 * g.value);
      // No motion tells of a larger gauge.
      for (int k = 0; k < 20; ++k) {
        const Wrench d = draw_load(engine, patch.moments());
        const Twist v{d.fx, d.fy, d.m};
        ASSERT_LE(power(t, v) / patch.dissipation(v), g.upper);
      }
      facets += g.status == GaugeStatus::facet;
    }
    if (all_cases()) EXPECT_GT(facets, 100);
  }
}

// All poles beyond the ends of the line share the wrench (0, 1, 0).
TEST(PointLoads, RidgeOfALineIsTold) {
  const LimitSurface surface(PointLoads({{-1, 0, 0.2}, {0, 0, 0.6}, {1, 0, 0.2}}));
  const Gauge g = surface.gauge({0, 2, 0});
  EXPECT_EQ(g.status, GaugeStatus::ridge);
  EXPECT_NEAR(g.value, 2, 1e-15);
  EXPECT_EQ(surface.gauge({0.3, 1, 0.1}).status, GaugeStatus::converged);
}

TEST(PointLoads, ASinglePointHasNoLimitSurface) {
  EXPECT_THROW(LimitSurface(PointLoads({{0.3, 0.2, 1}})), std::invalid_argument);
}

TEST(PointLoads, RingWithThePoleOnItConverges) {
  const LimitSurface surface(Ring::of_radius(2));
  for (const double off : {0.0, 1e-15, 1e-9, -1e-6}) {
    const Gauge g = surface.gauge({0.6, 0.8, -2 * (1 + off)});
    EXPECT_EQ(g.status, GaugeStatus::converged);
    EXPECT_LE(g.upper - g.lower, 1e-12 * g.value);
    EXPECT_LE(g.evaluations, 15);
    EXPECT_NEAR(g.value, std::acos(-1) / 2, 2e-6);
  }
}

TEST(PointLoads, TooFewEvaluationsStallButBracket) {
  const Gauge g = LimitSurface(Ring::of_radius(1), {.max_evaluations = 2}).gauge({0.5, 0, 0.4});
  EXPECT_EQ(g.status, GaugeStatus::stalled);
  const Gauge exact = LimitSurface(Ring::of_radius(1)).gauge({0.5, 0, 0.4});
  EXPECT_LE(g.lower, exact.value);
  EXPECT_GE(g.upper, exact.value);
}

}  // namespace
}  // namespace patchgrip::friction
