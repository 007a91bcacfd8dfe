#include <patchgrip/friction/point_load.h>

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/ring.h>
#include <patchgrip/tests/friction/frame_reference.h>
#include <patchgrip/tests/friction/hessian.h>

namespace patchgrip::friction {
namespace {

using ::testing::ThrowsMessage;

TEST(PointLoad, FrictionIsOfUnitSizeAlongTheVelocity) {
  const Wrench g = PointLoad{}.gradient({3, -4, 7});
  EXPECT_DOUBLE_EQ(g.fx, 0.6);
  EXPECT_DOUBLE_EQ(g.fy, -0.8);
  EXPECT_EQ(g.m, 0);
  EXPECT_EQ(PointLoad{}.dissipation({3, -4, 7}), 5);
}

TEST(PointLoad, IsWithinItsBounds) {
  for (const Twist& v : {Twist{0.1, 0.7, 1}, Twist{1e-200, -3e-200, 1}, Twist{1e300, 1e299, -1}}) {
    const BoundedWrench g = PointLoad{}.bounded_gradient(v);
    const Wrench50 e = point_gradient(v.vx, v.vy, v.w);
    EXPECT_LE(static_cast<double>(hypot(g.value.fx - e.fx, g.value.fy - e.fy)), g.force_error);
    EXPECT_LE(g.force_error, 1e-15);
  }
}

// Every direction of the force would do: the one of least norm is none.
TEST(PointLoad, WithThePoleOnItAnswersTheLeastSubgradientAndHasNoHessian) {
  const Wrench g = PointLoad{}.gradient({0, 0, 1});
  EXPECT_TRUE(g.fx == 0 && g.fy == 0 && g.m == 0);
  EXPECT_EQ(PointLoad{}.bounded_gradient({0, 0, 1}).force_error, 0);
  EXPECT_THAT(
      [] {
        PointLoad{}.hessian({0, 0, 1});
      },
      ThrowsMessage<std::domain_error>("twist has its pole on the point load: the Hessian of D is infinite there"));
  EXPECT_THAT([] { PointLoad{}.hessian({}); },
              ThrowsMessage<std::domain_error>("twist = 0 is not allowed: the Hessian of D exists only in motion"));
}

TEST(PointLoad, HessianEqualsDifferencesOfTheExactGradient) {
  for (const Twist& v : {Twist{0.3, -0.1, 1}, Twist{2, 1, 0}}) {
    const Hessian exact = hessian_by_differences(point_gradient, v, 1);
    EXPECT_LE(scaled_difference(PointLoad{}.hessian(v), exact, v, 1), 1e-14);
  }
}

TEST(PointLoad, IsTheLimitOfASmallRing) {
  const Twist v{0.3, 0.4, 1};
  const Wrench point = PointLoad{}.gradient(v), ring = Ring::of_radius(1e-9).gradient(v);
  EXPECT_NEAR(point.fx, ring.fx, 1e-15);
  EXPECT_NEAR(point.fy, ring.fy, 1e-15);
  EXPECT_NEAR(point.m, ring.m, 1e-9);
}

TEST(PointLoad, HasNoExtent) {
  const PressureMoments s = PointLoad{}.moments();
  EXPECT_TRUE(s.x == 0 && s.y == 0 && s.polar == 0);
  EXPECT_EQ(PointLoad{}.area_radius(), 0);
}

}  // namespace
}  // namespace patchgrip::friction
