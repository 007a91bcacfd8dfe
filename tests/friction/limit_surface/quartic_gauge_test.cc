// Convex quartics for the limit surface: the proof of convexity, proven sides, and the laws of a convex body.
#include <patchgrip/friction/limit_surface/quartic_gauge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <patchgrip/friction/limit_surface/ellipsoid_gauge.h>
#include <patchgrip/tests/friction/limit_surface/cheap_gauges.h>

namespace patchgrip::friction {
namespace {

// (x^2 + y^2 + z^2)^2 + k x^2 y^2
QuarticForm with_saddle(double k) {
  QuarticForm q{};
  q.c[0] = q.c[10] = q.c[14] = 1;
  q.c[3] = 2 + k;
  q.c[5] = q.c[12] = 2;
  return q;
}

Wrench direction(std::mt19937_64& engine) {
  std::normal_distribution<double> normal;
  const Wrench t{normal(engine), normal(engine), normal(engine)};
  return scaled(1 / std::sqrt(t.fx * t.fx + t.fy * t.fy + t.m * t.m), t);
}

double curvature(const QuarticForm& q, const Wrench& t, const Wrench& y) {
  const Hessian h = q.hessian(t, t);
  return y.fx * (h.xx * y.fx + 2 * h.xy * y.fy + 2 * h.xw * y.m) + y.fy * (h.yy * y.fy + 2 * h.yw * y.m) +
         h.ww * y.m * y.m;
}

// q, its gradient and its Hessian in the order xx, xy, xw, yy, yw, ww, term by term in T.
template <class T>
std::array<T, 10> term_by_term(const QuarticForm& q, const Wrench& t) {
  const T x = t.fx, y = t.fy, z = t.m;
  std::array<T, 10> sums{};
  std::size_t k = 0;
  for (int i = 4; i >= 0; --i) {
    for (int j = 4 - i; j >= 0; --j, ++k) {
      const std::array<int, 3> degrees{i, j, 4 - i - j};
      const auto add = [&](std::size_t at, std::array<int, 3> taken) {
        T term = q.c[k];
        for (std::size_t a = 0; a < 3; ++a) {
          for (int d = 0; d < degrees[a]; ++d) term *= d < taken[a] ? T(degrees[a] - d) : a == 0 ? x : a == 1 ? y : z;
          if (taken[a] > degrees[a]) term = 0;
        }
        sums[at] += term;
      };
      add(0, {0, 0, 0});
      add(1, {1, 0, 0});
      add(2, {0, 1, 0});
      add(3, {0, 0, 1});
      add(4, {2, 0, 0});
      add(5, {1, 1, 0});
      add(6, {1, 0, 1});
      add(7, {0, 2, 0});
      add(8, {0, 1, 1});
      add(9, {0, 0, 2});
    }
  }
  return sums;
}

TEST(QuarticForm, IsGoodToAFewUnitsOfItsTerms) {
  std::mt19937_64 engine(14);
  double worst = 0;
  for (int i = 0; i < testing::cases(2000); ++i) {
    QuarticForm q{}, sizes{};
    for (std::size_t k = 0; k < q.c.size(); ++k) {
      q.c[k] = testing::uniform(engine, -1, 1) * std::exp2(testing::uniform(engine, -20, 20));
      sizes.c[k] = std::fabs(q.c[k]);
    }
    Wrench t = direction(engine);
    t.fy *= std::exp2(testing::uniform(engine, -20, 0));
    t.m *= std::exp2(testing::uniform(engine, -20, 0));
    const auto truth = term_by_term<long double>(q, t);
    const auto size = term_by_term<double>(sizes, {std::fabs(t.fx), std::fabs(t.fy), std::fabs(t.m)});
    const Twist g = q.gradient(t);
    const Hessian h = q.hessian(t, t);
    const std::array<double, 10> seen{q(t), g.vx, g.vy, g.w, h.xx, h.xy, h.xw, h.yy, h.yw, h.ww};
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double error = static_cast<double>(std::fabs(static_cast<long double>(seen[k]) - truth[k])) / size[k];
      worst = std::max(worst, error / 0x1p-53);
    }
  }
  EXPECT_LE(worst, 8);  // 6.5 of 200 000
}

// x^4 + y^4 + 6 c x^2 y^2 is convex for 0 <= c <= 1; here c = (2 + k) / 6, and k = -2, 4 are the ends.
TEST(QuarticForm, ConvexFormsAreToldFromOthers) {
  for (const double k : {-1.999, -1.0, 0.0, 1.0, 3.999}) EXPECT_TRUE(is_certainly_convex(with_saddle(k))) << k;
  for (const double k : {-5.0, -2.001, 4.001, 30.0}) EXPECT_FALSE(is_certainly_convex(with_saddle(k))) << k;
  EXPECT_FALSE(is_certainly_convex({}));
}

TEST(QuarticForm, ProvenConvexHasNoNegativeCurvatureAndRefusedHas) {
  std::mt19937_64 engine(5);
  int convex = 0, refused = 0;
  for (int i = 0; i < testing::cases(200); ++i) {
    QuarticForm q = with_saddle(0);
    for (double& c : q.c) c += testing::uniform(engine, -1, 1);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3000; ++k) least = std::min(least, curvature(q, direction(engine), direction(engine)));
    if (is_certainly_convex(q)) {
      ++convex;
      EXPECT_GE(least, 0);
    } else {
      ++refused;
      EXPECT_LE(least, 0.5);  // of 4 to 12 for the sphere: samples come close to the worst, no closer
    }
  }
  EXPECT_GE(convex, testing::cases(20));
  EXPECT_GE(refused, testing::cases(20));
}

TEST(QuarticForm, DerivativesAreThoseOfTheValue) {
  std::mt19937_64 engine(9);
  for (int i = 0; i < testing::cases(300); ++i) {
    QuarticForm q{};
    for (double& c : q.c) c = testing::uniform(engine, -1, 1);
    const Wrench t = direction(engine), s = direction(engine);
    const auto row = QuarticForm::monomials(t);
    double value = 0;
    for (std::size_t k = 0; k < row.size(); ++k) value += q.c[k] * row[k];
    EXPECT_NEAR(q(t), value, 1e-14);
    EXPECT_NEAR(power(t, q.gradient(t)), 4 * value, 1e-13);
    EXPECT_NEAR(curvature(q, t, t), 12 * value, 1e-13);
    // Exact for a quartic: five points.
    const auto along = [&](double h) { return q(sum(t, scaled(h, s))); };
    EXPECT_NEAR(power(s, q.gradient(t)), (8 * (along(0.5) - along(-0.5)) - (along(1) - along(-1))) / 6, 1e-12);
    EXPECT_NEAR(curvature(q, t, s), (16 * (along(0.5) + along(-0.5)) - (along(1) + along(-1)) - 30 * along(0)) / 3,
                1e-12);
  }
}

TEST(QuarticGauge, ErrsByNoMoreThanItSaysAndByAsMuchAndByLessThanAnyEllipsoid) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    SCOPED_TRACE(kind);
    const auto least_squares = QuarticGauge::least_squares(patch), even = QuarticGauge::even(patch);
    for (const auto& gauge : {least_squares, even}) {
      const GaugeSides seen = judge(gauge, patch, testing::cases(500));
      if (testing::all_cases()) {
        EXPECT_GE(seen.largest_excess, 0.8 * gauge.largest_excess() - 1e-3);
        EXPECT_GE(seen.largest_deficit, 0.8 * gauge.largest_deficit() - 1e-3);
      }
      EXPECT_LE(gauge.slack(), 1.3e-5);
      judge(gauge.safe(), patch, testing::cases(40));
      judge(gauge.outer(), patch, testing::cases(40));
      EXPECT_LE(gauge.safe().largest_deficit(), 1e-15);
      EXPECT_LE(gauge.outer().largest_excess(), 1e-15);
      EXPECT_LE(even.safe().largest_excess(), 1.02 * gauge.safe().largest_excess());
    }
    EXPECT_LE(even.safe().largest_excess(), 0.6 * EllipsoidGauge::even(patch).safe().largest_excess());
  });
}

TEST(QuarticGauge, OfAHertzDiscErrsByHalfAPercentEitherWay) {
  const auto hertz = QuarticGauge::even(HertzDisc::of_radius(1));
  EXPECT_NEAR(hertz.largest_excess(), 0.0046, 1e-4);
  EXPECT_NEAR(hertz.largest_deficit(), 0.0046, 1e-4);
}

TEST(QuarticGauge, IsAConvexBodyWithItsDissipation) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    SCOPED_TRACE(kind);
    const auto axes = CentredFrame::of(patch);
    expect_convex_body(QuarticGauge::least_squares(patch), axes, testing::cases(300));
    expect_convex_body(QuarticGauge::even(patch), axes, testing::cases(300));
  });
}

// Both ways to look at the same body: the slip of the load that balances a slip is that slip.
TEST(QuarticGauge, SlipOfTheWrenchOfASlipIsThatSlip) {
  const Rectangle patch = Rectangle::of_sides(0.04, 0.01);
  const auto gauge = QuarticGauge::even(patch);
  std::mt19937_64 engine(13);
  for (int i = 0; i < testing::cases(300); ++i) {
    const Wrench d = direction(engine);
    const Twist v{d.fx, d.fy, d.m / 0.01};
    const Twist n = gauge.twist(gauge.gradient(v));
    const double D = gauge.dissipation(v);
    EXPECT_NEAR(n.vx * D, v.vx, 1e-8);
    EXPECT_NEAR(n.vy * D, v.vy, 1e-8);
    EXPECT_NEAR(n.w * D, v.w, 1e-6);
  }
}

TEST(QuarticGauge, SizeAndPlaceOfThePatchMoveTheMomentAlone) {
  const auto unit = QuarticGauge::least_squares(l_shape.patch());
  const auto twice = QuarticGauge::least_squares(Polygon::uniform(scaled(l_ring, 2)));
  const auto away = QuarticGauge::least_squares(Placed(l_shape.patch(), 5, -7));
  EXPECT_NEAR(unit.largest_excess(), twice.largest_excess(), 1e-9);
  EXPECT_NEAR(unit.largest_deficit(), away.largest_deficit(), 1e-9);
  std::mt19937_64 engine(3);
  const auto axes = CentredFrame::of(l_shape.patch());
  for (int i = 0; i < 1000; ++i) {
    const Wrench t = random_load(engine, axes);
    const double g = unit.value(t);
    ASSERT_NEAR(twice.value({t.fx, t.fy, 2 * t.m}), g, 1e-9 * g);
    ASSERT_NEAR(away.value({t.fx, t.fy, t.m + 5 * t.fy + 7 * t.fx}), g, 1e-9 * g);
  }
}

TEST(QuarticGauge, HoldsOverTheWholeRangeOfDoubles) {
  for_every_kind([](const std::string& kind, const auto& patch) {
    SCOPED_TRACE(kind);
    expect_every_size(QuarticGauge::least_squares(patch), CentredFrame::of(patch));
  });
}

TEST(QuarticGauge, HasPartsThatArePointLoads) {
  const auto gauge = QuarticGauge::even(disc_and_point());
  judge(gauge, disc_and_point(), testing::cases(400));
  EXPECT_LE(gauge.slack(), 1.3e-5);
}

TEST(QuarticGauge, APointIsRefused) {
  EXPECT_THROW(QuarticGauge::even(PointLoad{}), std::invalid_argument);
  EXPECT_THROW(QuarticGauge::least_squares(Placed(PointLoad{}, 0.3, 0.1)), std::invalid_argument);
}

TEST(QuarticGauge, NoLoadAsksForNothingAndLoadsThatAreNotFiniteForNoNumber) {
  const auto gauge = QuarticGauge::least_squares(Rectangle::of_sides(1, 1));
  EXPECT_EQ(gauge.value({}), 0);
  EXPECT_EQ(gauge.gauge({}).upper, 0);
  EXPECT_EQ(gauge.twist({}).w, 0);
  EXPECT_EQ(gauge.dissipation({}), 0);
  const Gauge bad = gauge.gauge({0, 0, std::numeric_limits<double>::infinity()});
  EXPECT_TRUE(std::isnan(bad.value) && std::isnan(bad.lower) && std::isnan(bad.upper) && std::isnan(bad.twist.w));
  EXPECT_EQ(bad.status, GaugeStatus::not_finite);
}

}  // namespace
}  // namespace patchgrip::friction
