// A question to a grasp allocates nothing: every operator new of this program is counted.
#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/tests/grasp/random_grasps.h>

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

namespace patchgrip::grasp {
namespace {

TEST(Allocation, IsCounted) {
  const long before = allocations;
  std::vector<int> kept(100);
  EXPECT_EQ(allocations - before, 1);
}

TEST(Allocation, DoesNotHappenInAQuestion) {
  using Class = GraspDraws::Class;
  GraspDraws draws(1);
  for (const Class kind : {Class::inside, Class::near_inside, Class::outside, Class::deficient, Class::duplicates}) {
    for (int i = 0; i < 10; ++i) {
      const DrawnGrasp g = draws.draw(kind);
      const std::vector<double> limits(g.contacts.size(), 1.0);
      Grasp grasp(g.made());
      const long before = allocations;
      grasp.least_grip(g.load);
      grasp.next_least_grip(1.001 * g.load);
      grasp.least_total_grip(g.load);
      grasp.holds_within(g.load, limits);
      grasp.load_factor(Vector6::Zero(), Vector6::Ones(), limits);
      grasp.force_closure();
      EXPECT_EQ(allocations - before, 0);
    }
  }
}

}  // namespace
}  // namespace patchgrip::grasp
