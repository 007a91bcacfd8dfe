#include <patchgrip/friction/line_load.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include <patchgrip/friction/kernels/line_motion.h>
#include <patchgrip/friction/limit_surface/limit_surface.h>
#include <patchgrip/friction/placed.h>
#include <patchgrip/friction/point_load.h>
#include <patchgrip/friction/rectangle.h>
#include <patchgrip/friction/several.h>
#include <patchgrip/tests/friction/frame_reference.h>
#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/line_reference.h>
#include <patchgrip/tests/support/cases.h>

namespace patchgrip::friction {
namespace {

using ::patchgrip::testing::cases;
using ::patchgrip::testing::log_uniform;
using ::patchgrip::testing::uniform;
using ::testing::ThrowsMessage;

constexpr double unit = 0x1p-53;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const std::vector<Twist> somewhere{{0.3, 0.2, 1}, {0.01, 0.1, -1}, {2, 3, 0.5}, {0.7, -0.2, 3}, {1e-8, 0.4, 1}};

Wrench50 kernel_wrench(const Twist& v, double length) {
  const kernels::LineMotion<Real50> m(v.vx, v.vy, v.w, length);
  return {2 * v.vx / m.Q * m.A, m.nu, (v.w < 0 ? -1 : 1) * Real50(length) / 4 * m.x * m.eta2 * m.gamma};
}

double distance(const Wrench50& a, const Wrench50& b) {
  return static_cast<double>(abs(a.fx - b.fx) + abs(a.fy - b.fy) + abs(a.m - b.m));
}

// (4.45) and (4.47) by quadrature, split at the foot of the pole.
TEST(LineLoad, IsTheIntegralOverItsPoints) {
  const Real50 L = 1.25;
  boost::math::quadrature::tanh_sinh<Real50> quadrature(15);
  for (const Twist& v : somewhere) {
    const Real50 foot = -Real50(v.vy) / v.w;
    const auto integral = [&](const auto& of_speed_and_place) {
      const auto f = [&](const Real50& x) {
        const Real50 s = v.vy + v.w * x;
        return Real50(of_speed_and_place(s, x) / sqrt(v.vx * Real50(v.vx) + s * s));
      };
      if (abs(foot) >= L / 2) return Real50(quadrature.integrate(f, Real50(-L / 2), Real50(L / 2)) / L);
      return Real50((quadrature.integrate(f, Real50(-L / 2), foot) + quadrature.integrate(f, foot, Real50(L / 2))) / L);
    };
    const Wrench50 g{integral([&](const Real50&, const Real50&) { return Real50(v.vx); }),
                     integral([&](const Real50& s, const Real50&) { return s; }),
                     integral([&](const Real50& s, const Real50& x) { return Real50(s * x); })};
    const double tolerance = v.vx < 1e-3 ? 1e-25 : 1e-45;  // the quadrature sees a pole next to the line less well
    EXPECT_LE(distance(g, LineReference(1.25).gradient(v)), tolerance) << v.vx;
    EXPECT_LE(distance(LineReference(1.25).gradient(v), kernel_wrench(v, 1.25)), 1e-47) << v.vx;
  }
}

// Poles about the line, close to it and to its ends, on its axes, far away.
Twist draw_twist(std::mt19937_64& engine, double L, int kind) {
  const double side = uniform(engine, -1, 1) < 0 ? -1 : 1, angle = uniform(engine, 0, 6.3);
  const double spin = side * log_uniform(engine, 1e-3, 1e3);
  switch (kind % 5) {
    case 0:
      return twist_about({L * uniform(engine, -0.6, 0.6), side * L * log_uniform(engine, 1e-18, 1)}, spin);
    case 1: {
      const double off = L * log_uniform(engine, 1e-16, 1);
      return twist_about({side * L / 2 + off * std::cos(angle), off * std::sin(angle)}, spin);
    }
    case 2:
      return twist_about({side * L * log_uniform(engine, 1e-18, 1), L * log_uniform(engine, 1e-3, 1e3)}, spin);
    case 3: {
      const double r = L * log_uniform(engine, 1e-8, 1e8);
      return twist_about({r * std::cos(angle), r * std::sin(angle)}, spin);
    }
    default:
      return twist_about({L * uniform(engine, -2, 2), L * uniform(engine, -2, 2)}, spin);
  }
}

TEST(LineLoad, IsWithinItsBoundsAtEveryPole) {
  std::mt19937_64 engine(20060103);
  for (int i = 0; i < cases(2000); ++i) {
    const double L = log_uniform(engine, 1e-3, 10);
    const Twist v = draw_twist(engine, L, i);
    const BoundedWrench g = LineLoad::of_length(L).bounded_gradient(v);
    const Wrench50 e = LineReference(L).gradient(v);
    ASSERT_LE(static_cast<double>(hypot(g.value.fx - e.fx, g.value.fy - e.fy)), g.force_error) << v.vx << ' ' << v.vy;
    ASSERT_LE(static_cast<double>(abs(g.value.m - e.m)), g.moment_error) << v.vx << ' ' << v.vy << ' ' << v.w;
    ASSERT_LE(g.force_error, 13 * unit);
    ASSERT_LE(g.moment_error, 17 * unit * std::fabs(g.value.m));
  }
}

// The squares of such speeds do not exist, and the reference would cancel.
TEST(LineLoad, KeepsItsDigitsWhereSquaresUnderflow) {
  const LineLoad line = LineLoad::of_length(2);
  for (const Twist& v : {Twist{1e-200, 0.25, 1}, Twist{1e-300, 0, -1}, Twist{1e-170, 1e-200, 1e-160},
                         Twist{3e-250, 1 + 1e-16, 1}, Twist{1e250, 2e250, 1e251}}) {
    const BoundedWrench g = line.bounded_gradient(v);
    const Wrench50 e = kernel_wrench(v, 2);
    EXPECT_LE(static_cast<double>(abs(g.value.fx - e.fx)), 12 * unit * std::fabs(g.value.fx)) << v.vx;
    EXPECT_LE(static_cast<double>(abs(g.value.fy - e.fy)), g.force_error) << v.vx;
    EXPECT_LE(static_cast<double>(abs(g.value.m - e.m)), g.moment_error) << v.vx;
  }
}

TEST(LineLoad, HessianEqualsDifferencesOfTheExactGradient) {
  std::mt19937_64 engine(20060103);
  for (int i = 0; i < cases(200); ++i) {
    const double L = log_uniform(engine, 1e-3, 10);
    const Twist v = draw_twist(engine, L, 3 + i % 2);
    const LineReference reference(L);
    const auto gradient = [&](const Real50& vx, const Real50& vy, const Real50& w) {
      return reference.gradient(vx, vy, w);
    };
    const Pole M{-v.vy / v.w, v.vx / v.w};
    if (std::fabs(M.y) < 1e-4 * L) continue;  // the differences reach across the line
    const Hessian exact = hessian_by_differences(gradient, v, L), h = LineLoad::of_length(L).hessian(v);
    ASSERT_LE(scaled_difference(h, exact, v, L), 3e-15 * scaled_size(exact, v, L)) << M.x / L << ' ' << M.y / L;
  }
}

// Next to the line only the curvature along it grows: H_xx ~ (2 / l) ln(1 / distance).
TEST(LineLoad, HessianNextToTheLineIsLargeAndFinite) {
  const LineLoad line = LineLoad::of_length(2);
  for (const double d : {1e-12, 1e-100, 1e-200, 1e-300}) {
    const Hessian h = line.hessian({d, 0, 1});
    EXPECT_NEAR(h.xx, std::log(2 / d) - 1, 1e-13 * h.xx);
    EXPECT_NEAR(h.yy, 1, 1e-15 + d);
    EXPECT_EQ(h.xy, 0);
  }
}

TEST(LineLoad, HessianOnTheLineIsRefusedAndBeyondItsEndsIsNot) {
  const LineLoad line = LineLoad::of_length(2);
  const auto hessian = [&](const Twist& v) { return [&, v] { line.hessian(v); }; };
  const char* message = "twist has its pole on the line load: the Hessian of D is infinite there";
  for (const Twist& v : {Twist{0, 0, 1}, Twist{0, 0.5, -1}, Twist{0, 1, 1}, Twist{0, -3, 3}}) {
    EXPECT_THAT(hessian(v), ThrowsMessage<std::domain_error>(message));
  }
  EXPECT_THAT(hessian({}),
              ThrowsMessage<std::domain_error>("twist = 0 is not allowed: the Hessian of D exists only in motion"));
  const Hessian h = line.hessian({0, 3, 1});
  EXPECT_NEAR(h.xx, std::log(2) / 2, 1e-15);  // mean of 1 / |v_P|
  EXPECT_EQ(h.yy, 0);
  EXPECT_EQ(h.ww, 0);
}

TEST(LineLoad, AboutItsCentreAndItsEndsItTurnsAgainstHalfAndNoneOfItsHalfLength) {
  const LineLoad line = LineLoad::of_length(2);
  const Wrench centre = line.gradient({0, 0, 3}), end = line.gradient(twist_about({1, 0}, -3));
  EXPECT_TRUE(centre.fx == 0 && centre.fy == 0);
  EXPECT_NEAR(centre.m, 0.5, unit);
  EXPECT_TRUE(end.fx == 0 && end.m == 0);
  EXPECT_NEAR(end.fy, 1, unit);
}

TEST(LineLoad, AllPolesBeyondItsEndsShareOneForce) {
  const LineLoad line = LineLoad::of_length(2);
  for (const double x : {1.0, 1 + 1e-15, 2.0, 1e6}) {
    const Wrench g = line.gradient(twist_about({-x, 0}, 1)), h = line.gradient(twist_about({x, 0}, 1));
    EXPECT_TRUE(g.fx == 0 && g.m == 0 && h.fx == 0 && h.m == 0) << x;
    EXPECT_NEAR(g.fy, 1, 2 * unit) << x;
    EXPECT_NEAR(h.fy, -1, 2 * unit) << x;
  }
}

// Its limit surface: two corners, no facet.
TEST(LineLoad, CornersAreTold) {
  const LimitSurface surface(LineLoad::of_length(2));
  const Gauge g = surface.gauge({0, 2, 0});
  EXPECT_EQ(g.status, GaugeStatus::ridge);
  EXPECT_NEAR(g.value, 2, 1e-15);
  EXPECT_EQ(surface.gauge({0.3, 1, 0.1}).status, GaugeStatus::converged);
  EXPECT_EQ(surface.gauge({1, 0, 0}).status, GaugeStatus::converged);
  EXPECT_EQ(surface.gauge({1, 0, 0}).value, 1);
  // A pure moment is held by as much as turns the line about its centre.
  EXPECT_NEAR(surface.gauge({0, 0, 1}).value, 2, 1e-12);
  // The section fy, m with the pole on the line: m = (L / 4)(1 - fy^2).
  for (const double fy : {0.1, 0.5, 0.9, 0.999}) {
    const Gauge section = surface.gauge({0, fy, (1 - fy * fy) / 2});
    EXPECT_NEAR(section.value, 1, 1e-12) << fy;
    EXPECT_NEAR(-section.twist.vy / section.twist.w, -fy, 1e-6) << fy;
  }
}

TEST(LineLoad, IsTheLimitOfARectangleWithoutWidth) {
  const LineLoad line = LineLoad::of_length(2);
  for (const Twist& v : {Twist{0.3, 0.2, 1}, Twist{2, 3, 0.5}, Twist{0.05, -0.4, -1}}) {
    double last = 1;
    for (const double width : {1e-1, 1e-2, 1e-3, 1e-4}) {
      const Wrench g = line.gradient(v), h = Rectangle::of_sides(2, width).gradient(v);
      const double apart = std::hypot(g.fx - h.fx, g.fy - h.fy) + std::fabs(g.m - h.m);
      EXPECT_LE(apart, 4 * width * width / (v.vx * v.vx)) << width;  // of second order
      EXPECT_LE(apart, last / 50) << width;
      last = apart;
    }
  }
}

TEST(LineLoad, IsTheLimitOfManyPoints) {
  std::vector<Several::Part> parts;
  for (int i = 0; i < 400; ++i) parts.push_back({Placed(PointLoad{}, -1 + (i + 0.5) / 200, 0), 1});
  const Several points = Several::of_parts(parts);
  const LineLoad line = LineLoad::of_length(2);
  for (const Twist& v : {Twist{0.3, 0.2, 1}, Twist{2, 3, 0.5}, Twist{0.25, -0.4, -1}}) {
    const Wrench g = line.gradient(v), h = points.gradient(v);
    EXPECT_NEAR(g.fx, h.fx, 1e-5);
    EXPECT_NEAR(g.fy, h.fy, 1e-5);
    EXPECT_NEAR(g.m, h.m, 1e-5);
  }
  EXPECT_NEAR(points.moments().polar, line.moments().polar, 1e-5);
}

TEST(LineLoad, HalvesOfALineAreTheLine) {
  const LineLoad line = LineLoad::of_length(2), half = LineLoad::of_length(1);
  const Several halves = Several::of_parts({{Placed(half, -0.5, 0), 1}, {Placed(half, 0.5, 0), 1}});
  for (const Twist& v : somewhere) {
    const Wrench g = line.gradient(v), h = halves.gradient(v);
    EXPECT_NEAR(g.fx, h.fx, 1e-15);
    EXPECT_NEAR(g.fy, h.fy, 1e-15);
    EXPECT_NEAR(g.m, h.m, 1e-15);
    EXPECT_LE(scaled_difference(line.hessian(v), halves.hessian(v), v, 2), 1e-14 * scaled_size(line.hessian(v), v, 2));
  }
  EXPECT_DOUBLE_EQ(halves.moments().polar, line.moments().polar);
}

TEST(LineLoad, ItsAxesAreThoseOfItsLaws) {
  const LineLoad line = LineLoad::of_length(0.7);
  for (const Twist& v : somewhere) {
    const Wrench g = line.gradient(v), x = line.gradient({-v.vx, v.vy, v.w}), y = line.gradient({v.vx, -v.vy, v.w});
    EXPECT_TRUE(x.fx == -g.fx && x.fy == g.fy && x.m == g.m);
    EXPECT_TRUE(y.fx == g.fx && y.fy == -g.fy && y.m == g.m);
  }
}

TEST(LineLoad, AtRestItAnswersTheLeastSubgradient) {
  const BoundedWrench g = LineLoad::of_length(1).bounded_gradient({});
  EXPECT_TRUE(g.value.fx == 0 && g.value.fy == 0 && g.value.m == 0 && g.force_error == 0 && g.moment_error == 0);
  EXPECT_EQ(LineLoad::of_length(1).dissipation({}), 0);
}

TEST(LineLoad, MotionsThatAreNotFiniteAreAnsweredByNotANumber) {
  for (const Twist& v : {Twist{nan, 0, 1}, Twist{0, infinity, 1}, Twist{1, 0, -infinity}}) {
    EXPECT_TRUE(std::isnan(LineLoad::of_length(1).gradient(v).fx)) << v.vx;
    EXPECT_TRUE(std::isnan(LineLoad::of_length(1).dissipation(v))) << v.vx;
  }
}

TEST(LineLoad, LengthsThatAreNoneAreRefused) {
  const auto of_length = [](double L) { return [L] { LineLoad::of_length(L); }; };
  EXPECT_THAT(of_length(0),
              ThrowsMessage<std::invalid_argument>("length = 0 is not allowed: must be positive and finite"));
  for (const double L : {-1.0, nan, infinity}) EXPECT_THROW(of_length(L)(), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::friction
