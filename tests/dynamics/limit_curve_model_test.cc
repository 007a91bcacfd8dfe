// Where the return mapping starts: near the root, and on what are polynomials themselves as near as a step leaves it.
#include <patchgrip/dynamics/limit_curve_model.h>

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/uniform_disc.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::dynamics {
namespace {

using testing::cases;
using testing::log_uniform;
using testing::uniform;

struct Place {
  double g, h;
};

// G and H of the trial a distance lambda off the curve at y.
template <class Curve>
Place trial_at(const Curve& curve, double y, double lambda, double kappa) {
  const Place p = curve(y);
  return {p.g + lambda * kappa * y, p.h + lambda};
}

template <std::size_t terms, class Curve>
void expect_near(const Curve& curve, double median, double most) {
  const LimitCurveModel<terms> model(curve);
  std::mt19937_64 engine(1);
  std::vector<double> off;
  for (int i = 0; i < cases(2000); ++i) {
    const double y = uniform(engine, 1e-3, 1), kappa = log_uniform(engine, 0.1, 10);
    const Place t = trial_at(curve, y, log_uniform(engine, 0.1, 10), kappa);
    const double found = model.root(t.g, t.h, kappa);
    ASSERT_GE(found, 0);
    ASSERT_LE(found, 1);
    off.push_back(std::fabs(found - y));
  }
  std::ranges::sort(off);
  EXPECT_LE(off[off.size() / 2], median);
  EXPECT_LE(off.back(), most);
}

// Tolerances are what 200 000 cases leave: medians of 5e-8, 3e-7, 7e-7 and 1e-6, and 9e-4 at most. They hold the
// model to what it is worth as a start; the root itself is found by Halley's method.
TEST(LimitCurveModel, StartsNearTheClosestPoint) {
  const auto hertz = friction::HertzDisc::of_radius(1).kernel();
  expect_near<3>([&](double x) { return Place{hertz.inside(x).f, hertz.inside(x).m}; }, 1e-7, 1e-3);
  expect_near<8>([&](double u) { return Place{hertz.outside(u).m, hertz.outside(u).f}; }, 1e-6, 1e-3);
  const auto uniform_disc = friction::UniformDisc::of_radius(1).kernel();
  expect_near<8>([&](double x) { return Place{uniform_disc.inside(x).f, uniform_disc.inside(x).m}; }, 1e-6, 1e-3);
  expect_near<8>([&](double u) { return Place{uniform_disc.outside(u).m, uniform_disc.outside(u).f}; }, 2e-6, 1e-3);
}

TEST(LimitCurveModel, IsExactWhereTheEquationIsLinear) {
  // g = 3 y, h = 2: T = 3 + kappa (H - 2), and a few units of rounding in y < 1.
  const LimitCurveModel<3> model([](double y) { return Place{3 * y, 2}; });
  EXPECT_NEAR(model.root(1.4, 3, 4), 0.2, 1e-15);
  EXPECT_EQ(model.root(0, 3, 4), 0);
  EXPECT_EQ(model.root(70, 3, 4), 1);
}

TEST(LimitCurveModel, CountsWhatIsNotANumberAsTheEnd) {
  const LimitCurveModel<3> model([](double y) { return Place{3 * y, 2}; });
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double H : {nan, infinity, -infinity}) {
    const double y = model.root(1, H, 1);
    EXPECT_TRUE(y >= 0 && y <= 1) << H;
  }
}

}  // namespace
}  // namespace patchgrip::dynamics
