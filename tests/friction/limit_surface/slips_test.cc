// Samples of a limit surface, and the smallest ellipsoid about them.
#include <patchgrip/friction/limit_surface/slips.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/friction/limit_surface/enclosing_ellipsoid.h>
#include <patchgrip/tests/friction/limit_surface/cheap_gauges.h>

namespace patchgrip::friction {
namespace {

double squared(double x, double y, double z) { return x * x + y * y + z * z; }

double squared_distance(const Slip& p, const Slip& q, double sign) {
  return squared(p.twist.vx - sign * q.twist.vx, p.twist.vy - sign * q.twist.vy, p.twist.w - sign * q.twist.w) +
         squared(p.wrench.fx - sign * q.wrench.fx, p.wrench.fy - sign * q.wrench.fy, p.wrench.m - sign * q.wrench.m);
}

TEST(Slips, LeaveNoGapInTwistsOrWrenches) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    SCOPED_TRACE(kind);
    const auto axes = CentredFrame::of(patch);
    const SupportFunction D = support_function(patch, axes);
    const std::vector<Slip> slips = spread_slips(D, 1000);
    ASSERT_EQ(slips.size(), 1000U);
    std::mt19937_64 engine(6);
    for (int i = 0; i < testing::cases(200); ++i) {
      // Twists crowd at slips whose pole lies in a small part of the patch: those that a random load starts.
      const Twist v = axes.local(LimitSurface(patch).gauge(random_load(engine, axes)).twist);
      const SupportValue at = D(v);
      const Slip here{{v.vx / at.value, v.vy / at.value, v.w / at.value}, at.wrench};
      double nearest = std::numeric_limits<double>::infinity();
      for (const Slip& s : slips) {
        nearest = std::min({nearest, squared_distance(here, s, 1), squared_distance(here, s, -1)});
      }
      EXPECT_LE(std::sqrt(nearest), 0.25);
    }
  });
}

// About a point load wrenches differ at one twist: no cutting brings them together.
TEST(Slips, PassByKinks) {
  const auto four = Several::of_parts({{Placed(PointLoad{}, -0.02, 0), 1},
                                       {Placed(PointLoad{}, 0.02, 0.01), 2},
                                       {Placed(PointLoad{}, 0, 0.03), 1},
                                       {HertzDisc::of_radius(0.01), 1}});
  const auto two = Several::of_parts({{Placed(PointLoad{}, -0.02, 0), 1}, {Placed(PointLoad{}, 0.02, 0), 1}});
  for (const auto& patch : {disc_and_point(), two, four}) {
    const auto axes = CentredFrame::of(patch);
    EXPECT_EQ(spread_slips(support_function(patch, axes), 1000).size(), 1000U);
  }
}

// Flat cones come up among those that are cut next to a kink: each cut would make the same again.
TEST(Slips, EndForPointsAmongZones) {
  std::mt19937_64 engine(7);
  const auto place = [&] { return testing::uniform(engine, -10, 10); };
  for (int i = 0; i < testing::cases(100); ++i) {
    std::vector<Several::Part> parts{{Placed(PointLoad{}, place(), place()), 1}};
    for (int k = 0; k < 3; ++k)
      parts.push_back({Placed(HertzDisc::of_radius(testing::log_uniform(engine, 1e-2, 10)), place(), place()),
                       testing::log_uniform(engine, 1e-2, 1e2)});
    const auto patch = Several::of_parts(parts);
    const auto axes = CentredFrame::of(patch);
    EXPECT_EQ(spread_slips(support_function(patch, axes), 1000).size(), 1000U) << i;
  }
}

TEST(Slips, LieOnTheLimitSurfaceAndItsPolar) {
  const Rectangle patch = Rectangle::of_sides(0.04, 0.01);
  const auto axes = CentredFrame::of(patch);
  for (const auto& [v, t] : spread_slips(support_function(patch, axes), 100)) {
    EXPECT_NEAR(patch.dissipation(axes.global(v)), 1, 1e-13);
    EXPECT_NEAR(power(t, v), 1, 1e-13);
    EXPECT_NEAR(LimitSurface(patch).gauge(axes.global(t)).value, 1, 1e-12);
  }
}

// That of a ring is its radius. Rounded away from the origin it may come out larger, which no bound could rest on.
TEST(CentredFrame, LengthIsNoMoreThanTheCentralMoment) {
  std::mt19937_64 engine(20060312);
  for (int i = testing::cases(200); i > 0; --i) {
    const double a = testing::log_uniform(engine, 1e-3, 10), reach = 1e3 * a;
    const double x = testing::uniform(engine, -reach, reach), y = testing::uniform(engine, -reach, reach);
    const double length = CentredFrame::of(Placed(Ring::of_radius(a), x, y)).length;
    EXPECT_LE(length, a);
    EXPECT_GE(length, a * (1 - 1e-11));
  }
}

TEST(EnclosingEllipsoid, OfCornersOfABoxHasItsProportions) {
  // sqrt(3) times the half sides 1, 2, 4.
  const auto A = enclosing_ellipsoid({{1, 2, 4}, {1, 2, -4}, {1, -2, 4}, {-1, 2, 4}}, 1e-6);
  EXPECT_NEAR(A[0], 1. / 3, 1e-5);
  EXPECT_NEAR(A[3], 1. / 12, 1e-5);
  EXPECT_NEAR(A[5], 1. / 48, 1e-5);
  for (const std::size_t off : {1U, 2U, 4U}) EXPECT_NEAR(A[off], 0, 1e-5);
}

}  // namespace
}  // namespace patchgrip::friction
