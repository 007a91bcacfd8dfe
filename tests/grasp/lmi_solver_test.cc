#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/grasp/lmi_solver.h>
#include <patchgrip/tests/grasp/lmi_draws.h>

namespace patchgrip::grasp {
namespace {

using Status = LmiAnswer::Status;

// SDPA's own tolerance, and what the equalities may be off by.
void expect_agreement(const LmiAnswer& b, double value, double unit) {
  const double size = std::max(value, unit);
  EXPECT_LE(b.upper - b.lower, 1.1e-6 * size);
  EXPECT_LE(b.lower, value + 1e-8 * size);
  EXPECT_GE(b.upper, value - 1e-8 * size);
}

// Elliptic, point and frictionless contacts, 2 ... 13; from well inside to just held.
TEST(LmiSolver, LeastGripIsThatOfTheGrasp) {
  GraspDraws draws(1);
  int solved = 0;
  const int count = testing::cases(250);
  for (int i = 0; i < count; ++i) {
    const LmiDraw g = draw_lmi(draws, 2 + i % 12, 0.99, false);
    const GripLmi lmi = grip_lmi(g.made(), g.load, Objective::max_force);
    const double value = Grasp(g.made()).least_grip(g.load).value;
    const LmiAnswer b = solve(lmi);
    EXPECT_NE(b.status, Status::cannot_hold);
    if (b.status != Status::solved) continue;
    ++solved;
    expect_agreement(b, value, lmi.force);
    EXPECT_NEAR(b.twist.dot(g.load), b.lower, 1e-12 * value);
    Vector6 sum = g.load;
    double most = 0;
    for (std::size_t c = 0; c < g.contacts.size(); ++c) {
      sum += g.contacts[c].contact().wrench(b.forces[c].normal, b.forces[c].friction);
      most = std::max(most, b.forces[c].normal);
    }
    EXPECT_NEAR(most, value, 2e-6 * std::max(value, lmi.force));
    EXPECT_LT(sum.norm(), 1e-6 * lmi.force);
  }
  EXPECT_GE(solved, 0.99 * count);
}

TEST(LmiSolver, LeastTotalGripIsThatOfTheGrasp) {
  GraspDraws draws(2);
  for (int i = 0; i < testing::cases(50); ++i) {
    const LmiDraw g = draw_lmi(draws, 2 + i % 12, 0.99, false);
    const GripLmi lmi = grip_lmi(g.made(), g.load, Objective::total_force);
    const LmiAnswer b = solve(lmi);
    EXPECT_EQ(b.status, Status::solved);
    expect_agreement(b, Grasp(g.made()).least_total_grip(g.load).value, lmi.force);
  }
}

TEST(LmiSolver, WhatCannotBeHeldIsFoundByBoth) {
  GraspDraws draws(3);
  int cannot = 0, unsolved = 0;
  const int count = testing::cases(100);
  for (int i = 0; i < count; ++i) {
    const LmiDraw g = draw_lmi(draws, 2 + i % 5, 0.99, false);
    const Vector6 load = i % 3 == 0 ? draws.load() : Vector6(-g.load);
    Grasp grasp(g.made());
    const GripAnswer& a = grasp.least_grip(load);
    try {
      const GripLmi lmi = grip_lmi(g.made(), load, Objective::max_force);
      const LmiAnswer b = solve(lmi);
      if (b.status == Status::unsolved) {
        ++unsolved;
        continue;
      }
      EXPECT_EQ(b.status, a.verdict == Verdict::holds ? Status::solved : Status::cannot_hold);
      if (b.status == Status::solved) expect_agreement(b, a.value, lmi.force);
    } catch (const std::domain_error&) {
      EXPECT_EQ(a.verdict, Verdict::cannot_hold);
    }
    cannot += a.verdict == Verdict::cannot_hold;
  }
  EXPECT_GT(cannot, 0.2 * count);
  EXPECT_LE(unsolved, 0.01 * count);
}

TEST(LmiSolver, SettingsOutOfRangeAreRefused) {
  GraspDraws draws(4);
  const LmiDraw g = draw_lmi(draws, 5, 0.9, false);
  const GripLmi lmi = grip_lmi(g.made(), g.load, Objective::max_force);
  EXPECT_THROW(solve(lmi, {.tolerance = 0}), std::invalid_argument);
  EXPECT_THROW(solve(lmi, {.max_iterations = 0}), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::grasp
