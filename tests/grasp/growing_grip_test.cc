// Contacts that grow with the grip: the table, and grips that must not be worse or better than they can be.
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/grasp/growing_grip.h>
#include <patchgrip/tests/grasp/grasp_table.h>

namespace patchgrip::grasp {
namespace {

std::vector<GrowingContact> growing(const std::string& id) {
  std::vector<GrowingContact> all;
  for (const json& grasp : grasp_table()["grasps"]) {
    if (grasp["id"] != id) continue;
    for (const json& c : grasp["contacts"]) {
      const ContactFrame frame{vector3(c["position"]), vector3(c["normal_out"]), vector3(c["u"])};
      const double mu = number(c["mu"]), cube = 3 * number(c["R"]) / (4 * number(c["E_star"]));
      all.push_back([=](double F) {
        return Contact(frame, FrictionCone::patch(mu, friction::HertzDisc::of_radius(std::cbrt(cube * F))));
      });
    }
  }
  return all;
}

TEST(GrowingGrip, Table) {
  for (const json& c : cases_of("min_max_normal_load_dependent")) {
    SCOPED_TRACE(c["id"].get<std::string>());
    const json& result = c["result"];
    const GrowingGrip grip = least_growing_grip(growing(c["grasp"]), vector6(c["load"]));
    EXPECT_EQ(grip.verdict, Verdict::holds);
    if (result.contains("value")) {
      const double value = number(result["value"]);
      EXPECT_NEAR(grip.lower, value, 1e-12 * value);
      EXPECT_NEAR(grip.upper, value, 1e-12 * value);
      EXPECT_LE(grip.lower, grip.upper);
    } else {
      EXPECT_NEAR(grip.lower, number(result["lower"]), 1e-9);
      EXPECT_LE(grip.upper, number(result["upper"]) + 1e-9);
      EXPECT_GE(grip.upper, grip.lower);
    }
  }
}

// The forces of the upper bound, with contacts as large as they make them, hold.
TEST(GrowingGrip, ItsForcesAreAdmissible) {
  const auto k = growing("tripod_load_dep");
  Vector6 load;
  load << 0.3, 0.2, -3, 0.01, 0.02, 0.02;
  const GrowingGrip grip = least_growing_grip(k, load);
  Vector6 balance = load;
  for (std::size_t i = 0; i < k.size(); ++i) {
    const ContactAnswer& a = grip.upper_answer.contacts[i];
    ASSERT_GT(a.normal_force, 0);
    const Contact c = k[i](a.normal_force);
    balance += c.wrench(a.normal_force, a.friction);
    const double gauge = c.cone().surface().gauge({a.friction[0], a.friction[1], a.friction[2]}).lower;
    EXPECT_LE(gauge, c.cone().mu() * a.normal_force * (1 + 1e-12));
  }
  EXPECT_LE(balance.norm(), 1e-12 * load.norm());
}

TEST(GrowingGrip, GrowsSlowerThanTheLoad) {
  const auto k = growing("pinch_load_dep");
  Vector6 load;
  load << 0, 0, -4.905, 0.01962, 0, 0;
  const double once = least_growing_grip(k, load).upper;
  const double twice = least_growing_grip(k, 2 * load).upper;
  EXPECT_LT(twice, 2 * once);
  EXPECT_GT(twice, once);
}

TEST(GrowingGrip, NoLoadNeedsNoGrip) {
  const GrowingGrip grip = least_growing_grip(growing("pinch_load_dep"), Vector6::Zero());
  EXPECT_EQ(grip.verdict, Verdict::holds);
  EXPECT_EQ(grip.upper, 0);
}

TEST(GrowingGrip, SaysWhatCannotBeHeld) {
  const auto k = growing("pinch_load_dep");
  const std::vector<GrowingContact> one(k.begin(), k.begin() + 1);
  const GrowingGrip grip = least_growing_grip(one, -Vector6::Unit(0));  // away from the only finger
  EXPECT_EQ(grip.verdict, Verdict::cannot_hold);
  EXPECT_GT(grip.lower, 1e5);
}

TEST(GrowingGrip, RefusesLoadsThatAreNotFinite) {
  Vector6 load = Vector6::Unit(2);
  load[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(least_growing_grip(growing("pinch_load_dep"), load), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::grasp
