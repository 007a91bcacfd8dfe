// The iterations of the solver allocate nothing: every operator new of this program is counted.
#include <patchgrip/contact/half_space/solver.h>

#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/contact/half_space_shapes.h>
#include <patchgrip/tests/support/count_allocations.h>

namespace patchgrip::contact {
namespace {

using testing::allocations;
using testing::allocations_of;

TEST(HalfSpaceAllocation, IsCounted) {
  std::vector<int> kept;
  EXPECT_EQ(allocations_of([&] { kept.resize(100); }), 1);
}

TEST(HalfSpaceAllocation, DoesNotHappenInAnIteration) {
  const Grid grid = Grid::square(128, 2.5);
  const auto gap = sample(grid, paraboloid());
  for (const int threads : {1, 2}) {
    for (const Surface surface : {Surface::free, Surface::periodic}) {
      for (const Prescribed prescribed : {Prescribed::approach, Prescribed::load}) {
        if (surface == Surface::periodic && prescribed == Prescribed::approach) continue;
        Workers workers(threads);
        ContactSolver solver(grid, surface, gap, {workers});
        std::vector<double> pressure(grid.size(), 1.);
        long first = 0, last = 0;
        const SolverObserver observer = [&](const SolverProgress& progress) {
          (progress.iteration == 1 ? first : last) = allocations;
        };
        const double value = prescribed == Prescribed::load ? 4. / 3. / grid.cell_area() : 1.;
        const SolverStatus status = solver.solve(prescribed, value, 1e-6, 200, observer, pressure);
        EXPECT_GT(status.iterations, 5);
        EXPECT_EQ(last, first) << threads;
      }
    }
  }
}

}  // namespace
}  // namespace patchgrip::contact
