// Brackets beyond double precision, next to a cone that is not closed.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/grasp/grasp.h>

namespace patchgrip::grasp {
namespace {

// The cones of a point and of a smooth contact on its edge add up to one that is not closed: a load (delta, -1, 0) needs
// the more grip the less it leans inwards, (1 + delta^2) / delta sqrt(5) / 2, and |W| is about 1.1 / delta^2.
Grasp beside_open_cone(const FrictionCone& cone, const Vector3& at = Vector3::Zero()) {
  return Grasp({Contact({at, {0, 0, -1}, Vector3(1, 0, 0)}, cone),
                Contact({at, {0.5, 0, 1}, Vector3(0, 1, 0)}, FrictionCone::frictionless())});
}

Vector6 leaning(double delta, const Vector3& at = Vector3::Zero()) {
  const Vector3 f(delta, -1, 0);
  return spatial(f, {at[1] * f[2] - at[2] * f[1], at[2] * f[0] - at[0] * f[2], at[0] * f[1] - at[1] * f[0]});
}

TEST(ExtendedPolish, BracketsAreNarrowerThanTheRoundingOfDoubleAllows) {
  for (const double delta : {0x1p-7, 0x1p-9, 0x1p-11}) {
    Grasp grasp = beside_open_cone(FrictionCone::point(0.5));
    const GripAnswer& a = grasp.least_grip(leaning(delta));
    const long double exact = (1 + static_cast<long double>(delta) * delta) / delta * std::sqrt(5.L) / 2;
    EXPECT_EQ(a.effort.route, Route::extended);
    EXPECT_EQ(a.verdict, Verdict::holds);
    EXPECT_LE(a.lower, exact);
    EXPECT_GE(a.upper, exact);
    EXPECT_LE(a.upper - a.lower, 0x1p-53 / (delta * delta) * a.value) << delta;  // of double: 8 times that, and more
  }
}

TEST(ExtendedPolish, LeavesAloneWhatDoubleAlreadyCloses) {
  Grasp grasp = beside_open_cone(FrictionCone::point(0.5));
  EXPECT_EQ(grasp.least_grip(leaning(0.5)).effort.route, Route::polished);
}

TEST(ExtendedPolish, DoesNotTakeRoundingOffTheRangeForALoad) {
  const Vector3 at(0.011, -0.007, 0.013);
  Grasp grasp = beside_open_cone(FrictionCone::point(0.5), at);
  const GripAnswer& a = grasp.least_grip(leaning(0x1p-9, at));
  EXPECT_NE(a.effort.route, Route::extended);
  EXPECT_EQ(a.verdict, Verdict::holds);
}

TEST(ExtendedPolish, KnowsNoPatches) {
  Grasp grasp = beside_open_cone(FrictionCone::patch(0.5, friction::HertzDisc::of_radius(1e-3)));
  EXPECT_NE(grasp.least_grip(leaning(0x1p-9)).effort.route, Route::extended);
}

TEST(ExtendedAxes, AreThoseOfDoubleInMoreDigits) {
  const Contact contact({{0, 0, 0}, {0.3, -1.7, 0.9}, Vector3(1, 2, 0.1)}, FrictionCone::point(0.5));
  const Eigen::Matrix<long double, 3, 3> axes = contact.extended_axes();
  Eigen::Matrix3d of_double;
  of_double << contact.u(), contact.v(), contact.normal();
  EXPECT_LE((axes.cast<double>() - of_double).cwiseAbs().maxCoeff(), 4 * std::numeric_limits<double>::epsilon());
  const Eigen::Matrix<long double, 3, 3> off = axes.transpose() * axes - Eigen::Matrix<long double, 3, 3>::Identity();
  EXPECT_LE(off.cwiseAbs().maxCoeff(), 4 * std::numeric_limits<long double>::epsilon());
}

}  // namespace
}  // namespace patchgrip::grasp
