// The return mapping of any patch in any metric: against that of round patches, and what proves a closest point.
#include <patchgrip/dynamics/return_mapping.h>

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <patchgrip/dynamics/round_return_mapping.h>
#include <patchgrip/friction/any_patch.h>
#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::dynamics {
namespace {

using friction::Twist;
using friction::Wrench;
using testing::cases;
using testing::log_uniform;
using testing::uniform;

Wrench any_load(std::mt19937_64& engine, double length) {
  return {uniform(engine, -1, 1), uniform(engine, -1, 1), length * uniform(engine, -1, 1)};
}

Wrench scaled(const Wrench& t, double k) { return {k * t.fx, k * t.fy, k * t.m}; }

// Of a condition up to `most` once lengths are in units of `length`.
BristleMetric any_metric(std::mt19937_64& engine, double length, double most) {
  Eigen::Quaterniond q(uniform(engine, -1, 1), uniform(engine, -1, 1), uniform(engine, -1, 1), uniform(engine, -1, 1));
  const Matrix3 turn = q.normalized().toRotationMatrix();
  const double k = log_uniform(engine, 1e3, 1e6);
  const Vector3 values(k, k * log_uniform(engine, 1 / most, 1), k * log_uniform(engine, 1 / most, 1));
  const Matrix3 unit = turn * values.asDiagonal() * turn.transpose();
  const Vector3 lengths(1, 1, length);
  const Matrix3 K = lengths.asDiagonal() * unit * lengths.asDiagonal();
  return BristleMetric((K + K.transpose()) / 2);
}

TEST(ReturnMapping, AgreesWithThatOfRoundPatches) {
  std::mt19937_64 engine(1);
  const auto compare = [&](const auto& disc) {
    const ReturnMapping any(disc);
    const RoundReturnMapping round(disc);
    const double a = disc.radius();
    for (int i = 0; i < cases(500); ++i) {
      const double rho = log_uniform(engine, 1e-2, 1e2), k = log_uniform(engine, 1e2, 1e6), limit = 3;
      const RoundStiffness K{k, k * a * a / rho};
      Wrench t = any_load(engine, a);
      t = scaled(t, limit * (1 + log_uniform(engine, 1e-9, 1e3)) / any.surface().gauge(t).value);
      const Returned found = any(t, limit, BristleMetric::diagonal(K.k, K.k, K.k_r)), expected = round(t, limit, K);
      const Wrench &s = found.wrench.value, &e = expected.wrench.value;
      ASSERT_EQ(found.slips, expected.slips) << i;
      EXPECT_LE(std::hypot(s.fx - e.fx, s.fy - e.fy), found.wrench.force_error + expected.wrench.force_error);
      EXPECT_LE(std::fabs(s.m - e.m), found.wrench.moment_error + expected.wrench.moment_error);
      EXPECT_LE(found.wrench.force_error, 1e-12 * limit);
      EXPECT_LE(found.wrench.moment_error, 1e-12 * limit * a);
      const double size = std::hypot(t.fx, t.fy) + std::fabs(t.m) / a;
      EXPECT_LE(k * std::hypot(found.slip.vx - expected.slip.vx, found.slip.vy - expected.slip.vy), 1e-12 * size);
      EXPECT_LE(K.k_r / a * std::fabs(found.slip.w - expected.slip.w), 1e-12 * size);
    }
  };
  compare(friction::HertzDisc::of_radius(0.004));
  compare(friction::UniformDisc::of_radius(2));
  compare(friction::Ring::of_radius(0.1));
}

struct Named {
  const char* name;
  friction::AnyPatch patch;
};

std::vector<Named> patches() {
  using namespace friction;
  return {{"Hertz disc aside", Placed(HertzDisc::of_radius(0.01), 0.03, -0.02)},
          {"rectangle 2:1", Rectangle::of_sides(0.04, 0.02)},
          {"rectangle 200:1", Rectangle::of_sides(2, 0.01)},
          {"Hertz ellipse 5:1", Placed(HertzEllipse::of_semi_axes(0.05, 0.01), PlanarFrame{0.01, 0, 0.7})},
          {"two discs", Several::of_parts({{Placed(UniformDisc::of_radius(0.004), -0.02, 0.001), 60, 0.5},
                                           {Placed(HertzDisc::of_radius(0.003), 0.015, -0.002), 25, 0.9}})}};
}

// s is on the limit surface with the normal u, and K u = s* - s: by convexity there is no closer one.
TEST(ReturnMapping, IsTheClosestPoint) {
  std::mt19937_64 engine(2);
  for (const Named& p : patches()) {
    SCOPED_TRACE(p.name);
    const ReturnMapping mapping(p.patch);
    const double length = mapping.surface().frame().length;
    const double arm = std::hypot(mapping.surface().frame().x, mapping.surface().frame().y) + length;
    double evaluations = 0, count = 0;
    for (int i = 0; i < cases(400); ++i) {
      const double limit = log_uniform(engine, 1e-2, 1e2);
      const BristleMetric metric = any_metric(engine, length, 1e4);
      Wrench t = any_load(engine, arm);
      t = scaled(t, limit * (1 + log_uniform(engine, 1e-9, 1e3)) / mapping.surface().gauge(t).value);
      const Returned r = mapping(t, limit, metric);
      SCOPED_TRACE(::testing::Message() << i);
      ASSERT_TRUE(r.slips);
      evaluations += r.evaluations;
      ++count;
      const Wrench& s = r.wrench.value;
      const Wrench g = p.patch.gradient(r.slip);
      const Vector3 lengths(1, 1, 1 / length);
      const auto size = [&](const Vector3& x) { return lengths.cwiseProduct(x).norm(); };
      const double total = size({t.fx, t.fy, t.m}) + limit;
      EXPECT_LE(size({s.fx - limit * g.fx, s.fy - limit * g.fy, s.m - limit * g.m}), 1e-9 * limit);
      const Vector3 left = metric.stiffness() * Vector3(r.slip.vx, r.slip.vy, r.slip.w);
      const double off = size({t.fx - s.fx - left[0], t.fy - s.fy - left[1], t.m - s.m - left[2]});
      EXPECT_LE(off, 1e-10 * total);
      EXPECT_GE(friction::power(s, r.slip), 0);
      EXPECT_LE(r.wrench.force_error, 1e-8 * limit);
    }
    EXPECT_LE(evaluations / count, 10);
  }
}

TEST(ReturnMapping, SticksWhereTheGaugeSaysSo) {
  std::mt19937_64 engine(3);
  for (const Named& p : patches()) {
    const ReturnMapping mapping(p.patch);
    const double length = mapping.surface().frame().length;
    for (int i = 0; i < cases(300); ++i) {
      const BristleMetric metric = any_metric(engine, length, 100);
      const Wrench t = any_load(engine, length);
      const double g = mapping.surface().gauge(t).value, side = uniform(engine, -1, 1) < 0 ? -1 : 1;
      const double limit = g * (1 + side * log_uniform(engine, 1e-10, 0.9));
      const Returned r = mapping(t, limit, metric);
      ASSERT_EQ(r.slips, limit < g) << p.name;
      if (r.slips) continue;
      EXPECT_EQ(r.wrench.value.fx, t.fx);
      EXPECT_EQ(r.wrench.value.m, t.m);
      EXPECT_EQ(r.slip.vx, 0);
      EXPECT_EQ(r.slip.w, 0);
    }
  }
}

TEST(ReturnMapping, NoFrictionLetsAllOfItSlip) {
  const ReturnMapping mapping(friction::Rectangle::of_sides(0.04, 0.02));
  const Returned r = mapping({3, -4, 0.1}, 0, BristleMetric::diagonal(1e4, 2e4, 2));
  EXPECT_DOUBLE_EQ(r.slip.vx, 3e-4);
  EXPECT_DOUBLE_EQ(r.slip.vy, -2e-4);
  EXPECT_DOUBLE_EQ(r.slip.w, 0.05);
  EXPECT_EQ(r.wrench.value.fx, 0);
}

TEST(ReturnMapping, BadInputIsRefused) {
  EXPECT_THROW(BristleMetric::diagonal(1, 0, 1), std::invalid_argument);
  EXPECT_THROW(BristleMetric::diagonal(1, -1, 1), std::invalid_argument);
  EXPECT_THROW(BristleMetric::diagonal(1, 1, std::nan("")), std::invalid_argument);
  Matrix3 K = Matrix3::Identity();
  K(0, 1) = 0.1;
  EXPECT_THROW(BristleMetric{K}, std::invalid_argument);
  EXPECT_THROW(ReturnMapping(friction::PointLoad{}), std::invalid_argument);
  const ReturnMapping mapping(friction::Rectangle::of_sides(0.04, 0.02));
  const Returned r = mapping({std::nan(""), 0, 0}, 1, BristleMetric::diagonal(1, 1, 1));
  EXPECT_TRUE(std::isnan(r.wrench.value.fx));
  EXPECT_TRUE(std::isinf(r.wrench.force_error));
  for (const double limit : {std::nan(""), HUGE_VAL, -1.}) {
    EXPECT_TRUE(std::isnan(mapping({1e-3, 0, 0}, limit, BristleMetric::diagonal(1, 1, 1)).wrench.value.fx)) << limit;
  }
}

}  // namespace
}  // namespace patchgrip::dynamics
