// The worst of a set of loads: closed forms, the table, the ball of Ferrari and Canny, and sets that are not held.
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/grasp/worst_load.h>
#include <patchgrip/tests/grasp/grasp_table.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

// Two points with mu, opposite on the x-axis: a force f at the origin asks for |f_x| + |(f_y, f_z)| / (2 mu).
constexpr double mu = 0.4;
std::vector<Contact> pinch() {
  return {Contact({{0.03, 0, 0}, {1, 0, 0}, {}}, FrictionCone::point(mu)),
          Contact({{-0.03, 0, 0}, {-1, 0, 0}, {}}, FrictionCone::point(mu))};
}

Vector6 force(double x, double y, double z) { return spatial({x, y, z}, Vector3::Zero()); }

std::vector<Vector6> forces(double along, double across) {
  return {force(along, 0, 0), force(0, across, 0), force(0, 0, across)};
}

void expect_bracket(const WorstLoad& worst, double exact, double width) {
  EXPECT_EQ(worst.verdict, Verdict::holds);
  EXPECT_LE(worst.lower, exact * (1 + 1e-14));
  EXPECT_GE(worst.upper, exact * (1 - 1e-14));
  EXPECT_LE(worst.upper - worst.lower, width * worst.upper);
}

// Largest of |f_x| + |f_t| / (2 mu) over an ellipsoid about a weight across: h(W) of the normal W.
TEST(WorstLoad, OverAnEllipsoidOfForcesIsThatOfTheClosedForm) {
  for (const double along : {0.5, 1., 3.}) {
    for (const double weight : {0., 2.}) {
      const double exact = weight / (2 * mu) + std::hypot(along, 1 / (2 * mu));
      const WorstLoad worst = worst_grip(pinch(), {{force(0, 0, -weight)}, forces(along, 1)},
                                         GripMeasure::largest_force, {.relative_width = 1e-3});
      expect_bracket(worst, exact, 1e-3);
      EXPECT_NEAR(worst.lower, exact, 1e-12 * exact);  // the way up ends at the top
      EXPECT_NEAR(worst.answer.value, exact, 1e-12 * exact);
    }
  }
}

TEST(WorstLoad, AxesNeedNotBeOrthogonal) {
  // The same ellipsoid by conjugate semi-axes: any rotation of y.
  const auto axes = forces(3, 1);
  const double c = std::cos(0.7), s = std::sin(0.7);
  const WorstLoad worst =
      worst_grip(pinch(), {{force(0, 0, -2)}, {c * axes[0] + s * axes[1], c * axes[1] - s * axes[0], axes[2]}},
                 GripMeasure::largest_force, {.relative_width = 1e-3});
  expect_bracket(worst, 2 / (2 * mu) + std::hypot(3, 1 / (2 * mu)), 1e-3);
}

// Limits c: weight / (2 mu) + lambda h = c.
TEST(WorstLoad, FactorIsThatOfTheClosedForm) {
  const std::vector<double> limits{10, 10};
  const double exact = (10 - 2 / (2 * mu)) / std::hypot(3, 1 / (2 * mu));
  const WorstLoad worst =
      worst_load_factor(pinch(), force(0, 0, -2), {{force(0, 0, 0)}, forces(3, 1)}, limits, {.relative_width = 1e-3});
  expect_bracket(worst, exact, 1e-3);
  EXPECT_NEAR(worst.upper, exact, 1e-12 * exact);
  // Multiplied by that much the worst load is just held beside the weight.
  Grasp grasp(pinch());
  EXPECT_NEAR(grasp.holds_within(force(0, 0, -2) + exact * worst.load, limits).value, 1, 1e-12);
}

TEST(WorstLoad, FactorOfLoadsBesideOneThatIsNotHeld) {
  const std::vector<double> limits{1, 1};
  const WorstLoad worst = worst_load_factor(pinch(), force(0, 0, -2), {{force(1, 0, 0)}}, limits);
  EXPECT_EQ(worst.verdict, Verdict::cannot_hold);
  EXPECT_EQ(worst.load, force(0, 0, -2));
}

TEST(WorstLoad, OfAPolytopeIsAtACorner) {
  for (const json& c : cases_of("worst_case_vertices")) {
    LoadSet set;
    for (const json& w : c["loads"]) set.corners.push_back(vector6(w));
    const double exact = number(c["result"]["value"]);
    const WorstLoad worst = worst_grip(contacts(c["grasp"]), set, GripMeasure::largest_force);
    expect_bracket(worst, exact, 1e-12);
    EXPECT_NEAR(worst.lower, exact, 1e-12 * exact);
    EXPECT_EQ(worst.simplices, 0);
  }
}

// What is about the corners of a polytope is worst about one of them.
TEST(WorstLoad, OfAnEllipsoidAboutEachCornerIsTheLargestOfThem) {
  const std::vector<Vector6> corners{force(1, 0, -2), force(-1, 2, 0), force(0, 1, 1)};
  const WorstLoad all = worst_grip(pinch(), {corners, forces(0.2, 0.1)}, GripMeasure::total_force);
  double lower = 0, upper = 0;
  for (const Vector6& corner : corners) {
    const WorstLoad one = worst_grip(pinch(), {{corner}, forces(0.2, 0.1)}, GripMeasure::total_force);
    lower = std::max(lower, one.lower);
    upper = std::max(upper, one.upper);
  }
  EXPECT_NEAR(all.lower, lower, 1e-12 * lower);
  EXPECT_LE(all.upper, lower / (1 - 0.01) * (1 + 1e-12));
  EXPECT_LE(all.lower, upper);
}

// 1 / eps of a ball about no load, and the least grip never falls short of its bounds.
TEST(WorstLoad, OfABallIsOneOverTheHeldBall) {
  for (const auto& [problem, measure] :
       {std::pair{"epsilon_l1", GripMeasure::total_force}, std::pair{"epsilon_linf", GripMeasure::largest_force}}) {
    for (const json& c : cases_of(problem)) {
      if (c["grasp"] != "tripod_point") continue;
      const double eps = number(c["result"]["value"]);
      const LoadSet ball = LoadSet::ball(Vector6::Zero(), 2, number(c["length"]));
      const WorstLoad worst =
          worst_grip(contacts(c["grasp"]), ball, measure, {.relative_width = 0.1, .max_simplices = 300});
      expect_bracket(worst, 2 / eps, 1);
      EXPECT_NEAR(worst.lower, 2 / eps, 1e-12 / eps);
      EXPECT_LE(worst.upper, 4 * worst.lower);
    }
  }
}

TEST(WorstLoad, NoLoadOfTheSetAsksForMore) {
  GraspDraws draws(52);
  for (const char* id : {"tripod_uniform", "form_closure_7"}) {
    const auto k = contacts(id);
    LoadSet set{{draws.load(), draws.load()}};
    for (int j = 0; j < 3; ++j) set.axes.push_back(0.5 * draws.load());
    const WorstLoad worst = worst_grip(k, set, GripMeasure::largest_force, {.relative_width = 0.02});
    ASSERT_EQ(worst.verdict, Verdict::holds) << id;
    EXPECT_LE(worst.upper - worst.lower, 0.02 * worst.upper) << id;
    Grasp grasp(k);
    EXPECT_NEAR(grasp.least_grip(worst.load).value, worst.answer.value, 1e-12 * worst.upper);
    for (int i = 0; i < 300; ++i) {
      const double b = draws.uniform(0, 1);
      Vector6 w = b * set.corners[0] + (1 - b) * set.corners[1];
      const Vector3 y = std::cbrt(draws.uniform(0, 1)) * draws.vector().normalized();
      for (int j = 0; j < 3; ++j) w += y[j] * set.axes[static_cast<std::size_t>(j)];
      EXPECT_LE(grasp.least_grip(w).lower, worst.upper) << id;
    }
  }
}

// Nothing but its weight of 3 N keeps a box on three supports, of which the nearest edge is 10 mm beside the middle and
// 30 mm from the third: moments of size M ask that one for 1 N + M / 30 mm, and 30 mN m overturn the box.
TEST(WorstLoad, IsFoundWhereOnlyTheWeightHolds) {
  const auto table = contacts("table_3");
  const auto tilted = [&](double moment) {
    const LoadSet set{{force(0, 0, -3)}, {moment * Vector6::Unit(3), moment * Vector6::Unit(4)}};
    return worst_grip(table, set, GripMeasure::largest_force, {.relative_width = 1e-3});
  };
  expect_bracket(tilted(0.027), 1.9, 1e-3);
  EXPECT_EQ(tilted(0.031).verdict, Verdict::cannot_hold);
}

// Two points cannot hold a moment about their line.
TEST(WorstLoad, ThatCannotBeHeldIsShown) {
  const WorstLoad worst = worst_grip(pinch(), LoadSet::ball(force(0, 0, -1), 0.1, 0.03), GripMeasure::largest_force);
  EXPECT_EQ(worst.verdict, Verdict::cannot_hold);
  EXPECT_EQ(worst.answer.verdict, Verdict::cannot_hold);
  EXPECT_GT(worst.load.dot(worst.answer.escape_twist), 0);
  for (const Contact& c : pinch()) {
    const friction::Twist v = c.sliding(worst.answer.escape_twist);
    EXPECT_LE(-c.opening(worst.answer.escape_twist) + mu * std::hypot(v.vx, v.vy),
              1e-12 * worst.answer.escape_twist.norm());
  }
}

TEST(WorstLoad, RefusesWhatCannotBe) {
  const LoadSet one{{force(0, 0, 1)}};
  const auto grip = [&](const LoadSet& set, const WorstLoadSettings& settings = {}) {
    return worst_grip(pinch(), set, GripMeasure::total_force, settings);
  };
  EXPECT_NO_THROW(grip(one));
  EXPECT_THROW(grip({}), std::invalid_argument);
  EXPECT_THROW(grip({{force(0, 0, NAN)}}), std::invalid_argument);
  EXPECT_THROW(grip({{force(0, 0, 1)}, {force(INFINITY, 0, 0)}}), std::invalid_argument);
  EXPECT_THROW(grip({{force(0, 0, 1)}, std::vector<Vector6>(7, force(1, 0, 0))}), std::invalid_argument);
  EXPECT_THROW(grip(one, {.relative_width = 0}), std::invalid_argument);
  EXPECT_THROW(grip(one, {.max_simplices = -1}), std::invalid_argument);
  EXPECT_THROW(LoadSet::ball(force(0, 0, 1), 0, 1), std::invalid_argument);
  EXPECT_THROW(LoadSet::ball(force(0, 0, 1), 1, -1), std::invalid_argument);
  EXPECT_THROW(worst_load_factor(pinch(), force(0, 0, 0), one, std::vector<double>{1}), std::invalid_argument);
  EXPECT_THROW(worst_load_factor(pinch(), force(0, 0, 0), one, std::vector<double>{1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::grasp
