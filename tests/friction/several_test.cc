#include <patchgrip/friction/several.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/friction/any_patch.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/motions.h>

namespace patchgrip::friction {
namespace {

using std::numbers::pi;
using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Force and moment over `lever` nowhere further apart than `tolerance`.
void expect_near(const Wrench& a, const Wrench& b, double tolerance, double lever = 1) {
  EXPECT_LE(std::hypot(a.fx - b.fx, a.fy - b.fy), tolerance);
  EXPECT_LE(std::fabs(a.m - b.m), tolerance * lever);
}

void expect_same(const Wrench& a, const Wrench& b) { EXPECT_TRUE(a.fx == b.fx && a.fy == b.fy && a.m == b.m); }

// Two halves of a rectangle 4 by 1, the right one turned upside down.
Several two_halves(double share = 0.5, double mu_left = 1, double mu_right = 1) {
  const Rectangle half = Rectangle::of_sides(2, 1);
  return Several::of_parts(
      {{Placed(half, -1, 0), share, mu_left}, {Placed(half, PlanarFrame{1, 0, pi}), 1 - share, mu_right}});
}

const std::vector<Twist> motions{{0, 0, 1},    {0.2, 0.1, 1}, {1, 0.5, -1}, {0, 1, 1}, {0, 2, 1},
                                 {3, -1, 0.7}, {40, 70, 1},   {1e6, 1, -1}, {1, 2, 0}, {0, 0, 0}};

TEST(Several, TwoHalvesOfARectangleAreTheWhole) {
  const Rectangle whole = Rectangle::of_sides(4, 1);
  const Several halves = two_halves();
  for (const Twist& v : motions) {
    expect_near(halves.gradient(v), whole.gradient(v), 1e-15, 2);
    EXPECT_NEAR(halves.dissipation(v), whole.dissipation(v), 1e-15 * speed_of(v, 2));
  }
  for (const Twist& v : {Twist{0.2, 0.1, 1}, Twist{3, -1, 0.7}, Twist{40, 70, 1}}) {
    EXPECT_LE(scaled_difference(halves.hessian(v), whole.hessian(v), v, 2), 1e-14);
  }
  const PressureMoments s = halves.moments(), t = whole.moments();
  EXPECT_NEAR(s.x, t.x, 1e-16);
  EXPECT_NEAR(s.y, t.y, 1e-16);
  EXPECT_DOUBLE_EQ(s.polar, t.polar);
  EXPECT_DOUBLE_EQ(halves.area_radius(), whole.area_radius());
}

TEST(Several, APatchInOnePartIsItself) {
  for (const NamedPatch& p : every_patch()) {
    const Several one = std::visit([](const auto& patch) { return Several::of_parts({{patch, 7, 0.3}}); }, p.patch);
    for (const Twist& v : motions) {
      expect_same(one.gradient(v), p.gradient(v));
      EXPECT_EQ(one.dissipation(v), p.dissipation(v));
    }
    const PressureMoments s = one.moments(), t = p.moments();
    EXPECT_TRUE(s.x == t.x && s.y == t.y && s.polar == t.polar) << p.name;
    EXPECT_DOUBLE_EQ(one.area_radius(), p.area_radius());
    EXPECT_DOUBLE_EQ(one.resistance(), 7 * 0.3);
  }
}

RC_GTEST_PROP(Several, BearsTheSumOfWhatItsPartsBear, ()) {
  const double F[] = {*log_uniform(1e-3, 1e3), *log_uniform(1e-3, 1e3)};
  const double mu[] = {*log_uniform(1e-3, 10), *log_uniform(1e-3, 10)};
  const auto& patches = every_patch();
  const NamedPatch* p[2];
  for (auto& one : p) one = &patches[*rc::gen::inRange<std::size_t>(0, patches.size())];
  const auto any = [](const NamedPatch& q) { return std::visit([](const auto& x) { return AnyPatch(x); }, q.patch); };
  const Several both = Several::of_parts({{any(*p[0]), F[0], mu[0]}, {any(*p[1]), F[1], mu[1]}});
  const Twist v = *motion_of(*p[0]);
  const BoundedWrench t = friction_wrench(both, v);
  BoundedWrench sum;
  for (const int i : {0, 1}) {
    const auto part =
        std::visit([&](const auto& q) { return friction_wrench(Law::coulomb(mu[i]), F[i], q, v); }, p[i]->patch);
    sum.value = {sum.value.fx + part.value.fx, sum.value.fy + part.value.fy, sum.value.m + part.value.m};
    sum.force_error += part.force_error + 0x1p-52 * std::hypot(part.value.fx, part.value.fy);
    sum.moment_error += part.moment_error + 0x1p-52 * std::fabs(part.value.m);
  }
  RC_ASSERT(std::hypot(t.value.fx - sum.value.fx, t.value.fy - sum.value.fy) <= t.force_error + sum.force_error);
  RC_ASSERT(std::fabs(t.value.m - sum.value.m) <= t.moment_error + sum.moment_error);
  RC_ASSERT(power(t.value, v) <= 0);
}

TEST(Several, TheResistanceIsWhatATranslationMeets) {
  const Several parts = two_halves(0.25, 0.5, 2);
  EXPECT_DOUBLE_EQ(parts.resistance(), 0.25 * 0.5 + 0.75 * 2);
  EXPECT_DOUBLE_EQ(parts.normal_force(), 1);
  const BoundedWrench t = friction_wrench(parts, {3, 0, 0});
  EXPECT_NEAR(t.value.fx, -parts.resistance(), 1e-15);
  EXPECT_NEAR(parts.dissipation({3, 0, 0}), 3, 3e-15);
}

TEST(Several, MomentsAreThoseOfTheFrictionAndPressureMomentsThoseOfThePressure) {
  const Several parts = Several::of_parts({{Placed(PointLoad{}, -1, 0), 1, 3}, {Placed(PointLoad{}, 1, 0), 1, 1}});
  EXPECT_DOUBLE_EQ(parts.moments().x, -0.5);
  EXPECT_DOUBLE_EQ(parts.moments().polar, 0.75);
  EXPECT_EQ(parts.pressure_moments().x, 0);
  EXPECT_EQ(parts.pressure_moments().polar, 1);
}

TEST(Several, APartWithoutFrictionAddsPressureAlone) {
  const HertzDisc disc = HertzDisc::of_radius(0.1);
  const Several parts = Several::of_parts({{disc, 3, 0.5}, {Placed(disc, 5, 0), 1, 0}});
  const Twist v{0.3, 0.2, -1};
  expect_same(parts.gradient(v), disc.gradient(v));
  EXPECT_EQ(parts.moments().x, 0);
  EXPECT_DOUBLE_EQ(parts.pressure_moments().x, 1.25);
  EXPECT_EQ(parts.parts().size(), 2);
  // even where it would have no Hessian
  EXPECT_NO_THROW(Several::of_parts({{disc, 1, 1}, {Ring::of_radius(1), 1, 0}}).hessian({1, 0, 1}));
}

TEST(Several, OfSeveralIsAllOfThem) {
  const Several nested = Several::of_parts({{two_halves(), 2, 1}, {HertzDisc::of_radius(0.3), 1, 1}});
  const Several flat = Several::of_parts({{two_halves().parts()[0].patch, 1, 1},
                                          {two_halves().parts()[1].patch, 1, 1},
                                          {HertzDisc::of_radius(0.3), 1, 1}});
  for (const Twist& v : motions) expect_near(nested.gradient(v), flat.gradient(v), 1e-15, 2);
  EXPECT_NEAR(nested.moments().polar, flat.moments().polar, 1e-15);
}

TEST(Several, MirroredPartsMirrorTheWrench) {
  const auto at = [](double side) {
    return Several::of_parts({{Placed(Rectangle::of_sides(2, 1), PlanarFrame{side, 2, side * 0.3}), 2, 0.4},
                              {Placed(Ring::of_radius(0.5), side * 3, -1), 1, 0.7}});
  };
  for (const Twist& v : motions) {
    const Wrench g = at(1).gradient(v), h = at(-1).gradient({-v.vx, v.vy, -v.w});
    expect_near({-g.fx, g.fy, -g.m}, h, 2e-15, 4);
  }
}

// All pressure on one line: poles on it beyond the ends share one wrench, a ridge of the limit surface.
TEST(Several, TwoPointsHaveARidge) {
  const Several pair = Several::of_parts({{Placed(PointLoad{}, -1, 0), 1}, {Placed(PointLoad{}, 2, 0), 3}});
  const Wrench g = pair.gradient(twist_about({2.5, 0}, 1));
  expect_near(g, {0, -1, -1.25}, 1e-15);
  expect_same(pair.gradient(twist_about({1e3, 0}, 1)), g);
  // between them the points work against each other
  expect_near(pair.gradient(twist_about({0.5, 0}, 1)), {0, 0.5, 1.75}, 1e-15);
}

// With the pole on a point all forces of that point's friction disc are subgradients.
TEST(Several, APoleOnAPointLoadAnswersTheOthers) {
  const Several pair = Several::of_parts({{Placed(PointLoad{}, -1, 0), 1}, {Placed(PointLoad{}, 2, 0), 3}});
  expect_near(pair.gradient(twist_about({-1, 0}, 1)), {0, 0.75, 1.5}, 1e-15);
  EXPECT_THROW(pair.hessian(twist_about({-1, 0}, 1)), std::domain_error);
  EXPECT_NO_THROW(pair.hessian(twist_about({-1, 1e-9}, 1)));
}

TEST(Several, AtRestItAnswersTheLeastSubgradientAndHasNoHessian) {
  const BoundedWrench g = two_halves().bounded_gradient({});
  expect_same(g.value, {});
  EXPECT_EQ(g.force_error, 0);
  EXPECT_EQ(g.moment_error, 0);
  EXPECT_THROW(two_halves().hessian({}), std::domain_error);
}

TEST(Several, PartsThatAreNoneOrBearNothingAreRefused) {
  const auto with = [](double F, double mu) {
    return [=] { Several::of_parts({{PointLoad{}, 1}, {HertzDisc::of_radius(1), F, mu}}); };
  };
  EXPECT_THAT([] { Several::of_parts({}); },
              ThrowsMessage<std::invalid_argument>("parts = [] is not allowed: there must be at least one"));
  EXPECT_THAT(with(0, 1), ThrowsMessage<std::invalid_argument>(
                              "parts[1].normal_force = 0 is not allowed: must be positive and finite"));
  EXPECT_THROW(with(nan, 1)(), std::invalid_argument);
  EXPECT_THROW(with(infinity, 1)(), std::invalid_argument);
  EXPECT_THAT(with(1, -0.5), ThrowsMessage<std::invalid_argument>(
                                 "parts[1].mu = -0.5 is not allowed: must be non-negative and finite"));
  EXPECT_THROW(with(1, nan)(), std::invalid_argument);
  EXPECT_THROW(Several::of_parts({{PointLoad{}, 1, 0}, {PointLoad{}, 2, 0}}), std::invalid_argument);
  EXPECT_THROW(Several::of_parts({{PointLoad{}, 1e308, 1}, {PointLoad{}, 1e308, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
