// Stribeck's excess is within the error that it carries, against other ways to the same number.
#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>

#include <patchgrip/friction/hertz_ellipse.h>
#include <patchgrip/friction/line_load.h>
#include <patchgrip/friction/local_stribeck.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/ring.h>
#include <patchgrip/tests/friction/local_motions.h>
#include <patchgrip/tests/friction/shapes.h>
#include <patchgrip/tests/friction/within_error.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction {
namespace {

using patchgrip::testing::cases;
using patchgrip::testing::log_uniform;
using patchgrip::testing::uniform;

TEST(LocalStribeckError, OfAUniformEllipseIsWithinItsError) {
  std::mt19937_64 engine(20060301);
  for (int i = cases(60); i > 0; --i) {
    const double a = log_uniform(engine, 1e-3, 10), b = i % 2 ? a : a * log_uniform(engine, 0.1, 10);
    const Twist u = random_twist(engine, a, b);
    expect_within_error(stribeck_excess(PowerEllipse::of_semi_axes(a, b, 0.5), u), uniform_ellipse_excess(a, b, u),
                        std::max(a, b), 1e-14);
  }
}

// Down to needles: slow against v_S it is grad D, which is known to some units.
TEST(LocalStribeckError, OfASlowSlenderEllipseIsTheGradient) {
  std::mt19937_64 engine(20060307);
  for (int i = cases(10); i > 0; --i) {
    const double aspect = log_uniform(engine, 10, 1e6), a = i % 2 ? 1 : 1 / aspect, b = i % 2 ? 1 / aspect : 1;
    const HertzEllipse patch = HertzEllipse::of_semi_axes(a, b);
    const Twist v = random_twist(engine, a, b), u{1e-10 * v.vx, 1e-10 * v.vy, 1e-10 * v.w};
    const BoundedWrench found = stribeck_excess(patch, u), exact = patch.bounded_gradient(u);
    const double speed2 = 1e-20 * std::pow(std::hypot(v.vx, v.vy) + std::fabs(v.w), 2);
    EXPECT_LE(std::hypot(found.value.fx - exact.value.fx, found.value.fy - exact.value.fy),
              found.force_error + exact.force_error + speed2);
    EXPECT_LE(std::fabs(found.value.m - exact.value.m), found.moment_error + exact.moment_error + speed2);
    EXPECT_LE(found.force_error, 1e-12);
    EXPECT_LE(found.moment_error, 1e-12);
  }
}

// Infinite pressure at the rim, of which the projection is infinite too.
TEST(LocalStribeckError, OfARingIsWithinItsError) {
  std::mt19937_64 engine(20060308);
  for (int i = cases(100); i > 0; --i) {
    const double a = log_uniform(engine, 1e-3, 10);
    const Twist u = random_twist(engine, a, a);
    expect_within_error(stribeck_excess(Ring::of_radius(a), u), ring_excess(a, u), a, 1e-14);
  }
}

// Twists of which V + W is no double, and beyond the last cut; past the doubles there is no motion.
TEST(LocalStribeckError, OfAFastRingIsWithinItsError) {
  const Ring ring = Ring::of_radius(1);
  for (const double W : {0.4, 2.0, 20.0}) {
    for (const double ahead : {6.4, 6.45, 6.5, 6.6, 7.0}) {
      const Twist u{W + ahead, 0, W};
      expect_within_error(stribeck_excess(ring, u), ring_excess(1, u), 1, 1e-14);
    }
  }
  for (const Twist& u : {Twist{1.7e308, 0, 1.7e308}, Twist{1.2e308, -1.5e308, 1}, Twist{1, 0, -1.7e308}}) {
    const BoundedWrench g = stribeck_excess(ring, u);
    EXPECT_TRUE(g.value.fx == 0 && g.value.fy == 0 && g.value.m == 0);
    EXPECT_LE(std::max(g.force_error, g.moment_error), 1e-100);
  }
  const double nan = std::nan("");
  for (const Twist& u : {Twist{INFINITY, 0, 1}, Twist{1, 0, -INFINITY}, Twist{nan, 1, 1}, Twist{1, 1, nan}}) {
    const BoundedWrench g = stribeck_excess(ring, u);
    EXPECT_TRUE(std::isnan(g.value.fx) && std::isnan(g.value.m) && std::isnan(g.force_error));
  }
}

// Next to a ring, to a flat punch, and up to the largest exponent.
TEST(LocalStribeckError, OfAPowerDiscIsWithinItsError) {
  std::mt19937_64 engine(20060309);
  for (int i = cases(16); i > 0; --i) {
    const double n = i % 3 == 0   ? -0.5 + log_uniform(engine, 1e-6, 0.1)
                     : i % 3 == 1 ? uniform(engine, -0.4, 1.5)
                                  : log_uniform(engine, 1.5, 20);
    const double a = log_uniform(engine, 1e-3, 10);
    const Twist u = random_twist(engine, a, a);
    expect_within_error(stribeck_excess(PowerDisc::of_radius(a, n), u), power_ellipse_excess(a, a, n, u), a, 1e-14);
  }
}

TEST(LocalStribeckError, OfAPowerEllipseIsWithinItsError) {
  std::mt19937_64 engine(20060302);
  for (int i = cases(16); i > 0; --i) {
    const double n = i % 4 == 0 ? 0 : i % 4 == 1 ? 1 : uniform(engine, 0, 4);
    const double a = log_uniform(engine, 1e-3, 10), b = a * log_uniform(engine, 0.1, 10);
    const Twist u = random_twist(engine, a, b);
    expect_within_error(stribeck_excess(PowerEllipse::of_semi_axes(a, b, n), u), power_ellipse_excess(a, b, n, u),
                        std::max(a, b), 1e-14);
  }
}

// Two results of the quadrature agree in thirteen digits by chance, and are off by as much.
TEST(LocalStribeckError, OfANeedleIsWithinItsErrorWhereResultsAgreeByChance) {
  const struct {
    double a, b;
    Twist u;
  } needles[] = {{0x1.becc6775427d4p-7,
                  0x1.67d401012ade1p+13,
                  {-0x1.55ecc8c64c0b7p-3, 0x1.24e46c9aeed28p-22, 0x1.26a80b8bbc14ep-16}},
                 {0x1.b328001d804a1p-3,
                  0x1.0f9e1ec43511ep+13,
                  {0x1.1f7c1862132c9p-3, -0x1.173b2c9f56756p-19, 0x1.c59419900ea86p-16}}};
  for (const auto& [a, b, u] : needles) {
    expect_within_error(stribeck_excess(PowerEllipse::of_semi_axes(a, b, 0), u), power_ellipse_excess(a, b, 0, u), b,
                        2e-14);
  }
}

// Poles about the line, down to 1e-16 of its length beside it, and far away.
// A pole 5e-7 inside the rim of a flat punch, where two results of the judge agree by chance; by mpmath with 40 digits.
TEST(LocalStribeckError, OfAPunchIsRightNextToItsRim) {
  const double a = 0.0010039948624520128;
  const Twist u{0.01096757710341225, 0.016956593435293429, -20.11405807152266};
  constexpr Long exact = -0.0003938163248615415762949223L;
  EXPECT_LE(std::fabs(power_ellipse_excess(a, a, 0, u).m - exact), 1e-17L * a);
  const BoundedWrench found = stribeck_excess(PowerEllipse::of_semi_axes(a, a, 0), u);
  EXPECT_LE(std::fabs(found.value.m - exact), found.moment_error);
}

TEST(LocalStribeckError, OfALineIsWithinItsError) {
  std::mt19937_64 engine(20060310);
  for (int i = cases(300); i > 0; --i) {
    const double L = log_uniform(engine, 1e-3, 10), width = i % 2 ? L / 2 : L * log_uniform(engine, 1e-16, 1);
    const Twist u = random_twist(engine, L / 2, width);
    expect_within_error(stribeck_excess(LineLoad::of_length(L), u), line_excess(L, u), L, 1e-14);
  }
}

// Across the line the integral is one of the speed alone: sqrt(pi) / 2 (erf q_1 - erf q_0) / w L, q_i at the ends.
TEST(LocalStribeckError, OfALineAcrossItIsThatOfItsEnds) {
  using patchgrip::testing::Exact;
  std::mt19937_64 engine(20060311);
  for (int i = cases(300); i > 0; --i) {
    const double L = log_uniform(engine, 1e-3, 10);
    const double w = log_uniform(engine, 1e-6, 1e6) / L, vx = i % 3 ? log_uniform(engine, 1e-30, 10) : 0;
    const double vy = uniform(engine, -2, 2) * w * L;
    const auto speed = [&](double x) { return Exact(sqrt(Exact(vx) * vx + pow(vy + Exact(w) * x, 2))); };
    const Exact root = sqrt(boost::math::constants::pi<Exact>()) / 2;
    const Exact exact = root * (erf(speed(L / 2)) - erf(speed(-L / 2))) / (Exact(w) * L);
    const BoundedWrench found = stribeck_excess(LineLoad::of_length(L), {vx, vy, w});
    EXPECT_LE(static_cast<double>(abs(found.value.fy - exact)), found.force_error) << vx << ' ' << vy << ' ' << w;
    EXPECT_LE(found.force_error, 1e-14);
  }
}

// Turning too slowly for its points to differ, and too slowly for v_S to matter.
TEST(LocalStribeckError, OfALineThatHardlyTurns) {
  const LineLoad line = LineLoad::of_length(0.01);
  const BoundedWrench still = stribeck_excess(line, {0.7, 0.3, 0});
  for (const double w : {5e-324, -1e-308, 1e-289, 1e-280, -1e-200, 1e-30}) {
    const BoundedWrench g = stribeck_excess(line, {0.7, 0.3, w});
    EXPECT_NEAR(g.value.fx, still.value.fx, g.force_error) << w;
    EXPECT_NEAR(g.value.fy, still.value.fy, g.force_error) << w;
    EXPECT_NEAR(g.value.m, 0, g.moment_error) << w;
    EXPECT_LE(g.force_error, 1e-14) << w;
  }
  for (const double slow : {1e-9, 1e-11, 1e-100, 1e-300}) {
    const Twist u{0.7 * slow, -0.3 * slow, 90 * slow};
    const BoundedWrench g = stribeck_excess(line, u), exact = line.bounded_gradient(u);
    EXPECT_NEAR(g.value.fx, exact.value.fx, g.force_error + slow * slow) << slow;
    EXPECT_NEAR(g.value.fy, exact.value.fy, g.force_error + slow * slow) << slow;
    EXPECT_NEAR(g.value.m, exact.value.m, g.moment_error + slow * slow) << slow;
  }
}

TEST(LocalStribeckError, OfALineAtNoMotionIsNotANumber) {
  const double nan = std::nan("");
  for (const Twist& u : {Twist{nan, 0.3, 1}, Twist{0.7, nan, 1}, Twist{0.7, 0.3, nan}, Twist{nan, 0.3, 0}}) {
    const BoundedWrench g = stribeck_excess(LineLoad::of_length(0.01), u);
    EXPECT_TRUE(std::isnan(g.value.fx) && std::isnan(g.value.fy) && std::isnan(g.value.m));
  }
}

TEST(LocalStribeckError, OfALineWithThePoleOnItIsThatNextToIt) {
  const LineLoad line = LineLoad::of_length(2);
  for (const double x : {0.0, 0.3, 1.0, 5.0}) {
    const Wrench on = stribeck_excess(line, {0, -x, 1}).value, next = stribeck_excess(line, {1e-200, -x, 1}).value;
    EXPECT_EQ(on.fx, 0);
    EXPECT_LE(next.fx, 1e-197);
    EXPECT_EQ(on.fy, next.fy);
    EXPECT_EQ(on.m, next.m);
  }
}

TEST(LocalStribeckError, OfAPolygonIsWithinItsError) {
  std::mt19937_64 engine(20060303);
  for (const Shape& shape : {triangle, l_shape, slender_10}) {
    const Polygon patch = shape.patch();
    const PressureMoments s = patch.moments();
    double radius = 0;
    for (const Point& p : shape.outer) radius = std::max(radius, std::hypot(p.x - s.x, p.y - s.y));
    for (int i = cases(20); i > 0; --i) {
      const Twist c = random_twist(engine, radius, radius), u{c.vx + c.w * s.y, c.vy - c.w * s.x, c.w};
      expect_within_error(stribeck_excess(patch, u), polygon_excess(shape.rings(), s, u), radius + std::hypot(s.x, s.y),
                          1e-12);
    }
  }
}

}  // namespace
}  // namespace patchgrip::friction
