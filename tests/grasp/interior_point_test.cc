// The interior point alone: contacts in any number, four side by side, by the code of every processor.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <patchgrip/grasp/interior_point.h>
#include <patchgrip/tests/grasp/random_grasps.h>

namespace patchgrip::grasp {
namespace {

constexpr double tolerance = 1e-6;

struct Solved {
  InteriorPoint::Status status;
  double value;
};

Solved solve(const InteriorPointKernels& kernels, const std::vector<Contact>& contacts, Objective objective,
             const Vector6& load) {
  const ScaledGrasp grasp(contacts);
  const Vector6 w = grasp.scaled_load(load);
  const std::vector<double> limits(contacts.size(), 1);
  const bool factored = objective == Objective::load_factor;
  const Vector6 step = factored ? Vector6(w / w.norm()) : Vector6::Zero();
  InteriorPoint point(grasp, kernels);
  point.start({&grasp, objective, factored ? Vector6::Zero() : Vector6(w / w.norm()), step, limits});
  const InteriorPoint::Status status = point.run(tolerance, tolerance, 100);
  return {status, factored ? point.value() / w.norm() : point.value() * w.norm()};
}

// What they carry is well inside their cones: all but those of patches, whose ellipsoids move as they are solved.
DrawnGrasp drawn(GraspDraws& draws, int contacts) {
  DrawnGrasp g;
  for (int i = 0; i < contacts; ++i) {
    DrawnContact contact = draws.contact();
    while (contact.model == DrawnContact::Model::hertz || contact.model == DrawnContact::Model::rectangle)
      contact = draws.contact();
    g.contacts.push_back(contact);
    const Contact c = g.contacts.back().contact();
    const double F = draws.uniform(0.1, 1);
    const Vector3 t(draws.uniform(-0.2, 0.2), draws.uniform(-0.2, 0.2), 0.2 * c.cone().moment_length());
    g.load -= c.wrench(F, c.cone().mu() * F * t);
  }
  return g;
}

// Three to thirteen contacts, the soft linear ones of two parts under one cap.
TEST(InteriorPoint, OfEveryProcessorIsTheSame) {
  if (&interior_point_kernels() == &baseline_interior_point_kernels()) GTEST_SKIP() << "one code alone";
  GraspDraws draws(71);
  int optimal = 0, apart = 0;
  for (int i = 0; i < 110; ++i) {
    const DrawnGrasp g = drawn(draws, 3 + i % 11);
    for (const Objective objective : {Objective::max_force, Objective::load_factor}) {
      const Solved here = solve(interior_point_kernels(), g.made(), objective, g.load);
      const Solved anywhere = solve(baseline_interior_point_kernels(), g.made(), objective, g.load);
      apart += here.status != anywhere.status ? 1 : 0;
      if (here.status != InteriorPoint::Status::optimal || here.status != anywhere.status) continue;
      ++optimal;
      EXPECT_NEAR(here.value, anywhere.value, 4 * tolerance * std::fabs(here.value)) << i;
    }
  }
  EXPECT_GE(optimal, 180);
  EXPECT_LE(apart, 10);
}

// The least grip for a load is the inverse of the largest multiple of it under a unit limit.
TEST(InteriorPoint, GripAndLoadFactorAreInverse) {
  GraspDraws draws(72);
  int optimal = 0;
  for (int i = 0; i < 110; ++i) {
    const DrawnGrasp g = drawn(draws, 3 + i % 11);
    const Solved grip = solve(interior_point_kernels(), g.made(), Objective::max_force, g.load);
    const Solved factor = solve(interior_point_kernels(), g.made(), Objective::load_factor, g.load);
    if (grip.status != InteriorPoint::Status::optimal || factor.status != InteriorPoint::Status::optimal) continue;
    ++optimal;
    EXPECT_NEAR(grip.value * factor.value, 1, 4 * tolerance) << i;
  }
  EXPECT_GE(optimal, 90);
}

}  // namespace
}  // namespace patchgrip::grasp
