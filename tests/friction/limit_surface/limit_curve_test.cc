#include <patchgrip/friction/limit_surface/limit_curve.h>

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/limit_surface/round_gauge.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>

namespace patchgrip::friction {
namespace {

template <class P>
void expect_on_the_limit_surface(const P& disc) {
  const RoundLimitSurface surface(disc);
  const double a = disc.radius();
  const auto curve = limit_curve(disc, 101);
  ASSERT_EQ(curve.size(), 101u);
  for (const auto& [psi, f, m] : curve) {
    const Gauge g = surface.gauge({f, 0, m * a});
    EXPECT_NEAR(g.value, 1, 2e-15);
    EXPECT_NEAR(std::atan2(g.twist.vx, a * g.twist.w), psi, 1e-8);
  }
  EXPECT_EQ(curve.front().f, 0);
  EXPECT_NEAR(curve.back().f, 1, 1e-15);
  EXPECT_EQ(curve.back().m, 0);
}

TEST(LimitCurve, LiesOnTheLimitSurfaceWithItsNormal) {
  expect_on_the_limit_surface(HertzDisc::of_radius(0.2));
  expect_on_the_limit_surface(FlatPunchDisc::of_radius(1));
  expect_on_the_limit_surface(UniformDisc::of_radius(3));
  expect_on_the_limit_surface(Ring::of_radius(0.01));
}

// data/reference/friction.json, section limit_curve, r_M = a: psi = pi / 4
TEST(LimitCurve, AgreesWithTheReferenceTableOnTheRim) {
  const auto middle = limit_curve(HertzDisc::of_radius(2), 3)[1];
  EXPECT_NEAR(middle.f, 0.8835729338221293483176, 2e-16);
  EXPECT_NEAR(middle.m, 0.2208932334555323370794, 2e-16);
}

TEST(LimitCurve, NeedsTwoPoints) { EXPECT_THROW(limit_curve(Ring::of_radius(1), 1), std::invalid_argument); }

}  // namespace
}  // namespace patchgrip::friction
