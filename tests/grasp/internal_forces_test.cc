// Internal forces and the seed's pseudo-inverse, against the table and against the balance.
#include <cmath>

#include <gtest/gtest.h>

#include <patchgrip/grasp/internal_forces.h>
#include <patchgrip/tests/grasp/grasp_table.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

TEST(InternalForces, LoadNothing) {
  GraspDraws draws(61);
  for (int i = 0; i < testing::cases(60); ++i) {
    const auto k = draws.draw(GraspDraws::Class::inside).made();
    const InternalForces all = internal_forces(k);
    EXPECT_EQ(static_cast<int>(all.basis.size()), all.components - all.rank);
    for (const auto& forces : all.basis) {
      Vector6 sum = Vector6::Zero();
      double largest = 0;
      for (std::size_t j = 0; j < k.size(); ++j) {
        sum += k[j].wrench(forces[j].normal, forces[j].friction);
        largest = std::max({largest, std::fabs(forces[j].normal), forces[j].friction.head<2>().norm()});
      }
      EXPECT_GT(largest, 0);
      EXPECT_LE(sum.norm(), 1e-13);
    }
  }
}

TEST(InternalForces, TwoFingers) {
  const InternalForces points = internal_forces(contacts("pinch_point"));  // nothing turns against their line
  EXPECT_EQ(points.rank, 5);
  EXPECT_EQ(points.components, 6);
  ASSERT_EQ(points.basis.size(), 1U);
  EXPECT_NEAR(points.basis[0][0].normal, points.basis[0][1].normal, 1e-15);
  const InternalForces soft = internal_forces(contacts("pinch_hertz_disc"));
  EXPECT_EQ(soft.rank, 6);
  EXPECT_EQ(soft.components, 8);
  EXPECT_EQ(internal_forces(contacts("pinch_soft_linear")).components, 8);
}

TEST(LeastNormForces, Table) {
  for (const json& c : cases_of("pseudo_inverse")) {
    SCOPED_TRACE(c["id"].get<std::string>());
    const LeastNormForces a = least_norm_forces(contacts(c["grasp"]), vector6(c["load"]));
    const json& result = c["result"];
    EXPECT_EQ(a.rank, result["rank"].get<int>());
    EXPECT_LE(a.residual.norm(), 1e-14);
    for (std::size_t i = 0; i < a.normal_forces.size(); ++i) {
      EXPECT_NEAR(a.normal_forces[i], number(result["F_n"][i]), 2e-14);
    }
  }
}

TEST(LeastNormForces, LeaveWhatNoForceResists) {
  const LeastNormForces a = least_norm_forces(contacts("table_3"), Vector6::Unit(0));
  EXPECT_NEAR(a.residual[0], 1, 1e-14);
}

}  // namespace
}  // namespace patchgrip::grasp
