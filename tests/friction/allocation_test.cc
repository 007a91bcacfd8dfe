// Evaluating a patch allocates nothing: every operator new of this program is counted.
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/batch.h>
#include <patchgrip/friction/law.h>
#include <patchgrip/friction/limit_surface/ellipsoid_gauge.h>
#include <patchgrip/friction/limit_surface/pade_wrench.h>
#include <patchgrip/friction/limit_surface/quartic_gauge.h>
#include <patchgrip/friction/seed_hertz_disc.h>
#include <patchgrip/tests/friction/any_patch.h>
#include <patchgrip/tests/support/count_allocations.h>

namespace patchgrip::friction {
namespace {

using testing::allocations_of;

// Inside, on the rim or nearly, in every region of a polygon, far away and at infinity.
const std::vector<Twist> motions{{0, 0, 1},   {0.01, 0.02, 1}, {1, 0, 1},   {0.6, 0.8, 1}, {2, 1, -1},
                                 {4, 1, 0.7}, {30, 20, 1},     {5e8, 1, 1}, {1, 2, 0},     {0, 0, 0}};

volatile double sink;

template <class P>
double evaluate(const P& patch, const std::vector<Twist>& twists) {
  double sum = 0;
  for (const Twist& v : twists) {
    sum += patch.dissipation(v) + patch.gradient(v).m + patch.bounded_gradient(v).force_error;
    sum += friction_wrench(Law::stribeck(0.9, 0.5, 0.3).with_viscous(0.1), 10, patch, v).value.m;
    sum += patch.moments().polar + patch.area_radius();
    if (v.vx != 0 || v.w != 0) sum += patch.hessian({v.vx + 0.001, v.vy, v.w}).ww;
  }
  return sum;
}

TEST(Allocation, IsCounted) {
  std::vector<int> kept;
  EXPECT_EQ(allocations_of([&] { kept.resize(100); }), 1);
}

TEST(Allocation, DoesNotHappenWhenAPatchIsEvaluated) {
  for (const NamedPatch& p : every_patch()) {
    std::visit(
        [&](const auto& patch) { EXPECT_EQ(allocations_of([&] { sink = evaluate(patch, motions); }), 0) << p.name; },
        p.patch);
  }
  const SeedHertzDisc seed = SeedHertzDisc::of_radius(1);
  EXPECT_EQ(allocations_of([&] { sink = evaluate(seed, motions); }), 0);
}

TEST(Allocation, DoesNotHappenWhenAPatchIsCopied) {
  for (const NamedPatch& p : every_patch()) {
    EXPECT_EQ(allocations_of([&] { [[maybe_unused]] const TestedPatch copy = p.patch; }), 0) << p.name;
  }
}

TEST(Allocation, DoesNotHappenInABatch) {
  std::vector<double> x(3000, 0.3), y(3000, 0.8), fx(3000), fy(3000), m(3000);
  x[1500] = 1e200;  // one chunk pole by pole
  const PoleBatch batch{x, y, fx, fy, m};
  const HertzDisc hertz = HertzDisc::of_radius(1);
  const FlatPunchDisc flat = FlatPunchDisc::of_radius(1);
  const Ring ring = Ring::of_radius(1);
  EXPECT_EQ(allocations_of([&] { gradient(hertz, 1, batch); }), 0);
  EXPECT_EQ(allocations_of([&] { gradient(flat, 1, batch); }), 0);
  EXPECT_EQ(allocations_of([&] { gradient(ring, 1, batch); }), 0);
}

TEST(Allocation, DoesNotHappenInACheapGauge) {
  const HertzDisc disc = HertzDisc::of_radius(1);
  const auto evaluate_gauge = [](const auto& gauge) {
    sink = gauge.gauge({0.3, -0.2, 0.1}).upper + gauge.dissipation({1, 2, 3}) + gauge.gradient({1, 0, 0.1}).m;
  };
  const auto ellipsoid = EllipsoidGauge::axis(disc);
  const auto quartic = QuarticGauge::least_squares(disc);
  const auto pade = PadeWrench::second_order(disc);
  EXPECT_EQ(allocations_of([&] { evaluate_gauge(ellipsoid); }), 0);
  EXPECT_EQ(allocations_of([&] { evaluate_gauge(quartic); }), 0);
  EXPECT_EQ(allocations_of([&] { sink = pade.gradient({1, 2, 3}).m; }), 0);
}

}  // namespace
}  // namespace patchgrip::friction
