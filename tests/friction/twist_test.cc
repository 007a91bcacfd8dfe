#include <patchgrip/friction/twist.h>

#include <gtest/gtest.h>

namespace patchgrip::friction {
namespace {

struct Velocity {
  double x, y;
};

Velocity at(double x, double y, const Twist& v) { return {v.vx - v.w * y, v.vy + v.w * x}; }

TEST(Twist, AboutAPoleLeavesThePoleAtRest) {
  for (const double spin : {1.0, -1.0, 0.3, -1e6}) {
    for (const Pole& pole : {Pole{0.2, -0.7}, Pole{0, 0}, Pole{-3e8, 1e-12}}) {
      const Velocity v = at(pole.x, pole.y, twist_about(pole, spin));
      EXPECT_EQ(v.x, 0);
      EXPECT_EQ(v.y, 0);
    }
  }
}

TEST(Twist, WithPositiveSpinTurnsCounterClockwiseAboutItsPole) {
  constexpr Twist v = twist_about({1, 0}, 2);
  static_assert(v.vx == 0 && v.vy == -2 && v.w == 2);
  const Velocity to_the_right = at(2, 0, v);
  EXPECT_EQ(to_the_right.x, 0);
  EXPECT_EQ(to_the_right.y, 2);
}

TEST(Twist, IsAtRestByDefault) {
  constexpr Twist v;
  static_assert(v.vx == 0 && v.vy == 0 && v.w == 0);
  EXPECT_EQ(power({1, 2, 3}, v), 0);
}

TEST(Power, OfAForceIsThatOfThePointItActsOn) {
  constexpr double x = 0.25, y = -0.5, fx = 3, fy = -7;
  constexpr Wrench force_at_point{fx, fy, x * fy - y * fx};
  constexpr Twist v{0.5, 0.125, -2};
  const Velocity point = at(x, y, v);
  EXPECT_EQ(power(force_at_point, v), fx * point.x + fy * point.y);
}

TEST(Power, OfACoupleDependsOnTheSpinAlone) { EXPECT_EQ(power({0, 0, 4}, {10, 20, 0.5}), 2); }

}  // namespace
}  // namespace patchgrip::friction
