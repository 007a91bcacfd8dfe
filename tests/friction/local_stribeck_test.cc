#include <patchgrip/friction/local_stribeck.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/flat_punch_disc.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/stamp_disc.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>
#include <patchgrip/tests/friction/local_motions.h>
#include <patchgrip/tests/friction/shapes.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;
using std::numbers::pi;

const Law stribeck = Law::stribeck(0.9, 0.5, 0.3);

void expect_near(const Wrench& a, const Wrench& b, double force, double moment) {
  EXPECT_LE(std::hypot(a.fx - b.fx, a.fy - b.fy), force);
  EXPECT_LE(std::fabs(a.m - b.m), moment);
}

TEST(LocalStribeck, InATranslationIsStribeckInTheMean) {
  const auto compare = [](const auto& patch, double lever) {
    for (const Twist& v : {Twist{0.1, 0.2, 0}, Twist{-0.3, 0, 0}, Twist{1e-9, 1e-9, 0}}) {
      expect_near(local_friction_wrench(stribeck, 10, patch, v).value, friction_wrench(stribeck, 10, patch, v).value,
                  1e-14, 1e-14 * lever);
    }
  };
  compare(HertzDisc::of_radius(0.2), 0.2);
  compare(Placed(Ring::of_radius(0.2), 1, 2), 3);
  compare(l_shape.patch(), 2);
}

TEST(LocalStribeck, OfEqualCoefficientsIsCoulomb) {
  const Law coulomb = Law::coulomb(0.7).with_viscous(0.2);
  const UniformDisc disc = UniformDisc::of_radius(0.2);
  const Twist v{0.1, -0.05, 2};
  const BoundedWrench t = local_friction_wrench(coulomb, 3, disc, v), e = friction_wrench(coulomb, 3, disc, v);
  expect_near(t.value, e.value, 0, 0);
  EXPECT_EQ(t.force_error, e.force_error);
  EXPECT_EQ(t.moment_error, e.moment_error);
}

// Slow against v_S everywhere: all of it at mu_s; fast: at mu_k, but for the points next to the pole.
TEST(LocalStribeck, TendsToBothCoefficients) {
  const auto compare = [](const auto& patch) {
    for (const Twist& v : {Twist{0.1, -0.05, 2}, Twist{1, 2, 1}}) {
      const auto local = [&](double v_S) {
        return local_friction_wrench(Law::stribeck(0.9, 0.5, v_S), 1, patch, v).value;
      };
      expect_near(local(1e8), friction_wrench(Law::coulomb(0.9), 1, patch, v).value, 1e-14, 1e-14);
      expect_near(local(1e-6), friction_wrench(Law::coulomb(0.5), 1, patch, v).value, 1e-9, 1e-9);
    }
  };
  compare(UniformDisc::of_radius(0.2));
  compare(FlatPunchDisc::of_radius(0.2));
  compare(Rectangle::of_sides(0.3, 0.2));
  compare(LineLoad::of_length(0.3));
}

TEST(LocalStribeck, NeverDrivesAndReversesWithTheMotion) {
  std::mt19937_64 engine(20060304);
  for (int i = cases(15); i > 0; --i) {
    const Law law = Law::stribeck(uniform(engine, 0, 2), uniform(engine, 0, 2), log_uniform(engine, 0.05, 10));
    const Twist v = random_twist(engine, 1, 0.5), back{-v.vx, -v.vy, -v.w};
    const auto check = [&](const auto& patch) {
      const BoundedWrench t = local_friction_wrench(law, 1, patch, v);
      const double rounding = t.force_error * std::hypot(v.vx, v.vy) + t.moment_error * std::fabs(v.w);
      EXPECT_LE(power(t.value, v), rounding);
      expect_near(
          t.value,
          [&] {
            const Wrench r = local_friction_wrench(law, 1, patch, back).value;
            return Wrench{-r.fx, -r.fy, -r.m};
          }(),
          2 * t.force_error, 2 * t.moment_error);
    };
    check(HertzDisc::of_radius(0.7));
    check(Rectangle::of_sides(2, 1));
    check(LineLoad::of_length(2));
  }
}

TEST(LocalStribeck, TwoHalvesOfARectangleAreTheWhole) {
  const Rectangle whole = Rectangle::of_sides(4, 1), half = Rectangle::of_sides(2, 1);
  const Placed left(half, -1, 0), right(half, PlanarFrame{1, 0, pi});
  for (const Twist& v : {Twist{0, 0, 0.2}, Twist{0.2, 0.1, 0.3}, Twist{0, 0.3, 0.1}, Twist{0.5, 4, -0.1}}) {
    const Wrench l = local_friction_wrench(stribeck, 0.5, left, v).value;
    const Wrench r = local_friction_wrench(stribeck, 0.5, right, v).value;
    expect_near({l.fx + r.fx, l.fy + r.fy, l.m + r.m}, local_friction_wrench(stribeck, 1, whole, v).value, 1e-14,
                2e-14);
  }
}

// Next to two radii the triangles change from those about the pole to those about the centroid.
TEST(LocalStribeck, OfAPolygonIsContinuousWhereTheWayChanges) {
  const Rectangle patch = Rectangle::of_sides(2, 1);
  const double r = 2 * std::hypot(1, 0.5);
  const Wrench near = stribeck_excess(patch, twist_about({r * (1 - 1e-15), 0}, 0.3)).value;
  const Wrench far = stribeck_excess(patch, twist_about({r * (1 + 1e-15), 0}, 0.3)).value;
  expect_near(near, far, 1e-14, 1e-14);
}

TEST(LocalStribeck, TurnsWithThePatch) {
  const PowerEllipse lying = PowerEllipse::of_semi_axes(2, 1, 1), standing = PowerEllipse::of_semi_axes(1, 2, 1);
  for (const Twist& u : {Twist{0.3, -0.1, 1}, Twist{2, 1, -0.5}, Twist{0, 0, 1}}) {
    const Wrench g = stribeck_excess(lying, u).value, h = stribeck_excess(standing, {-u.vy, u.vx, u.w}).value;
    expect_near({-g.fy, g.fx, g.m}, h, 2e-15, 2e-15);
  }
}

TEST(LocalStribeck, RefusesEllipsesBeyondTheDomain) {
  const double nan = std::nan(""), bad[][3] = {{0, 1, 1},  {1, -1, 1},   {nan, 1, 1}, {1, INFINITY, 1}, {1, 1, -0.51},
                                               {1, 1, -1}, {1, 1, 20.1}, {1, 1, nan}, {1, 2, -0.1},     {2, 1, -0.5}};
  for (const auto& [a, b, n] : bad) EXPECT_THROW(PowerEllipse::of_semi_axes(a, b, n), std::invalid_argument);
}

TEST(LocalStribeck, OfAFastTranslationIsNothing) {
  for (const double speed : {30.0, 1e155, 1e300}) {
    const BoundedWrench none = stribeck_excess(PointLoad{}, {speed, -speed, 0});
    EXPECT_TRUE(none.value.fx == 0 && none.value.fy == 0 && none.value.m == 0);
    EXPECT_TRUE(none.force_error == 0 && none.moment_error == 0);
  }
}

TEST(LocalStribeck, AtRestThereIsNoFriction) {
  const Wrench t = local_friction_wrench(stribeck, 10, HertzDisc::of_radius(1), {}).value;
  EXPECT_TRUE(t.fx == 0 && t.fy == 0 && t.m == 0);
}

TEST(LocalStribeck, OfARoundEllipseIsThatOfTheDisc) {
  std::mt19937_64 engine(20060305);
  for (int i = cases(10); i > 0; --i) {
    const double a = log_uniform(engine, 1e-3, 10);
    const Twist u = random_twist(engine, a, a);
    const BoundedWrench disc = stribeck_excess(HertzDisc::of_radius(a), u);
    const BoundedWrench next = stribeck_excess(HertzEllipse::of_semi_axes(a, a * (1 + 1e-15)), u);
    expect_near(stribeck_excess(HertzEllipse::of_semi_axes(a, a), u).value, disc.value, 0, 0);
    expect_near(next.value, disc.value, next.force_error + disc.force_error + 1e-14,
                next.moment_error + disc.moment_error + 1e-14 * a);
  }
}

// Each part by its F_i and mu_i, behind one type, moved and turned; a point load bears no moment about itself.
TEST(LocalStribeck, OfSeveralIsTheSumOfTheParts) {
  std::mt19937_64 engine(20060306);
  for (int i = cases(5); i > 0; --i) {
    const Placed<HertzEllipse> ellipse(HertzEllipse::of_semi_axes(0.5, 0.2), {0.3, -0.2, uniform(engine, -4, 4)});
    const Placed<PointLoad> point(PointLoad{}, -1, 0.5);
    const Placed<Rectangle> block(Rectangle::of_sides(1, 0.3), {-0.2, 0.7, 0.4});
    const double F[] = {uniform(engine, 1, 5), uniform(engine, 1, 5), uniform(engine, 1, 5)};
    const double mu[] = {uniform(engine, 0, 1), uniform(engine, 0, 1), uniform(engine, 0.1, 1)};
    const Several several = Several::of_parts({{ellipse, F[0], mu[0]}, {point, F[1], mu[1]}, {block, F[2], mu[2]}});
    const Law one = Law::stribeck(1.8, 1, 0.3);
    const Twist v = random_twist(engine, 1, 1);
    const auto bears = [&](int k, const auto& patch) { return local_friction_wrench(one, mu[k] * F[k], patch, v); };
    const BoundedWrench parts[] = {bears(0, ellipse), bears(1, point), bears(2, block)};
    BoundedWrench sum;
    for (const auto& [t, force_error, moment_error] : parts) {
      sum.value = {sum.value.fx + t.fx, sum.value.fy + t.fy, sum.value.m + t.m};
      sum.force_error += force_error;
      sum.moment_error += moment_error;
    }
    const BoundedWrench whole = local_friction_wrench(one, several.resistance(), AnyPatch(several), v);
    expect_near(whole.value, sum.value, sum.force_error + whole.force_error, sum.moment_error + whole.moment_error);
    EXPECT_LE(whole.force_error, 1e-12 * several.resistance());
  }
}

TEST(LocalStribeck, OfAPointIsThatOfItsSpeed) {
  const Twist v{0.3, -0.4, 7};
  const Wrench t = local_friction_wrench(stribeck, 10, PointLoad{}, v).value;
  const double mu = 0.5 + 0.4 * std::exp(-0.25 / 0.09);
  expect_near(t, {-10 * mu * 0.6, 10 * mu * 0.8, 0}, 1e-14, 0);
  const Wrench turning = local_friction_wrench(stribeck, 10, PointLoad{}, {0, 0, 7}).value;
  expect_near(turning, {}, 0, 0);
}

TEST(LocalStribeck, IsForPatchesWhosePressureItKnows) {
  EXPECT_TRUE(LocalPatch<HertzDisc>);
  EXPECT_TRUE(LocalPatch<Placed<Placed<Rectangle>>>);
  EXPECT_TRUE(LocalPatch<HertzEllipse>);
  EXPECT_TRUE(LocalPatch<LineLoad>);
  EXPECT_TRUE(LocalPatch<PointLoad>);
  EXPECT_TRUE(LocalPatch<Several>);
  EXPECT_TRUE(LocalPatch<AnyPatch>);
  EXPECT_TRUE(LocalPatch<Placed<AnyPatch>>);
  EXPECT_FALSE(LocalPatch<XydasKaoDisc>);
  EXPECT_FALSE(LocalPatch<StampDisc>);
  const BoundedWrench none = stribeck_excess(AnyPatch(XydasKaoDisc::of_radius(1, 3)), {1, 2, 3});
  EXPECT_TRUE(std::isnan(none.value.fx) && std::isnan(none.value.m));
  EXPECT_TRUE(std::isinf(none.force_error) && std::isinf(none.moment_error));
}

}  // namespace
}  // namespace patchgrip::friction
