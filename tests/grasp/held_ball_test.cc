// Ferrari and Canny's ball: the table, bounds that hold, and its laws.
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/grasp/held_ball.h>
#include <patchgrip/tests/grasp/grasp_table.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

bool is_planar(const json& c) {
  for (const json& g : grasp_table()["grasps"]) {
    if (g["id"] == c["grasp"]) return g.contains("space");
  }
  return false;
}

TEST(HeldBall, Table) {
  for (const auto& [problem, measure] :
       {std::pair{"epsilon_l1", GripMeasure::total_force}, std::pair{"epsilon_linf", GripMeasure::largest_force}}) {
    for (const json& c : cases_of(problem)) {
      SCOPED_TRACE(c["id"].get<std::string>());
      const double value = number(c["result"]["value"]);
      const HeldBall ball = held_ball(contacts(c["grasp"]), measure, number(c["length"]),
                                      {.relative_width = 0.1, .max_simplices = 20000, .planar = is_planar(c)});
      EXPECT_NEAR(ball.upper, value, 1e-12 * value);
      EXPECT_GE(ball.upper, value * (1 - 1e-15));
      EXPECT_LE(ball.lower, value);
      EXPECT_GT(ball.lower, 0.3 * value);
    }
  }
}

TEST(HeldBall, MeetsInThePlane) {
  const json c = cases_of("epsilon_linf")[1];
  ASSERT_TRUE(is_planar(c));
  const HeldBall ball = held_ball(contacts(c["grasp"]), GripMeasure::largest_force, number(c["length"]),
                                  {.relative_width = 1e-3, .planar = true});
  EXPECT_GE(ball.lower, (1 - 1e-3) * ball.upper);
}

// No load of size `lower` needs more than a grip of 1; the one of size `upper` in the weakest direction does.
TEST(HeldBall, LoadsWithinAreHeld) {
  GraspDraws draws(51);
  for (const char* id : {"tripod_uniform", "form_closure_7"}) {
    const auto k = contacts(id);
    const double length = 0.03;
    const HeldBall ball = held_ball(k, GripMeasure::largest_force, length, {.max_simplices = 5000});
    ASSERT_GT(ball.lower, 0) << id;
    Grasp grasp(k);
    for (int i = 0; i < 200; ++i) {
      Vector6 w = spatial(draws.vector(), length * draws.vector());
      w /= std::hypot(w.head<3>().norm(), w.tail<3>().norm() / length);
      EXPECT_LE(grasp.least_grip(ball.lower * w).lower, 1) << id;
    }
    EXPECT_GE(grasp.least_grip(ball.upper * ball.load).upper, 1 - 1e-9) << id;
  }
}

TEST(HeldBall, IsNoneWithoutForceClosure) {
  for (const char* id : {"form_closure_6", "pinch_point"}) {
    const HeldBall ball = held_ball(contacts(id), GripMeasure::total_force, 0.03, {.max_simplices = 100});
    EXPECT_EQ(ball.lower, 0) << id;
    EXPECT_LE(ball.upper, 1e-9) << id;
  }
}

TEST(HeldBall, RefusesWhatCannotBe) {
  const auto k = contacts("tripod_point");
  EXPECT_THROW(held_ball(k, GripMeasure::total_force, 0), std::invalid_argument);
  EXPECT_THROW(held_ball(k, GripMeasure::total_force, 1, {.relative_width = 0}), std::invalid_argument);
  EXPECT_THROW(held_ball(k, GripMeasure::total_force, 1, {.relative_width = 1}), std::invalid_argument);
  EXPECT_THROW(held_ball(k, GripMeasure::total_force, 1, {.max_simplices = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::grasp
