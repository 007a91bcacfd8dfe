// The grip of least squares: the table, its laws, and what it proves next to the boundary.
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/tests/grasp/grasp_table.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

using Class = GraspDraws::Class;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

TEST(QuadraticGrip, Table) {
  for (const json& c : cases_of("min_quadratic")) {
    SCOPED_TRACE(c["id"].get<std::string>());
    const json& result = c["result"];
    Grasp grasp(contacts(c["grasp"]));
    const Vector6 load = vector6(c["load"]);
    const GripAnswer& a = grasp.least_quadratic_grip(load, number(c["epsilon"]), number(c["length"]));
    const double value = number(result["value"]);
    EXPECT_EQ(a.verdict, Verdict::holds);
    // Forces balance to rounding, which costs |W| each.
    double forces = 0, reach = 0;
    for (const ContactAnswer& k : a.contacts) forces += k.normal_force;
    for (const Contact& k : grasp.contacts()) reach = std::max(reach, k.position().norm());
    const double steep = std::hypot(a.escape_twist.head<3>().norm(), reach * a.escape_twist.tail<3>().norm());
    const double tolerance = std::max(1e-12 * value, 8 * epsilon * forces * steep);
    EXPECT_NEAR(a.value, value, 1e-12 * value);
    EXPECT_LE(a.lower, value * (1 + 4 * epsilon));
    EXPECT_GE(a.upper, value * (1 - 4 * epsilon));
    EXPECT_LE(a.upper - a.lower, tolerance);
    EXPECT_NEAR(load.dot(a.escape_twist), 2 * value, 1e-11 * value);
    for (std::size_t i = 0; i < a.contacts.size(); ++i) {
      EXPECT_NEAR(a.contacts[i].normal_force, number(result["F_n"][i]), 1e-9 * std::sqrt(value));
    }
  }
}

TEST(QuadraticGrip, ClosesItsBracket) {
  for (const DrawnGrasp& g : held_grasps(41, 60)) {
    Grasp grasp(g.made());
    for (const double eps : {1e-3, 1., 1e3}) {
      const GripAnswer& a = grasp.least_quadratic_grip(g.load, eps, 0.01);
      EXPECT_EQ(a.verdict, Verdict::holds);
      EXPECT_LE(a.lower, a.upper);
      EXPECT_LE(a.upper - a.lower, 1e-10 * a.upper) << eps;
    }
  }
}

TEST(QuadraticGrip, GrowsWithTheSquareOfTheLoad) {
  for (const DrawnGrasp& g : held_grasps(42, 30)) {
    Grasp grasp(g.made());
    const double q = grasp.least_quadratic_grip(g.load, 0.5, 0.01).value;
    for (const double k : {1e-6, 3., 1e6}) {
      EXPECT_NEAR(grasp.least_quadratic_grip(k * g.load, 0.5, 0.01).value, k * k * q, 1e-10 * k * k * q);
    }
  }
}

// Its largest force is no less than the least grip, its sum of squares no more than that of the forces of the least grip.
TEST(QuadraticGrip, LiesBetweenOtherGrips) {
  for (const DrawnGrasp& g : held_grasps(43, 40)) {
    Grasp grasp(g.made());
    const double eps = 0.1, length = 0.01;
    const GripAnswer most = grasp.least_grip(g.load);
    double squares = 0;
    for (const ContactAnswer& c : most.contacts) {
      const Vector3 t(c.friction[0], c.friction[1], c.friction[2] / length);
      squares += c.normal_force * c.normal_force + eps * t.squaredNorm();
    }
    const GripAnswer& a = grasp.least_quadratic_grip(g.load, eps, length);
    double largest = 0;
    for (const ContactAnswer& c : a.contacts) largest = std::max(largest, c.normal_force);
    EXPECT_LE(a.value, squares * (1 + 1e-11));
    EXPECT_GE(largest, most.lower * (1 - 1e-9));
  }
}

// d value / d w = W, by central differences, where the grasp resists every twist.
TEST(QuadraticGrip, TheTwistIsItsSlope) {
  GraspDraws draws(44);
  for (const DrawnGrasp& g : held_grasps(45, 30)) {
    if (g.contacts.size() < 4) continue;
    Grasp grasp(g.made());
    const Vector6 step = 1e-5 * g.load.norm() * draws.load().normalized();
    const GripAnswer beyond = grasp.least_quadratic_grip(g.load + step, 1, 0.01);
    const GripAnswer before = grasp.least_quadratic_grip(g.load - step, 1, 0.01);
    const GripAnswer& a = grasp.least_quadratic_grip(g.load, 1, 0.01);
    ASSERT_EQ(beyond.verdict, Verdict::holds);
    ASSERT_EQ(before.verdict, Verdict::holds);
    const double slope = (beyond.value - before.value) / 2;
    EXPECT_NEAR(a.escape_twist.dot(step), slope, 1e-4 * step.norm() * a.escape_twist.norm());
  }
}

TEST(QuadraticGrip, SaysWhatCannotBeHeld) {
  GraspDraws draws(46);
  for (int i = 0; i < testing::cases(30); ++i) {
    const DrawnGrasp g = draws.draw(Class::outside);
    Grasp grasp(g.made());
    EXPECT_EQ(grasp.least_quadratic_grip(g.load, 1, 0.01).verdict, Verdict::cannot_hold);
  }
}

TEST(QuadraticGrip, RefusesWeightsThatCannotBe) {
  Grasp grasp(contacts("tripod_point"));
  const Vector6 load = Vector6::Unit(2);
  for (const double bad : {0., -1., std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(grasp.least_quadratic_grip(load, bad, 1), std::invalid_argument);
    EXPECT_THROW(grasp.least_quadratic_grip(load, 1, bad), std::invalid_argument);
  }
}

}  // namespace
}  // namespace patchgrip::grasp
