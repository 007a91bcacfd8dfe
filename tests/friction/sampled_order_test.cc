// How fast sampled pressures converge to what they are samples of.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/hertz_disc.h>
#include <patchgrip/friction/power_disc.h>
#include <patchgrip/friction/sampled/triangulate.h>
#include <patchgrip/tests/friction/sampled_cases.h>
#include <patchgrip/tests/friction/shapes.h>

namespace patchgrip::friction {
namespace {

// Largest error of force and moment over poles inside, at the rim and outside of a disc of radius 1.
template <class P, class Q>
double error_of_patch(const P& patch, const Q& exact) {
  double worst = 0;
  for (const double r : {0.0, 0.21, 0.5, 0.83, 1.02, 1.7}) {
    for (const double angle : {0.1, 1.3, 2.9, -1.7}) {
      const Twist v = twist_about({r * std::cos(angle), r * std::sin(angle)}, 1);
      const Wrench g = patch.gradient(v), h = exact.gradient(v);
      worst = std::max({worst, std::hypot(g.fx - h.fx, g.fy - h.fy), std::fabs(g.m - h.m)});
    }
  }
  return worst;
}

// Slope of log error over log h by least squares.
double fitted_order(const std::vector<double>& h, const std::vector<double>& error) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double s = std::log(h[i]), t = std::log(error[i]);
    n += 1, x += s, y += t, xx += s * s, xy += s * t;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

template <class Pressure, class Q>
double order_of_cells(const Pressure& pressure, const Q& exact) {
  std::vector<double> steps, errors;
  for (const std::size_t n : {17U, 24U, 35U, 48U, 71U, 96U, 141U, 200U}) {
    const double h = 2 / static_cast<double>(n);
    steps.push_back(h);
    errors.push_back(error_of_patch(PressureGrid::within(1e-10, sampled_cells(n, n, h, h, -1, -1, pressure)), exact));
  }
  return fitted_order(steps, errors);
}

template <class Pressure, class Q>
double order_of_triangles(const Pressure& pressure, const Q& exact) {
  std::vector<double> steps, errors;
  for (const double h : {0.3, 0.2, 0.14, 0.1, 0.07, 0.05}) {
    const int sides = static_cast<int>(std::ceil(2 * std::numbers::pi / h));
    const Triangulation mesh = triangulate(regular(sides, 1), {}, h);
    steps.push_back(h);
    errors.push_back(error_of_patch(PressureMesh::linear_within(1e-10, mesh, sample(mesh, pressure)), exact));
  }
  return fitted_order(steps, errors);
}

double hertz(double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); }
double paraboloid(double x, double y) { return std::max(0.0, 1 - x * x - y * y); }

TEST(SampledOrder, ConstantCellsOfASmoothPressureConvergeWithOrderTwo) {
  EXPECT_NEAR(order_of_cells(paraboloid, PowerDisc::of_radius(1, 1.5)), 2, 0.2);
}

// Cells at the rim err by h^(5/2) each; that there are 1/h of them, with either sign, is a little better than h^(3/2).
TEST(SampledOrder, ConstantCellsOfAHertzPressureConvergeWithOrderThreeHalvesOrBetter) {
  const double order = order_of_cells(hertz, HertzDisc::of_radius(1));
  EXPECT_GE(order, 1.4);
  EXPECT_LE(order, 2);
}

TEST(SampledOrder, LinearTrianglesOfASmoothPressureConvergeWithOrderTwo) {
  EXPECT_NEAR(order_of_triangles(paraboloid, PowerDisc::of_radius(1, 1.5)), 2, 0.2);
}

// Along the rim a linear pressure misses the root's share h^(3/2).
TEST(SampledOrder, LinearTrianglesOfAHertzPressureConvergeWithOrderThreeHalves) {
  EXPECT_NEAR(order_of_triangles(hertz, HertzDisc::of_radius(1)), 1.5, 0.2);
}

}  // namespace
}  // namespace patchgrip::friction
