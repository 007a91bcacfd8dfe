// Boxes of boxes against the exact sums of all pieces.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/friction/hessian.h>
#include <patchgrip/tests/friction/sampled_cases.h>

namespace patchgrip::friction {
namespace {

using testing::cases;

struct Tree {
  std::string name;
  PressureCells cells;
};

double ring(double x, double y) {
  const double r = std::hypot(x, y);
  return r > 0.6 && r < 0.95 ? 1 : 0;
}

double islands(double x, double y) {
  return std::max(0.0, 0.1 - std::hypot(x + 0.8, y + 0.7)) + std::max(0.0, 0.2 - std::hypot(x - 0.7, y - 0.6));
}

std::vector<Tree> trees() {
  std::mt19937_64 engine(1);
  const auto noise = [&](double, double) { return engine() % 3 == 0 ? uniform(engine, 0, 1) : 0; };
  const auto dome = [](double x, double y) { return std::sqrt(std::max(0.0, 1 - x * x - y * y)); };
  return {{"Dome", sampled_cells(64, 64, 1.0 / 32, 1.0 / 32, -1, -1, dome)},
          {"Noise", sampled_cells(61, 83, 1.0 / 32, 1.0 / 32, 3, -2, noise)},
          {"LongCells", sampled_cells(20, 150, 0.1, 0.01, -1, -0.75, noise)},
          {"WideCells", sampled_cells(200, 9, 0.001, 0.1, -0.1, -0.45, noise)},
          {"Ring", sampled_cells(100, 100, 0.02, 0.02, -1, -1, ring)},
          {"Islands", sampled_cells(120, 100, 2.0 / 120, 0.02, -1, -1, islands)}};
}

class TreeOf : public ::testing::TestWithParam<Tree> {};

INSTANTIATE_TEST_SUITE_P(, TreeOf, ::testing::ValuesIn(trees()),
                         [](const auto& instance) { return instance.param.name; });

double radius_of(const PressureCells& cells, const PressureMoments& s) {
  const double right = cells.x0 + static_cast<double>(cells.nx) * cells.dx;
  const double top = cells.y0 + static_cast<double>(cells.ny) * cells.dy;
  return std::hypot(std::max(s.x - cells.x0, right - s.x), std::max(s.y - cells.y0, top - s.y));
}

template <class P>
void expect_within(const P& tree, const P& exact, double tolerance, double radius, int count) {
  EXPECT_EQ(tree.tolerance(), tolerance);
  EXPECT_EQ(tree.moments().x, exact.moments().x);
  std::mt19937_64 engine(2);
  for (int i = 0; i < count; ++i) {
    const Twist v = random_motion(exact, engine);
    const BoundedWrench g = tree.bounded_gradient(v), h = exact.bounded_gradient(v);
    const double force = std::hypot(g.value.fx - h.value.fx, g.value.fy - h.value.fy);
    const double moment = std::fabs(g.value.m - h.value.m);
    const PressureMoments s = exact.moments();
    const double arm = 2 * radius + std::hypot(s.x, s.y);
    EXPECT_LE(force, tolerance + h.force_error) << v.vx << ' ' << v.vy << ' ' << v.w;
    EXPECT_LE(moment, arm * tolerance + h.moment_error) << v.vx << ' ' << v.vy << ' ' << v.w;
    EXPECT_LE(force, g.force_error + h.force_error);
    EXPECT_LE(moment, g.moment_error + h.moment_error);
    EXPECT_LE(g.force_error, 2 * tolerance + h.force_error);
    const double size = scaled_size(exact.hessian(v), v, radius);
    EXPECT_LE(scaled_difference(tree.hessian(v), exact.hessian(v), v, radius), (100 * tolerance + 1e-11) * size)
        << v.vx << ' ' << v.vy << ' ' << v.w;
  }
}

TEST_P(TreeOf, CellsIsGoodToItsTolerance) {
  const PressureCells& cells = GetParam().cells;
  const PressureGrid exact = PressureGrid::exact(cells);
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12}) {
    expect_within(PressureGrid::within(tolerance, cells), exact, tolerance, radius_of(cells, exact.moments()),
                  cases(60));
  }
}

TEST(TreeOfTriangles, IsGoodToItsTolerance) {
  std::mt19937_64 engine(3);
  const Triangulation mesh = shaken_mesh(40, 30, 0.6, 0.3, engine);
  const auto rough = nodal(mesh, [&](double, double) { return uniform(engine, 0, 1); });
  const auto smooth = nodal(mesh, [](double x, double y) { return x * (1 - x) + y * y + 1; });
  const std::vector<double> steps(rough.begin(), rough.begin() + 1000);
  const Triangulation part{mesh.points, {mesh.triangles.begin(), mesh.triangles.begin() + 1000}};
  for (const double tolerance : {1e-4, 1e-9, 1e-12}) {
    for (const auto& p : {rough, smooth}) {
      expect_within(PressureMesh::linear_within(tolerance, mesh, p), PressureMesh::linear(mesh, p), tolerance, 1,
                    cases(60));
    }
    expect_within(PressureMesh::constant_within(tolerance, part, steps), PressureMesh::constant(part, steps), tolerance,
                  1, cases(60));
  }
}

TEST(Tree, DissipationIsThePowerOfTheGradientAndHomogeneous) {
  const PressureCells cells = trees()[0].cells;
  const PressureGrid tree = PressureGrid::within(1e-9, cells);
  std::mt19937_64 engine(4);
  for (int i = 0; i < cases(300); ++i) {
    const Twist v = random_motion(tree, engine);
    const double D = tree.dissipation(v);
    EXPECT_NEAR(power(tree.gradient(v), v), D, 1e-14 * D + 1e-15 * std::hypot(v.vx, v.vy));
    EXPECT_EQ(tree.dissipation({4 * v.vx, 4 * v.vy, 4 * v.w}), 4 * D);
  }
}

}  // namespace
}  // namespace patchgrip::friction
