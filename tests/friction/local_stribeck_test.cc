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
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/friction/xydas_kao_disc.h>
#include <patchgrip/tests/friction/local_reference.h>
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

// Poles inside, next to the rim, outside, far and at infinity, about an ellipse; speeds from slow to fast.
Twist random_twist(std::mt19937_64& engine, double a, double b) {
  const double phi = uniform(engine, -pi, pi), c = a * std::cos(phi), s = b * std::sin(phi);
  const double spin = (uniform(engine, 0, 1) < 0.5 ? 1 : -1) * log_uniform(engine, 1e-2, 30) / std::hypot(a, b);
  switch (std::uniform_int_distribution<int>(0, 5)(engine)) {
    case 0:
      return {spin * c, spin * s, 0};
    case 1: {
      const double x = 1 + (spin > 0 ? 1 : -1) * log_uniform(engine, 1e-16, 0.1);
      return twist_about({x * c, x * s}, spin);
    }
    case 2: {
      const double x = log_uniform(engine, 1, 1e4);
      return twist_about({x * c, x * s}, spin / x);
    }
    default: {
      const double x = uniform(engine, 0, 2);
      return twist_about({x * c, x * s}, spin);
    }
  }
}

// |found - exact| within the error that is stated, and that error of use. The reference is good to some 1e-18.
void expect_within_error(const BoundedWrench& found, const LocalExcess& exact, double length, double of_use) {
  constexpr double reference = 1e-17;
  EXPECT_LE(std::hypot(found.value.fx - exact.fx, found.value.fy - exact.fy), found.force_error + reference);
  EXPECT_LE(std::fabs(found.value.m - exact.m), found.moment_error + reference * length);
  EXPECT_LE(found.force_error, of_use);
  EXPECT_LE(found.moment_error, of_use * length);
}

TEST(LocalStribeck, OfAUniformEllipseIsWithinItsError) {
  std::mt19937_64 engine(20060301);
  for (int i = cases(16); i > 0; --i) {
    const double a = log_uniform(engine, 1e-3, 10), b = i % 2 ? a : a * log_uniform(engine, 0.1, 10);
    const Twist u = random_twist(engine, a, b);
    expect_within_error(stribeck_excess(PowerEllipse::of_semi_axes(a, b, 0.5), u), uniform_ellipse_excess(a, b, u),
                        std::max(a, b), 1e-14);
  }
}

// Down to needles: slow against v_S it is grad D, which is known to some units.
TEST(LocalStribeck, OfASlowSlenderEllipseIsTheGradient) {
  std::mt19937_64 engine(20060307);
  for (int i = cases(10); i > 0; --i) {
    const double aspect = log_uniform(engine, 10, 1e6), a = i % 2 ? 1 : 1 / aspect, b = i % 2 ? 1 / aspect : 1;
    const HertzEllipse patch = HertzEllipse::of_semi_axes(a, b);
    const Twist v = random_twist(engine, a, b), u{1e-10 * v.vx, 1e-10 * v.vy, 1e-10 * v.w};
    const BoundedWrench found = stribeck_excess(patch, u), exact = patch.bounded_gradient(u);
    const double speed2 = 1e-20 * std::pow(std::hypot(v.vx, v.vy) + std::fabs(v.w), 2);
    expect_near(found.value, exact.value, found.force_error + exact.force_error + speed2,
                found.moment_error + exact.moment_error + speed2);
    EXPECT_LE(found.force_error, 1e-12);
    EXPECT_LE(found.moment_error, 1e-12);
  }
}

// Every other pressure of the family is a stack of uniform ellipses.
TEST(LocalStribeck, OfOtherPressuresIsWithinItsError) {
  std::mt19937_64 engine(20060302);
  for (int i = cases(1); i > 0; --i) {
    for (const double n : {0.0, 1.0}) {
      const double b = i % 2 ? 0.4 : 1;
      const Twist u = random_twist(engine, 1, b);
      expect_within_error(stribeck_excess(PowerEllipse::of_semi_axes(1, b, n), u), power_ellipse_excess(1, b, n, u), 1,
                          1e-14);
    }
  }
}

TEST(LocalStribeck, OfAPolygonIsWithinItsError) {
  std::mt19937_64 engine(20060303);
  for (const Shape& shape : {triangle, l_shape, slender_10}) {
    const Polygon patch = shape.patch();
    const PressureMoments s = patch.moments();
    double radius = 0;
    for (const Point& p : shape.outer) radius = std::max(radius, std::hypot(p.x - s.x, p.y - s.y));
    for (int i = cases(6); i > 0; --i) {
      const Twist c = random_twist(engine, radius, radius), u{c.vx + c.w * s.y, c.vy - c.w * s.x, c.w};
      expect_within_error(stribeck_excess(patch, u), polygon_excess(shape.rings(), s, u), radius + std::hypot(s.x, s.y),
                          1e-12);
    }
  }
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
  const double nan = std::nan(""), bad[][3] = {{0, 1, 1},     {1, -1, 1}, {nan, 1, 1},  {1, INFINITY, 1},
                                               {1, 1, -0.51}, {1, 1, -1}, {1, 1, 20.1}, {1, 1, nan}};
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
  EXPECT_TRUE(LocalPatch<PointLoad>);
  EXPECT_TRUE(LocalPatch<Several>);
  EXPECT_TRUE(LocalPatch<AnyPatch>);
  EXPECT_TRUE(LocalPatch<Placed<AnyPatch>>);
  EXPECT_FALSE(LocalPatch<XydasKaoDisc>);
  const BoundedWrench none = stribeck_excess(AnyPatch(XydasKaoDisc::of_radius(1, 3)), {1, 2, 3});
  EXPECT_TRUE(std::isnan(none.value.fx) && std::isnan(none.value.m));
  EXPECT_TRUE(std::isinf(none.force_error) && std::isinf(none.moment_error));
}

}  // namespace
}  // namespace patchgrip::friction
