#include <patchgrip/cli/scene/motions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <patchgrip/cli/scene/direction.h>
#include <patchgrip/friction/twist.h>

#include "scenes.h"

namespace patchgrip::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::Pair;

constexpr double infinity = std::numeric_limits<double>::infinity();

Motions motions_of(const std::string& poles) {
  return test::scene_of(test::with(test::good_disc, "list = [[0.001, 0.002], [0, 0]]", poles)).motions;
}

std::vector<std::pair<double, double>> poles_of(const Motions& motions) {
  std::vector<std::pair<double, double>> poles;
  for (std::size_t i = 0; i < motions.size(); ++i) poles.emplace_back(motions[i].pole.x, motions[i].pole.y);
  return poles;
}

TEST(Motions, InAGridXRunsFastest) {
  EXPECT_THAT(poles_of(motions_of("grid = { x = [1, 2], y = { from = -1, to = 1, count = 3 } }")),
              ElementsAre(Pair(1, -1), Pair(2, -1), Pair(1, 0), Pair(2, 0), Pair(1, 1), Pair(2, 1)));
}

TEST(Motions, ARayAlongAVectorIsExact) {
  EXPECT_THAT(poles_of(motions_of("ray = { from = [1, 2], direction = [0, 7], distance = [0, 0.5] }")),
              ElementsAre(Pair(1, 2), Pair(1, 2.5)));
}

TEST(Motions, ManyAnglesAtOneDistanceAreACircle) {
  const Motions circle = motions_of("ray = { angle = { from = -3, to = 3, count = 100 }, distance = 0.25 }");
  ASSERT_EQ(circle.size(), 100U);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    EXPECT_NEAR(std::hypot(circle[i].pole.x, circle[i].pole.y), 0.25, 1e-16);
    EXPECT_NEAR(std::atan2(circle[i].pole.y, circle[i].pole.x), -3 + static_cast<double>(i) * 6 / 99, 1e-14);
  }
}

// No double is pi/2; from 0 to 2 pi in eighths the multiples are rounded once more.
TEST(Motions, TranslationsAlongTheAxesHaveTheirPolesOnTheAxes) {
  const std::vector<std::pair<double, double>> all =
      poles_of(motions_of("translation = { angle = { from = 0, to = 6.283185307179586, count = 9 } }"));
  EXPECT_THAT(all, ElementsAre(Pair(0, infinity), Pair(-infinity, infinity), Pair(-infinity, 0),
                               Pair(-infinity, -infinity), Pair(0, -infinity), Pair(infinity, -infinity),
                               Pair(infinity, 0), Pair(infinity, infinity), Pair(0, infinity)));
  const Motions up = motions_of("translation = { angle = [1.5707963267948966, -4.71238898038469, 1.5707963] }");
  for (const std::size_t exact : {0U, 1U}) {
    EXPECT_EQ(up[exact].twist.vx, 0);
    EXPECT_EQ(up[exact].twist.vy, 1);
  }
  EXPECT_NEAR(up[2].twist.vx, 2.68e-8, 1e-10);  // of eight digits it is not known what they mean
}

TEST(Direction, IsCosineAndSine) {
  for (int i = -100000; i <= 100000; ++i) {
    const double angle = 0.01 * i;
    const Direction along = direction_at(angle);
    EXPECT_NEAR(along.x, std::cos(angle), 0x1p-51 * std::fabs(angle));
    EXPECT_NEAR(along.y, std::sin(angle), 0x1p-51 * std::fabs(angle));
  }
  for (int quarters = -600; quarters <= 600; ++quarters) {
    if (quarters == 0) continue;
    const double angle = quarters * (std::numbers::pi / 2);
    for (const double near : {angle, std::nextafter(angle, infinity), std::nextafter(angle, -infinity)}) {
      const Direction along = direction_at(near);
      const double sign = (quarters & 2) == 0 ? 1 : -1;
      EXPECT_EQ(along.x, quarters % 2 == 0 ? sign : 0) << quarters;
      EXPECT_EQ(along.y, quarters % 2 == 0 ? 0 : sign) << quarters;
    }
  }
}

TEST(Motions, SetsFollowOneAnotherAndTranslationsComeLast) {
  const Motions motions = motions_of(
      "list = [[5, 6]]\ngrid = { x = 1, y = 2 }\ntranslation = { direction = [1, 0] }\n"
      "ray = { direction = [1, 0], distance = 9 }");
  EXPECT_THAT(poles_of(motions), ElementsAre(Pair(1, 2), Pair(9, 0), Pair(5, 6), Pair(0, infinity)));
}

TEST(Motions, EveryPoleIsPassedInBothSensesAtEverySpeed) {
  const Motions motions = motions_of("list = [[1, 2]]\nspin = [1, -1]\nangular_speed = [3, 5]");
  ASSERT_EQ(motions.size(), 4U);
  EXPECT_EQ(motions[0].twist.w, 3);
  EXPECT_EQ(motions[1].twist.w, 5);
  EXPECT_EQ(motions[2].twist.w, -3);
  EXPECT_EQ(motions[3].twist.w, -5);
  EXPECT_EQ(motions[3].spin, -1);
}

TEST(Motions, ThePoleStandsStill) {
  const Motions motions = motions_of("grid = { x = [0.5, -2], y = [0.25, 3] }\nspin = -1\nangular_speed = 4");
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto [pole, spin, speed, v] = motions[i];
    EXPECT_EQ(v.vx - v.w * pole.y, 0);
    EXPECT_EQ(v.vy + v.w * pole.x, 0);
  }
}

TEST(Motions, TranslationsHaveTheirPoleAtInfinityAcrossTheVelocity) {
  const Motions motions = motions_of("translation = { direction = [[1, 0], [0, 2], [-3, 4]] }\nspeed = 10");
  ASSERT_EQ(motions.size(), 3U);
  EXPECT_THAT(poles_of(motions), ElementsAre(Pair(0, infinity), Pair(-infinity, 0), Pair(-infinity, -infinity)));
  EXPECT_EQ(motions[0].spin, 0);
  EXPECT_EQ(motions[0].twist.vx, 10);
  EXPECT_EQ(motions[1].twist.vy, 10);
  EXPECT_EQ(motions[2].twist.vx, -6);
  EXPECT_EQ(motions[2].twist.vy, 8);
  EXPECT_EQ(motions[2].twist.w, 0);
}

TEST(Motions, AVeryLargeTableTakesNoMemory) {
  const Motions motions =
      motions_of("grid = { x = { from = 0, to = 1, count = 10000 }, y = { from = 0, to = 1, count = 10000 } }");
  EXPECT_EQ(motions.size(), 100'000'000U);
  EXPECT_EQ(motions[99'999'999].pole.x, 1);
}

}  // namespace
}  // namespace patchgrip::cli
