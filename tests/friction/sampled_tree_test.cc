// Boxes of boxes against the exact sums of all pieces.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/friction/sampled/sampled_pressure.h>
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

// Squares around one another, each of half the side: every cut through the middle of a box takes a few triangles off
// it, so that a tree of such cuts alone would have too many levels.
Triangulation nested_squares(std::size_t count) {
  Triangulation mesh;
  for (std::size_t k = 0; k < count; ++k) {
    const double a = std::scalbn(1.0, -static_cast<int>(k));
    for (const Point& p : {Point{-a, -a}, Point{a, -a}, Point{a, a}, Point{-a, a}}) mesh.points.push_back(p);
  }
  for (std::size_t k = 0; k + 1 < count; ++k) {
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4, p = 4 * k + i, q = 4 * k + j;
      mesh.triangles.push_back({p, q, p + 4});
      mesh.triangles.push_back({q, p + 4, q + 4});
    }
  }
  return mesh;
}

TEST(TreeOfTriangles, GradedTowardsAPointHasFewLevels) {
  constexpr int squares = 100;  // the centre of pressure is 0 to 34 digits: all of them have an area as seen from there
  const Triangulation mesh = nested_squares(squares);
  const std::vector<double> ones(mesh.triangles.size(), 1);
  const PressureMesh tree = PressureMesh::constant_within(1e-9, mesh, ones);
  const PressureMesh exact = PressureMesh::constant(mesh, ones);
  for (int k = 0; k < squares; ++k) {
    const double a = std::scalbn(0.9, -k);
    const Twist v = twist_about({a, 0.7 * a}, 1);
    const BoundedWrench g = tree.bounded_gradient(v), h = exact.bounded_gradient(v);
    EXPECT_LE(std::hypot(g.value.fx - h.value.fx, g.value.fy - h.value.fy), 1e-9 + h.force_error) << k;
    EXPECT_LE(std::fabs(g.value.m - h.value.m), 4e-9 + h.moment_error) << k;
  }
}

TEST(TreeOfTriangles, GradedBelowTheRoundingOfItsCentreIsRefused) {
  const Triangulation mesh = nested_squares(100);
  std::vector<double> pressures(mesh.triangles.size(), 1);
  pressures[0] = 2;  // moves the centre of pressure away from the small squares
  EXPECT_THROW(PressureMesh::constant(mesh, pressures), std::invalid_argument);
  EXPECT_THROW(PressureMesh::constant_within(1e-9, mesh, pressures), std::invalid_argument);
}

class OnePiece : public kernels::Pieces {
 public:
  void add(std::size_t, double, double, kernels::Derivatives, kernels::DistanceSums&) const noexcept override {}
  void add_excess(std::size_t, const Twist&, kernels::StribeckSums&) const noexcept override {}
  kernels::Roughness roughness(std::size_t) const override { return {}; }
  void add_loads(std::size_t, const kernels::Box&, const kernels::LoadRule&, double* loads) const override {
    loads[0] += 1;
  }
};

TEST(Tree, WithMoreLevelsThanItsStackHoldsIsRefused) {
  const auto chain = [](std::uint32_t levels) {
    std::vector<kernels::PressureNode> nodes;
    for (std::uint32_t k = 0; k <= levels; ++k) nodes.push_back({{0, 0, 1, 1}, k + 1, k < levels ? 1U : 0U});
    nodes.back().leaf = 0;
    return kernels::SampledPressure({}, std::move(nodes), std::make_unique<OnePiece>(), 1e-3);
  };
  EXPECT_NO_THROW(chain(kernels::PressureNode::most_levels));
  EXPECT_THROW(chain(kernels::PressureNode::most_levels + 1), std::length_error);
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
