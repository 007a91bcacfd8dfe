#include <patchgrip/contact/half_space/solver.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <patchgrip/tests/contact/half_space_shapes.h>

namespace patchgrip::contact {
namespace {

struct Solved {
  SolverStatus status;
  std::vector<double> pressure;
};

Solved solve(const Grid& grid, const std::vector<double>& gap, Prescribed prescribed, double value,
             std::vector<double> start, double tolerance = 1e-10) {
  Workers workers(1);
  ContactSolver solver(grid, Surface::free, gap, {workers});
  const SolverStatus status = solver.solve(prescribed, value, tolerance, 500, {}, start);
  return {status, std::move(start)};
}

TEST(ContactSolver, ForgetsItsStart) {
  const Grid grid = Grid::square(32, 2.5);
  const auto gap = sample(grid, paraboloid());
  const auto one = solve(grid, gap, Prescribed::approach, 1, std::vector<double>(grid.size(), 0.));
  for (const double start : {1e-6, 1., 1e3}) {
    const auto other = solve(grid, gap, Prescribed::approach, 1, std::vector<double>(grid.size(), start));
    for (std::size_t k = 0; k < gap.size(); ++k) EXPECT_NEAR(other.pressure[k], one.pressure[k], 1e-8);
  }
}

TEST(ContactSolver, StopsAtOnceAtTheSolution) {
  const Grid grid = Grid::square(32, 2.5);
  const auto gap = sample(grid, paraboloid());
  for (const Prescribed prescribed : {Prescribed::approach, Prescribed::load}) {
    const double value = prescribed == Prescribed::approach ? 1 : 4. / 3. / grid.cell_area();
    const auto first = solve(grid, gap, prescribed, value, std::vector<double>(grid.size(), 1.));
    const auto again = solve(grid, gap, prescribed, value, first.pressure, 2e-10);
    EXPECT_EQ(again.status.iterations, 0);
    EXPECT_NEAR(again.status.approach, 1, 1e-3);
  }
}

// The reported residual is that of the pressure, not of a recursion that has drifted.
TEST(ContactSolver, ResidualIsThatOfThePressure) {
  const Grid grid = Grid::square(64, 2.5);
  const auto gap = sample(grid, paraboloid());
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    auto solved = solve(grid, gap, Prescribed::approach, 1, std::vector<double>(grid.size(), 1.), tolerance);
    Workers workers(1);
    ContactSolver solver(grid, Surface::free, gap, {workers});
    EXPECT_NEAR(solver.residual_of(Prescribed::approach, 1, solved.pressure), solved.status.residual, 0.01 * tolerance);
    EXPECT_LE(solved.status.residual, tolerance);
  }
}

// Algebraic error against the tolerance, as the header states.
TEST(ContactSolver, ForceIsGoodToTwoResiduals) {
  const Grid grid = Grid::square(64, 2.5);
  for (const double shift : {0., 0.01, 0.02}) {
    const auto gap = sample(grid, paraboloid(shift, 2 * shift));
    const auto press = [&](double tolerance) {
      return solve(grid, gap, Prescribed::approach, 1, std::vector<double>(grid.size(), 1.), tolerance);
    };
    const auto force = [](const Solved& solved) {
      return std::accumulate(solved.pressure.begin(), solved.pressure.end(), 0.);
    };
    const double exact = force(press(1e-12));
    for (const double tolerance : {1e-4, 1e-5, 1e-6, 1e-8}) {
      const Solved solved = press(tolerance);
      EXPECT_LE(std::abs(force(solved) / exact - 1), 2 * solved.status.residual) << tolerance << ' ' << shift;
    }
  }
}

// One cell carries all: u = K_00 p.
TEST(ContactSolver, ContactOfOneCell) {
  const Grid grid = Grid::square(16, 16);
  const auto gap = sample(grid, [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.1 ? 0. : 5.; });
  for (const Prescribed prescribed : {Prescribed::approach, Prescribed::load}) {
    const auto solved = solve(grid, gap, prescribed, 1, std::vector<double>(grid.size(), 1.));
    const double self = 4 * std::asinh(1) / std::numbers::pi;
    EXPECT_NEAR(solved.pressure[grid.index(8, 8)], prescribed == Prescribed::load ? 1 : 1 / self, 1e-9);
    EXPECT_NEAR(solved.status.approach, prescribed == Prescribed::load ? self : 1, 1e-9);
  }
}

}  // namespace
}  // namespace patchgrip::contact
