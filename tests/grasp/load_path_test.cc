#include <cmath>

#include <gtest/gtest.h>

#include <patchgrip/grasp/load_path.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

Vector6 direction() { return (Vector6() << 1, -2, 3, 0.5, 0, 1).finished().normalized(); }

TEST(LoadPath, LeadsToWhereItCameFromAtFirst) {
  LoadPath path(2);
  path.add(direction()) << 3, -4;
  EXPECT_EQ(path.lead(2 * direction()), Eigen::Vector2d(3, -4));
}

TEST(LoadPath, ContinuesPolynomialsOfDegreeFourInUnevenSteps) {
  LoadPath path(2);
  const auto solution = [](double t) { return Eigen::Vector2d(1 + t * (2 - t * (3 - t * (0.5 + t))), t * t - 7); };
  for (const double t : {-4., -2., 0., 0.3, 1., 1.2, 1.5}) path.add(t * direction()) = solution(t);
  EXPECT_LE((path.lead(1.7 * direction()) - solution(1.7)).norm(), 1e-14 * solution(1.7).norm());
}

TEST(LoadPath, OfAnArcEachPointMoreTakesOffAPowerOfTheStep) {
  const auto load = [](double angle) {
    return Vector6(std::cos(angle) * Vector6::Unit(0) + std::sin(angle) * Vector6::Unit(4));
  };
  const double h = 0.01;
  LoadPath path(1);
  for (int k = 0; k < 5; ++k) {
    path.add(load(k * h)) << std::exp(k * h);
    const double size = std::exp((k + 1) * h), error = std::fabs(path.lead(load((k + 1) * h))[0] - size);
    EXPECT_LE(error, 1.1 * size * std::pow(h, k + 1)) << k;
    EXPECT_GE(error, 0.9 * size * std::pow(h, k + 1)) << k;
  }
}

TEST(LoadPath, LeavesTheLastAloneWhereItTurnsBack) {
  LoadPath path(1);
  for (int k = 0; k < 5; ++k) path.add(k * direction()) << k;
  EXPECT_EQ(path.lead(3 * direction())[0], 4);
}

TEST(LoadPath, StandsStillWithTheLoad) {
  LoadPath path(1);
  for (const double x : {1., 2., 3.}) path.add(direction()) << x;
  EXPECT_EQ(path.lead(direction())[0], 3);
}

TEST(LoadPath, HasForgottenWhatItIsToldToForget) {
  LoadPath path(1);
  path.add(direction()) << 1;
  path.add(2 * direction()) << 2;
  path.forget();
  path.add(3 * direction()) << 7;
  EXPECT_EQ(path.lead(4 * direction())[0], 7);
}

TEST(LoadPath, LeavesOutLoadsThatAreNextToEachOther) {
  LoadPath path(1);
  for (const double t : {0., 1e-12}) path.add(t * direction()) << 1 + t + 1e-13 * (t > 0);
  EXPECT_NEAR(path.lead(1e-3 * direction())[0], 1, 1e-11);
}

TEST(LoadPath, SavesStepsOfNewton) {
  int loads = 0, warm = 0, steps = 0, from_the_last_alone = 0;
  for (const DrawnGrasp& g : held_grasps(13, 20)) {
    Grasp grasp(g.made()), alone(g.made());
    grasp.least_grip(g.load);
    Vector6 before = g.load;
    for (int k = 1; k <= 20; ++k) {
      const Matrix3 Q = Eigen::AngleAxisd(0.003 * k, Vector3(1, 2, 3).normalized()).toRotationMatrix();
      const Vector6 load = spatial(Q * g.load.head<3>(), Q * g.load.tail<3>());
      const Effort& effort = grasp.next_least_grip(load).effort;
      alone.least_grip(before);
      before = load;
      const Effort& effort_alone = alone.next_least_grip(load).effort;
      ++loads;
      if (effort.route != Route::warm || effort_alone.route != Route::warm) continue;
      ++warm;
      steps += effort.newton_steps;
      from_the_last_alone += effort_alone.newton_steps;
    }
  }
  EXPECT_GE(warm, 0.9 * loads);
  EXPECT_LE(steps, 0.7 * from_the_last_alone);
}

}  // namespace
}  // namespace patchgrip::grasp
