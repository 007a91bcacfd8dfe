// Errors of slips where loads are uneven, so that the centroid lies many radii of gyration from the origin and much of
// the stiffness is rounding; and where loads are tiny.
#include <patchgrip/friction/limit_surface/slip_error.h>

#include <cmath>
#include <iomanip>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/limit_surface/point_slip.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/tests/friction/limit_surface/point_loads.h>

namespace patchgrip::friction {
namespace {

using ::patchgrip::testing::cases;
using ::patchgrip::testing::log_uniform;
using ::patchgrip::testing::uniform;

PointScene::Part draw_part(std::mt19937_64& engine, double radius) {
  return {uniform(engine, -1, 1), uniform(engine, -1, 1), log_uniform(engine, 1e-5, 1), radius};
}

// Without a family of discs where there are none.
GaugeReference reference_of(const PointScene& scene) {
  Real50 total = 0;
  for (const PointScene::Part& p : scene.parts) {
    if (p.radius > 0) return scene.reference();
    total += p.force;
  }
  std::vector<PointShare50> points;
  for (const PointScene::Part& p : scene.parts) points.push_back({p.x, p.y, p.force / total});
  return {{}, points, scene.patch().moments()};
}

// Whether the slip is told; if so it is as far from that of 50 digits as its errors say, or less.
bool within_errors(const PointScene& scene, const Wrench& t) {
  const LimitSurface surface(scene.patch());
  const Gauge g = surface.gauge(t);
  const SlipError error = slip_error(g, t, view(surface.patch()), surface.frame());
  if (!std::isfinite(error.speed)) return false;
  const auto truth = reference_of(scene).slip(t, g.twist);
  if (!truth) {
    ADD_FAILURE() << "50 digits know no slip";
    return false;
  }
  const auto length = [](const Real50& x, const Real50& y) { return Real50(sqrt(x * x + y * y)); };
  EXPECT_LE(length(truth->twist[0] - g.twist.vx, truth->twist[1] - g.twist.vy), error.speed);
  EXPECT_LE(abs(truth->twist[2] - g.twist.w), error.spin);
  if (std::isfinite(error.pole_error)) {
    EXPECT_LE(length(truth->x - error.pole.x, truth->y - error.pole.y), error.pole_error);
  }
  return true;
}

// `feet` point loads, and a disc if its radius is not 0, the first bearing up to 1e5 of another.
void expect_errors_of_uneven(int feet, double radius, int count) {
  constexpr LoadKind kinds[] = {LoadKind::exact, LoadKind::nearly_exact, LoadKind::any, LoadKind::rim_of_facet};
  std::mt19937_64 engine(1);
  int told = 0;
  for (int i = 0; i < count; ++i) {
    PointScene scene{"", {{uniform(engine, -1, 1), uniform(engine, -1, 1), 1}}};
    for (int k = 1; k < feet; ++k) scene.parts.push_back(draw_part(engine, 0));
    if (radius > 0) scene.parts.push_back(draw_part(engine, radius));
    scene.angle = std::atan2(scene.parts[1].y - scene.parts[0].y, scene.parts[1].x - scene.parts[0].x);
    const Wrench t = draw_load(engine, kinds[i % 4], scene, scene.patch());
    SCOPED_TRACE(::testing::Message() << "case " << i << std::setprecision(17) << ": " << t.fx << ' ' << t.fy << ' '
                                      << t.m);
    told += within_errors(scene, t);
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
  ::testing::Test::RecordProperty("told", told);
  EXPECT_GE(told, 0.9 * count);
}

TEST(SlipErrorOfUnevenLoads, HoldsForTwoFeet) { expect_errors_of_uneven(2, 0, cases(400)); }
TEST(SlipErrorOfUnevenLoads, HoldsForThreeFeet) { expect_errors_of_uneven(3, 0, cases(100)); }
TEST(SlipErrorOfUnevenLoads, HoldsForAFootAndADisc) { expect_errors_of_uneven(1, 0.1, cases(10)); }

TEST(SlipErrorOfUnevenLoads, CountsTheRoundingOfTheStiffness) {
  // The centroid lies 80 radii of gyration from the origin, and the least stiffness is 3e-12 of the others.
  const PointScene scene{"",
                         {{0.15149939451707306, 0.93040859023353795, 0.018882997423345989},
                          {-0.14342970858735504, 0.39161896655750739, 302.7452920809219}}};
  within_errors(scene, {-0.0031510646943008597, 0.006642478035352643, 0.00028156965830481454});
}

TEST(SlipErrorOfTinyLoads, IsThatOfOthers) {
  const LimitSurface surface(Placed(Rectangle::of_sides(0.02, 0.03), 3, 4));
  const Wrench load{0.3, 0.4, -0.01};
  const auto error_of = [&](int exponent) {
    const Wrench t{std::ldexp(load.fx, exponent), std::ldexp(load.fy, exponent), std::ldexp(load.m, exponent)};
    return slip_error(surface.gauge(t), t, view(surface.patch()), surface.frame());
  };
  const SlipError usual = error_of(0);
  EXPECT_GT(usual.speed, 0);
  EXPECT_LT(usual.speed, 1e-8);
  EXPECT_TRUE(std::isinf(slip_error(surface.gauge({}), {}, view(surface.patch()), surface.frame()).speed));
  for (const int exponent : {900, -900, -1000}) {
    const SlipError error = error_of(exponent);
    EXPECT_EQ(error.speed, usual.speed);
    EXPECT_EQ(error.spin, usual.spin);
    EXPECT_EQ(error.pole_error, usual.pole_error);
  }
  // Subnormal: the load itself is another, but known.
  const SlipError subnormal = error_of(-1030);
  EXPECT_LT(subnormal.speed, 10 * usual.speed);
  EXPECT_LT(subnormal.pole_error, 10 * usual.pole_error);
}

// Without a stiffness the velocity would be twice as long as the cap on the load's own axis.
TEST(VelocityOfPoint, IsNotLongerThanAskedFor) {
  const Planar z = velocity_of_point({}, 1, {2, 0}, 0.3);
  EXPECT_DOUBLE_EQ(z.x, 0.3);
  EXPECT_EQ(z.y, 0);
  std::mt19937_64 engine(2);
  for (int i = 0; i < cases(1000); ++i) {
    const double w = log_uniform(engine, 1e-3, 1), longest = log_uniform(engine, 1e-6, 1);
    const double xx = uniform(engine, 0, 1), yy = uniform(engine, 0, 1);
    const double xy = uniform(engine, -1, 1) * std::sqrt(xx * yy);
    const double size = w * (1 + log_uniform(engine, 1e-6, 10)), angle = uniform(engine, -3.2, 3.2);
    const Planar a{size * std::cos(angle), size * std::sin(angle)};
    const Planar v = velocity_of_point({xx, xy, yy}, w, a, longest);
    const double speed = length_of(v);
    ASSERT_LE(speed, longest * (1 + 1e-15));
    if (speed > 0.999 * longest) continue;
    const double k = w / speed;
    ASSERT_NEAR((xx + k) * v.x + xy * v.y, a.x, 1e-9 * size);
    ASSERT_NEAR(xy * v.x + (yy + k) * v.y, a.y, 1e-9 * size);
  }
}

}  // namespace
}  // namespace patchgrip::friction
