// What holds of every grasp: scaling, symmetry, monotony, sensitivities; and what is refused.
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/friction/point_load.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

using Class = GraspDraws::Class;

double least_grip(const DrawnGrasp& g, const Vector6& load) { return Grasp(g.made()).least_grip(load).value; }

TEST(GraspLaws, GripIsHomogeneousInTheLoad) {
  for (const DrawnGrasp& g : held_grasps(1, 40)) {
    const double s = least_grip(g, g.load);
    for (const double k : {1e-9, 3., 1e9}) EXPECT_NEAR(least_grip(g, k * g.load), k * s, 1e-11 * k * s);
  }
}

TEST(GraspLaws, GripDoesNotDependOnTheUnitOfLength) {
  for (const DrawnGrasp& g : held_grasps(2, 40)) {
    DrawnGrasp mm = g;
    for (DrawnContact& c : mm.contacts) c = c.in_units(1000);
    mm.load.tail<3>() *= 1000;
    const double s = least_grip(g, g.load);
    EXPECT_NEAR(least_grip(mm, mm.load), s, 1e-11 * s);
  }
}

TEST(GraspLaws, GripDoesNotDependOnTheFrame) {
  GraspDraws draws(30);
  for (const DrawnGrasp& g : held_grasps(3, 40)) {
    const Matrix3 Q = Eigen::AngleAxisd(draws.uniform(0, 6), draws.vector().normalized()).toRotationMatrix();
    const Vector3 shift = 0.1 * draws.vector();
    DrawnGrasp moved = g;
    for (DrawnContact& c : moved.contacts) {
      c.r = Q * c.r + shift;
      c.n = Q * c.n;
      c.u = Q * c.u;
    }
    const Vector3 f = Q * g.load.head<3>();
    moved.load = spatial(f, Q * g.load.tail<3>() + shift.cross(f));
    const double s = least_grip(g, g.load);
    EXPECT_NEAR(least_grip(moved, moved.load), s, 1e-10 * s);
  }
}

TEST(GraspLaws, MoreFrictionNeverAsksForMoreGrip) {
  for (const DrawnGrasp& g : held_grasps(4, 40)) {
    DrawnGrasp more = g;
    for (DrawnContact& c : more.contacts) c.mu *= 1.1;
    const double s = least_grip(g, g.load);
    EXPECT_LE(least_grip(more, g.load), s * (1 + 1e-11));
  }
}

TEST(GraspLaws, TheLinearFingerAsksForMoreThanTheEllipticOne) {
  for (const DrawnGrasp& g : held_grasps(5, 40)) {
    DrawnGrasp elliptic = g, linear = g;
    for (DrawnContact& c : elliptic.contacts) c.model = DrawnContact::Model::elliptic;
    for (DrawnContact& c : linear.contacts) c.model = DrawnContact::Model::linear;
    for (auto* grasp : {&elliptic, &linear}) {
      for (DrawnContact& c : grasp->contacts) c.mu = std::max(c.mu, 0.3);
    }
    EXPECT_LE(least_grip(elliptic, g.load), least_grip(linear, g.load) * (1 + 1e-11));
  }
}

// ds/dw = W. Where the twist is unique, which differences on both sides show.
TEST(GraspLaws, TheEscapeTwistIsTheSensitivityToTheLoad) {
  GraspDraws draws(60);
  int compared = 0;
  for (const DrawnGrasp& g : held_grasps(6, 40)) {
    Grasp grasp(g.made());
    const Vector6 dw = 1e-5 * g.load.norm() * draws.load();
    const double s = grasp.least_grip(g.load).value;
    const Vector6 W = grasp.least_grip(g.load).escape_twist;
    const double up = grasp.least_grip(g.load + dw).value, down = grasp.least_grip(g.load - dw).value;
    // s is convex in the load: W supports it.
    EXPECT_GE(up, s + W.dot(dw) - 1e-12 * s);
    EXPECT_GE(down, s - W.dot(dw) - 1e-12 * s);
    if (up + down - 2 * s > 1e-8 * s) continue;
    EXPECT_NEAR((up - down) / 2, W.dot(dw), 1e-8 * s);
    ++compared;
  }
  if (testing::all_cases()) {
    EXPECT_GT(compared, 10);
  }
}

TEST(GraspLaws, ForcesBalanceAndAreAdmissible) {
  for (const DrawnGrasp& g : held_grasps(7, 60)) {
    const auto contacts = g.made();
    Grasp grasp(contacts);
    const GripAnswer& a = grasp.least_grip(g.load);
    Vector6 sum = g.load;
    double total = 0;
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactAnswer& x = a.contacts[i];
      sum += contacts[i].wrench(x.normal_force, x.friction);
      total += x.normal_force;
      EXPECT_GE(x.normal_force, 0);
      EXPECT_LE(x.normal_force, a.upper);
    }
    EXPECT_LE(sum.head<3>().norm(), 1e-12 * total);
    EXPECT_LE(sum.tail<3>().norm(), 1e-12 * total * 0.06);
  }
}

TEST(GraspLaws, LimitsAreWeights) {
  for (const DrawnGrasp& g : held_grasps(8, 20)) {
    Grasp grasp(g.made());
    const double s = grasp.least_grip(g.load).value;
    const std::vector<double> tight(g.contacts.size(), 0.999 * s), wide(g.contacts.size(), 1.001 * s);
    EXPECT_EQ(grasp.holds_within(g.load, tight).verdict, Verdict::cannot_hold);
    EXPECT_EQ(grasp.holds_within(g.load, wide).verdict, Verdict::holds);
    const GripAnswer& factor = grasp.load_factor(Vector6::Zero(), g.load, wide);
    EXPECT_NEAR(factor.value, 1.001, 1e-9);
  }
}

TEST(GraspLaws, AWarmStartGivesTheSameAnswer) {
  for (const DrawnGrasp& g : held_grasps(9, 20)) {
    Grasp grasp(g.made()), fresh(g.made());
    grasp.least_grip(g.load);
    const Vector6 next =
        g.load + 1e-3 * g.load.reverse().cwiseProduct((Vector6() << 1, 1, 1, .02, .02, .02).finished());
    const double s = fresh.least_grip(next).value;
    EXPECT_NEAR(grasp.next_least_grip(next).value, s, 1e-11 * s);
  }
}

// What another question left has other unknowns.
TEST(GraspLaws, AWarmStartAfterAnotherQuestionGivesTheSameAnswer) {
  for (const DrawnGrasp& g : held_grasps(12, 20)) {
    Grasp grasp(g.made()), fresh(g.made());
    const double s = fresh.least_grip(g.load).value;
    const std::vector<double> limits(g.contacts.size(), 2 * s);
    const auto next_is_right = [&] { EXPECT_NEAR(grasp.next_least_grip(g.load).value, s, 1e-11 * s); };
    grasp.least_total_grip(g.load);
    next_is_right();
    grasp.holds_within(g.load, limits);
    next_is_right();
    grasp.load_factor(Vector6::Zero(), g.load, limits);
    next_is_right();
    grasp.force_closure();
    next_is_right();
    grasp.least_quadratic_grip(g.load, 0.1, 0.02);
    next_is_right();
  }
}

TEST(Grasp, NoLoadNeedsNoGrip) {
  GraspDraws draws(10);
  Grasp grasp(draws.draw(Class::inside).made());
  const GripAnswer& a = grasp.least_grip(Vector6::Zero());
  EXPECT_EQ(a.verdict, Verdict::holds);
  EXPECT_EQ(a.lower, 0);
  EXPECT_EQ(a.upper, 0);
}

TEST(Grasp, BadInputIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FrictionCone cone = FrictionCone::point(0.5);
  const ContactFrame frame{Vector3(0, 0, 0), Vector3(0, 0, 1), Vector3(1, 0, 0)};
  EXPECT_THROW(Grasp({}), std::invalid_argument);
  EXPECT_THROW(FrictionCone::point(-1), std::invalid_argument);
  EXPECT_THROW(FrictionCone::soft_elliptic(0.5, 0), std::invalid_argument);
  EXPECT_THROW(FrictionCone::soft_linear(0.5, nan), std::invalid_argument);
  EXPECT_THROW(FrictionCone::patch(0.5, friction::PointLoad()), std::invalid_argument);
  EXPECT_THROW(Contact({Vector3(nan, 0, 0), frame.normal, frame.tangent}, cone), std::invalid_argument);
  EXPECT_THROW(Contact({frame.position, Vector3(0, 0, 0), frame.tangent}, cone), std::invalid_argument);
  EXPECT_THROW(Contact({frame.position, frame.normal, frame.normal}, cone), std::invalid_argument);
  EXPECT_THROW(Grasp({Contact(frame, cone)}, {.relative_width = 0}), std::invalid_argument);
  EXPECT_THROW(Grasp({Contact(frame, cone)}, {.max_iterations = 0}), std::invalid_argument);
  Grasp grasp({Contact(frame, cone)});
  const std::vector<double> none, two{1, 1}, negative{-1};
  EXPECT_THROW(grasp.least_grip(Vector6::Constant(nan)), std::invalid_argument);
  EXPECT_THROW(grasp.holds_within(Vector6::Ones(), none), std::invalid_argument);
  EXPECT_THROW(grasp.holds_within(Vector6::Ones(), two), std::invalid_argument);
  EXPECT_THROW(grasp.holds_within(Vector6::Ones(), negative), std::invalid_argument);
  EXPECT_THROW(grasp.load_factor(Vector6::Ones(), Vector6::Zero(), negative), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::grasp
