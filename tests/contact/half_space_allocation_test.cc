// The iterations of the solver allocate nothing: every operator new of this program is counted.
#include <patchgrip/contact/half_space/solver.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/contact/half_space_shapes.h>

namespace {

std::atomic<long> allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* p = std::aligned_alloc(alignment, rounded > 0 ? rounded : alignment)) return p;
  throw std::bad_alloc();
}

}  // namespace

// Not inlined: GCC would take free() for a mismatch of new.
[[gnu::noinline]] void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }

namespace patchgrip::contact {
namespace {

TEST(HalfSpaceAllocation, IsCounted) {
  const long before = allocations;
  std::vector<int> kept(100);
  EXPECT_EQ(allocations - before, 1);
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
