#include <patchgrip/friction/placed.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/polygon.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/tests/friction/frame_reference.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/polygon_reference.h>
#include <patchgrip/tests/friction/round_reference.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

using kernels::PowerFamily;
using std::numbers::pi;
using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Gradient50 disc_gradient(const PowerFamily<Real50>& family, double radius) {
  return [&family, radius](const Real50& vx, const Real50& vy, const Real50& w) {
    return round_wrench(family, radius, vx, vy, w);
  };
}

template <class P>
void expect_within_bounds(const Placed<P>& patch, const Gradient50& exact, const Twist& v, double of_use) {
  const BoundedWrench g = patch.bounded_gradient(v);
  const Wrench50 e = exact(v.vx, v.vy, v.w);
  const Wrench same = patch.gradient(v);
  EXPECT_TRUE(same.fx == g.value.fx && same.fy == g.value.fy && same.m == g.value.m);
  EXPECT_LE(static_cast<double>(hypot(g.value.fx - e.fx, g.value.fy - e.fy)), g.force_error);
  EXPECT_LE(static_cast<double>(abs(g.value.m - e.m)), g.moment_error);
  const double arm = std::hypot(patch.x(), patch.y()) + patch.area_radius();
  EXPECT_LE(g.force_error, of_use);
  EXPECT_LE(g.moment_error, 3 * of_use * arm);
  const Real50 D = e.fx * v.vx + e.fy * v.vy + e.m * v.w;
  EXPECT_NEAR(patch.dissipation(v), static_cast<double>(D), 1e-15 * (std::hypot(v.vx, v.vy) + std::fabs(v.w) * arm));
}

// Poles all over the disc, near its rim and far away, seen from an origin up to a hundred radii off.
template <class P>
void expect_disc_within_bounds(double n) {
  const PowerFamily<Real50> family(n);
  std::mt19937_64 engine(20060103);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double radius = std::pow(10, -3 * unit(engine));
    const double x = radius * std::pow(10, 4 * unit(engine) - 2), y = -radius * 100 * unit(engine);
    const double angle = 2 * pi * unit(engine);
    const double r = radius * (i % 3 == 0 ? 1 + (i % 2 == 0 ? 1 : -1) * std::pow(10, -16 * unit(engine))
                                          : std::pow(10, 6 * unit(engine) - 3));
    const Twist v = twist_about({x + r * std::cos(angle), y + r * std::sin(angle)}, i % 2 == 0 ? 1 : -0.7);
    expect_within_bounds(Placed(P::of_radius(radius), x, y), in_frame(disc_gradient(family, radius), {x, y, 0}), v,
                         1e-14);
  }
}

TEST(Placed, HertzDiscIsWithinItsBounds) { expect_disc_within_bounds<HertzDisc>(1); }
TEST(Placed, RingIsWithinItsBounds) { expect_disc_within_bounds<Ring>(-0.5); }

TEST(Placed, PolygonIsWithinItsBounds) {
  const PolygonReference reference(l_shape.rings());
  const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) {
    return reference.gradient(vx, vy, w);
  };
  for (const Pole& pole : {Pole{0, 0}, Pole{3, -1}, Pole{0.2, 0.1}, Pole{2.25, -1.75}, Pole{-40, 7}, Pole{1e5, 1e6}}) {
    expect_within_bounds(Placed(l_shape.patch(), 3, -1), in_frame(gradient, {3, -1, 0}), twist_about(pole, 1), 1e-13);
  }
}

TEST(Placed, ATurnedPolygonIsWithinItsBounds) {
  const PolygonReference reference(l_shape.rings());
  const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) {
    return reference.gradient(vx, vy, w);
  };
  for (const double angle : {0.3, -2.5, pi / 2, 1e5}) {
    const PlanarFrame frame{3, -1, angle};
    const Placed patch(l_shape.patch(), frame);
    for (const Pole& pole : {Pole{0, 0}, Pole{3, -1}, Pole{0.2, 0.1}, Pole{2.25, -1.75}, Pole{-40, 7}}) {
      expect_within_bounds(patch, in_frame(gradient, frame), twist_about(pole, 1), 1e-13);
    }
    const Twist v = twist_about({2.7, -0.9}, -1.5);
    const Hessian exact = hessian_by_differences(in_frame(gradient, frame), v, 3);
    EXPECT_LE(scaled_difference(patch.hessian(v), exact, v, 3), 1e-14 * scaled_size(exact, v, 3));
  }
}

// The velocity at its own origin, which is rounded, is a thousand times that of its points.
TEST(Placed, APatchFarFromItsOwnOriginIsWithinItsBounds) {
  const PowerFamily<Real50> family(1);
  std::mt19937_64 engine(20060103);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 200; ++i) {
    const PlanarFrame inner{1000 * unit(engine), 1000 * unit(engine), 0};
    const PlanarFrame outer{unit(engine), unit(engine), i % 2 == 0 ? 0 : unit(engine)};
    const Placed patch(Placed(HertzDisc::of_radius(1), inner), outer);
    const PressureMoments s = patch.moments();
    const Twist v = twist_about({s.x + unit(engine), s.y + unit(engine)}, 1 + unit(engine) / 2);
    const BoundedWrench g = patch.bounded_gradient(v);
    const Wrench50 e = in_frame(in_frame(disc_gradient(family, 1), inner), outer)(v.vx, v.vy, v.w);
    EXPECT_LE(static_cast<double>(hypot(g.value.fx - e.fx, g.value.fy - e.fy)), g.force_error);
    EXPECT_LE(static_cast<double>(abs(g.value.m - e.m)), g.moment_error);
    EXPECT_LE(g.force_error, 2e-12);
  }
}

// (x, y) -> (-y, x): what was seen along x is seen along y.
TEST(Placed, AQuarterTurnTurnsVelocityAndForce) {
  const Placed patch(Rectangle::of_sides(2, 1), PlanarFrame{0, 0, pi / 2});
  const Rectangle lying = Rectangle::of_sides(2, 1), standing = Rectangle::of_sides(1, 2);
  for (const Twist& v : {Twist{0.3, -0.1, 1}, Twist{2, 1, -1}, Twist{1, 2, 0}}) {
    const Wrench g = patch.gradient({-v.vy, v.vx, v.w}), h = lying.gradient(v);
    EXPECT_NEAR(g.fx, -h.fy, 1e-15);
    EXPECT_NEAR(g.fy, h.fx, 1e-15);
    EXPECT_NEAR(g.m, h.m, 1e-15);
    EXPECT_NEAR(patch.gradient(v).fx, standing.gradient(v).fx, 1e-15);
    EXPECT_NEAR(patch.gradient(v).m, standing.gradient(v).m, 1e-15);
  }
}

TEST(Placed, ATurnAndBackIsNone) {
  const Polygon plain = l_shape.patch();
  const Placed patch(Placed(plain, PlanarFrame{0, 0, 0.7}), PlanarFrame{0, 0, -0.7});
  for (const Twist& v : {Twist{0.3, -0.1, 1}, Twist{2, 1, -1}, Twist{1, 2, 0}}) {
    const Wrench g = patch.gradient(v), h = plain.gradient(v);
    EXPECT_NEAR(g.fx, h.fx, 1e-15);
    EXPECT_NEAR(g.fy, h.fy, 1e-15);
    EXPECT_NEAR(g.m, h.m, 1e-15);
  }
  EXPECT_NEAR(patch.moments().x, plain.moments().x, 1e-16);
  EXPECT_NEAR(patch.moments().y, plain.moments().y, 1e-16);
}

TEST(Placed, TurnsAboutItsOwnOriginBeforeItIsMoved) {
  const Polygon plain = l_shape.patch();
  const Placed patch(plain, PlanarFrame{3, 4, 0.7});
  const PressureMoments s = plain.moments(), t = patch.moments();
  EXPECT_NEAR(t.x, 3 + s.x * std::cos(0.7) - s.y * std::sin(0.7), 1e-15);
  EXPECT_NEAR(t.y, 4 + s.x * std::sin(0.7) + s.y * std::cos(0.7), 1e-15);
  EXPECT_EQ(t.polar, s.polar);
}

TEST(Placed, AtTheOriginChangesNothing) {
  const HertzDisc disc = HertzDisc::of_radius(0.3);
  const Placed<HertzDisc> placed(disc, PlanarFrame{});
  for (const Twist& v : {Twist{0.1, 0.2, 1}, Twist{1, 0, 0}, Twist{0, 0, -2}}) {
    const Wrench g = disc.gradient(v), h = placed.gradient(v);
    EXPECT_TRUE(g.fx == h.fx && g.fy == h.fy && g.m == h.m);
    EXPECT_EQ(disc.dissipation(v), placed.dissipation(v));
  }
}

TEST(Placed, TwiceIsPlacedAtTheSum) {
  const Placed twice(Placed(HertzDisc::of_radius(0.5), 1, -2), 0.25, 0.5);
  const Placed once(HertzDisc::of_radius(0.5), 1.25, -1.5);
  const Twist v{0.3, -0.1, 0.9};
  EXPECT_NEAR(twice.gradient(v).fx, once.gradient(v).fx, 1e-15);
  EXPECT_NEAR(twice.gradient(v).fy, once.gradient(v).fy, 1e-15);
  EXPECT_NEAR(twice.gradient(v).m, once.gradient(v).m, 4e-15);
  EXPECT_EQ(twice.moments().x, once.moments().x);
  EXPECT_EQ(twice.moments().y, once.moments().y);
}

TEST(Placed, ATranslationHasTheMomentOfItsPlace) {
  const Placed patch(Ring::of_radius(1), 3, 5);
  const Wrench g = patch.gradient({0, 2, 0});
  EXPECT_NEAR(g.fy, 1, 1e-15);
  EXPECT_NEAR(g.m, 3, 3e-15);
}

TEST(Placed, HessianEqualsDifferencesOfTheExactGradient) {
  const PowerFamily<Real50> family(1);
  const Placed patch(HertzDisc::of_radius(0.5), 1.5, -2);
  const auto gradient = in_frame(disc_gradient(family, 0.5), {1.5, -2, 0});
  for (const Twist& v :
       {twist_about({1.7, -1.9}, 1), twist_about({0, 0}, -2), twist_about({30, 10}, 1), Twist{1, 2, 0}}) {
    const Hessian exact = hessian_by_differences(gradient, v, 2.5);
    EXPECT_LE(scaled_difference(patch.hessian(v), exact, v, 2.5), 4e-15 * scaled_size(exact, v, 2.5));
    EXPECT_LE(along_itself(patch.hessian(v), v, 2.5), 4e-15 * scaled_size(exact, v, 2.5));
  }
}

TEST(Placed, AtRestItAnswersTheLeastSubgradientAndHasNoHessian) {
  const Placed patch(HertzDisc::of_radius(1), 3, 4);
  const BoundedWrench g = patch.bounded_gradient({});
  EXPECT_TRUE(g.value.fx == 0 && g.value.fy == 0 && g.value.m == 0);
  EXPECT_EQ(g.force_error, 0);
  EXPECT_EQ(g.moment_error, 0);
  EXPECT_EQ(patch.dissipation({}), 0);
  EXPECT_THROW(patch.hessian({}), std::domain_error);
}

TEST(Placed, MomentsMoveWithIt) {
  const PressureMoments s = Placed(HertzDisc::of_radius(0.5), 3, -4).moments();
  EXPECT_EQ(s.x, 3);
  EXPECT_EQ(s.y, -4);
  EXPECT_EQ(s.polar, HertzDisc::of_radius(0.5).moments().polar);
  EXPECT_EQ(Placed(HertzDisc::of_radius(0.5), 3, -4).area_radius(), 0.5);
}

TEST(Placed, PlacesThatAreNotFiniteAreRefused) {
  const auto at = [](double x, double y) { return [=] { Placed(HertzDisc::of_radius(1), x, y); }; };
  EXPECT_THAT(at(nan, 0), ThrowsMessage<std::invalid_argument>("centre_x = nan is not allowed: must be finite"));
  EXPECT_THAT(
      [] {
        Placed(HertzDisc::of_radius(1), PlanarFrame{0, 0, nan});
      },
      ThrowsMessage<std::invalid_argument>("angle = nan is not allowed: must be finite"));
  EXPECT_THAT(at(0, -infinity), ThrowsMessage<std::invalid_argument>("centre_y = -inf is not allowed: must be finite"));
}

}  // namespace
}  // namespace patchgrip::friction
