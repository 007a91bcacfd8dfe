#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/sampled/corner_sums.h>
#include <patchgrip/friction/sampled/edge_jumps.h>
#include <patchgrip/friction/sampled/gauss_rule.h>
#include <patchgrip/friction/sampled/point_loads.h>
#include <patchgrip/friction/sampled/vector_log.h>
#include <patchgrip/tests/support/cases.h>
#include <patchgrip/tests/support/exact.h>

namespace patchgrip::friction::kernels {
namespace {

using testing::cases;
using testing::Exact;
using testing::log_uniform;
using testing::uniform;
using testing::units_of_rounding;

constexpr double unit = 0x1p-53;

std::vector<Lanes> all_lanes() {
  std::vector<Lanes> all{Lanes::two};
  if (widest_lanes() != Lanes::two) all.push_back(Lanes::four);
  if (widest_lanes() == Lanes::eight) all.push_back(Lanes::eight);
  return all;
}

TEST(VectorLog, IsGoodToTwoUnitsOfRounding) {
  std::mt19937_64 engine(1);
  double worst = 0;
  for (int i = 0; i < cases(20000); ++i) {
    const double x = i % 2 == 0 ? uniform(engine, 0.5, 2) : log_uniform(engine, 1e-300, 1e300);
    worst = std::max(worst, units_of_rounding(vector_log(x), log(Exact(x))));
  }
  EXPECT_LE(worst, 2);
  EXPECT_EQ(vector_log(1), 0);
}

TEST(VectorLog, TwoAtOnceAreGoodToSixUnitsOfRounding) {
  std::mt19937_64 engine(6);
  double worst = 0;
  for (int i = 0; i < cases(20000); ++i) {
    const double x = i % 2 == 0 ? uniform(engine, 0.5, 2) : log_uniform(engine, 1e-300, 1e300);
    const double y = log_uniform(engine, 1e-3, 1e3);
    const auto [of_x, of_y] = vector_logs(x, y);
    worst = std::max({worst, units_of_rounding(of_x, log(Exact(x))), units_of_rounding(of_y, log(Exact(y)))});
  }
  EXPECT_LE(worst, 6);
}

TEST(VectorLog, OfARatioKeepsTheDigitsOfSmallOnes) {
  std::mt19937_64 engine(2);
  double worst = 0;
  for (int i = 0; i < cases(20000); ++i) {
    const double z = log_uniform(engine, 1e-18, 0.9999);
    const double x = (1 + z) / (1 - z);
    const double units = units_of_rounding(vector_log_of_ratio(x, z), log((1 + Exact(z)) / (1 - Exact(z))));
    // From 1/8 on it is the logarithm of a rounded number.
    worst = std::max(worst, z < 0.125 ? units : units / 10);
  }
  EXPECT_LE(worst, 2);
}

TEST(GaussRule, IntegratesPolynomialsOfItsDegree) {
  for (int n = 1; n <= most_gauss_points; ++n) {
    double even = 0, odd = 0;
    for (const auto& [t, weight] : gauss_rule(n)) {
      even += weight * std::pow(t, 2 * n - 2);
      odd += weight * std::pow(t, 2 * n - 1);
    }
    EXPECT_NEAR(even, 2.0 / (2 * n - 1), 1e-15);
    EXPECT_NEAR(odd, 0, 1e-15);
  }
}

// A load anywhere in a box, near its rim and corners above all, against the loads in its place.
TEST(PointLoads, ErrorIsWithinItsBoundForALoadAnywhereInTheBox) {
  std::mt19937_64 engine(3);
  for (const int order : load_orders) {
    double tightest = 0;
    for (int c = 0; c < cases(20000); ++c) {
      const Box box{uniform(engine, -3, 3), uniform(engine, -3, 3), log_uniform(engine, 0.01, 1),
                    log_uniform(engine, 0.01, 1)};
      const double R = 1.5 * std::exp(uniform(engine, 0, engine() % 2 == 0 ? 0.01 : 3));
      const double angle = uniform(engine, -3.2, 3.2);
      const Twist v = twist_about(
          {box.x + R * box.half_diagonal() * std::cos(angle), box.y + R * box.half_diagonal() * std::sin(angle)}, -1);
      const auto place = [&] { return engine() % 3 == 0 ? uniform(engine, -1, 1) : engine() % 2 == 0 ? 1 : -1; };
      const double s = place(), t = place();
      std::vector<double> across(static_cast<std::size_t>(order)), along = across, loads;
      lagrange(order, s, across);
      lagrange(order, t, along);
      for (const double y : along) {
        for (const double x : across) loads.push_back(x * y);
      }
      LoadSums sums;
      load_kernels(order, widest_lanes()).gradient(loads.data(), box, v, sums);
      const double x = box.x + s * box.hx, y = box.y + t * box.hy;
      const double vx = v.vx - v.w * y, vy = v.vy + v.w * x, speed = std::hypot(vx, vy);
      const double fx = vx / speed - sums.gradient.fx, fy = vy / speed - sums.gradient.fy;
      // The moment about the middle of the box.
      const double m = (x * vy - y * vx) / speed - sums.gradient.m - (box.x * fy - box.y * fx);
      const double bound = load_error(order, R);
      EXPECT_LE(std::hypot(fx, fy), bound + 1e-14) << order << ' ' << R << ' ' << box.hx << ' ' << box.hy;
      EXPECT_LE(std::fabs(m), bound * box.half_diagonal() + 1e-13) << order << ' ' << R;
      if (bound > 1e-11) tightest = std::max(tightest, std::hypot(fx, fy) / bound);
    }
    EXPECT_GE(tightest, 0.02) << "a bound this loose would cost time";
  }
}

TEST(PointLoads, ReachIsWhereTheErrorIsTheTolerance) {
  for (const int order : load_orders) {
    for (const double tolerance : {1e-5, 1e-8, 1e-12}) {
      const double R = load_reach(order, tolerance);
      EXPECT_LE(load_error(order, R), tolerance * (1 + 1e-10));
      EXPECT_TRUE(R == 1.5 || load_error(order, 0.999 * R) >= tolerance);
    }
  }
}

// With w = 0 as with any twist: the three kinds of vectors, and the Hessian as the derivative of the gradient.
TEST(PointLoads, HessianIsTheDerivativeOfTheGradientAlsoOfTranslations) {
  std::mt19937_64 engine(4);
  const Box box{0.3, -0.2, 0.5, 0.4};
  std::vector<double> loads;
  for (int i = 0; i < 16 * 16; ++i) loads.push_back(uniform(engine, 0, 1) / 256);
  for (const Twist& v : {Twist{1, 0.4, 0}, Twist{-2, 1, 0.7}, Twist{0.2, 3, -1}}) {
    Hessian first{};
    for (const Lanes lanes : all_lanes()) {
      const LoadKernels kernels = load_kernels(16, lanes);
      const auto gradient = [&](double dx, double dy, double dw) {
        LoadSums sums;
        kernels.gradient(loads.data(), box, {v.vx + dx, v.vy + dy, v.w + dw}, sums);
        return sums.gradient;
      };
      LoadSums sums;
      kernels.hessian(loads.data(), box, v, sums);
      const Hessian& h = sums.hessian;
      constexpr double e = 1e-5;
      const Wrench x1 = gradient(e, 0, 0), x0 = gradient(-e, 0, 0), y1 = gradient(0, e, 0), y0 = gradient(0, -e, 0),
                   w1 = gradient(0, 0, e), w0 = gradient(0, 0, -e);
      EXPECT_NEAR(h.xx, (x1.fx - x0.fx) / (2 * e), 1e-9);
      EXPECT_NEAR(h.xy, (x1.fy - x0.fy) / (2 * e), 1e-9);
      EXPECT_NEAR(h.xw, (x1.m - x0.m) / (2 * e), 1e-9);
      EXPECT_NEAR(h.yy, (y1.fy - y0.fy) / (2 * e), 1e-9);
      EXPECT_NEAR(h.yw, (y1.m - y0.m) / (2 * e), 1e-9);
      EXPECT_NEAR(h.ww, (w1.m - w0.m) / (2 * e), 1e-9);
      if (lanes == Lanes::two) first = h;
      EXPECT_NEAR(h.ww, first.ww, 64 * unit);
      EXPECT_NEAR(h.xy, first.xy, 64 * unit);
    }
  }
}

void expect_close(const DistanceSums& a, const DistanceSums& b, double size) {
  EXPECT_NEAR(a.S, b.S, size);
  EXPECT_NEAR(a.gx, b.gx, size);
  EXPECT_NEAR(a.gy, b.gy, size);
  EXPECT_NEAR(a.xx, b.xx, size);
  EXPECT_NEAR(a.xy, b.xy, size);
  EXPECT_NEAR(a.yy, b.yy, size);
}

// More columns and rows than are held at once, edges not a multiple of the chunk.
TEST(CornerAndEdgeSums, AreTheSameForAllVectors) {
  std::mt19937_64 engine(5);
  constexpr std::size_t columns = 136, rows = 70;
  std::vector<double> x, y, c;
  for (std::size_t i = 0; i < columns; ++i) x.push_back(0.01 * static_cast<double>(i));
  for (std::size_t j = 0; j < rows; ++j) y.push_back(0.02 * static_cast<double>(j));
  for (std::size_t k = 0; k < columns * rows; ++k) c.push_back(uniform(engine, -1, 1));
  const std::vector<CornerSpan> spans(rows, {0, columns});
  const CornerBlock block{x.data(), y.data(), c.data(), spans.data(), columns, rows};
  EdgeJumps edges;
  for (int i = 0; i < 500; ++i) {
    edges.add(uniform(engine, 0, 1), uniform(engine, 0, 1), uniform(engine, 0, 1), uniform(engine, 0, 1),
              uniform(engine, -1, 1), uniform(engine, -1, 1), uniform(engine, -1, 1));
  }
  edges.pad();
  for (const Pole& pole : {Pole{0.35, 0.4}, Pole{0.05, 0.04}, Pole{-2, 0.3}}) {
    const auto sums = [&](Lanes lanes) {
      std::array<DistanceSums, 2> s;
      corner_kernel(Derivatives::second, lanes)(block, pole.x, pole.y, s[0]);
      edge_kernel(Derivatives::second, lanes)(edges, 0, edges.size(), pole.x, pole.y, s[1]);
      return s;
    };
    const auto first = sums(Lanes::two);
    for (const Lanes lanes : all_lanes()) {
      const auto same = sums(lanes);
      expect_close(same[0], first[0], 1e-9);
      expect_close(same[1], first[1], 1e-11);
      DistanceSums gradient;
      corner_kernel(Derivatives::first, lanes)(block, pole.x, pole.y, gradient);
      EXPECT_EQ(gradient.gx, same[0].gx);
      EXPECT_EQ(gradient.xx, 0);
    }
  }
}

}  // namespace
}  // namespace patchgrip::friction::kernels
