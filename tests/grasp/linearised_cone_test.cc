#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include <patchgrip/grasp/linearised_cone.h>
#include <patchgrip/tests/grasp/lmi_draws.h>

namespace patchgrip::grasp {
namespace {

using std::numbers::pi;

std::vector<Contact> with_mu(const LmiDraw& g, int edges, double power) {
  std::vector<Contact> all;
  for (DrawnContact c : g.contacts) {
    c.mu *= std::pow(cut_factor(c.cone(), edges), power);
    all.push_back(c.contact());
  }
  return all;
}

// s(mu) <= s_inner <= s(c mu), s(mu / c) <= s_outer <= s(mu), of every model.
TEST(LinearisedCone, GripIsBoundedByThatOfTheExactCones) {
  GraspDraws draws(1);
  for (int i = 0; i < testing::cases(60); ++i) {
    const LmiDraw g = draw_lmi(draws, 4 + i % 7, 0.9, true);
    const double exact = Grasp(g.made()).least_grip(g.load).value;
    for (const int k : {4, 8, 16}) {
      const GripAnswer less = Grasp(with_mu(g, k, 1)).least_grip(g.load);
      const GripAnswer more = Grasp(with_mu(g, k, -1)).least_grip(g.load);
      const LinearisedGrip inner = linearised_least_grip(g.made(), g.load, k, CutSide::inner);
      const LinearisedGrip outer = linearised_least_grip(g.made(), g.load, k, CutSide::outer);
      EXPECT_GE(inner.upper, exact * (1 - 1e-12));
      if (less.verdict == Verdict::holds) {
        EXPECT_LE(inner.lower, less.upper);
      }
      EXPECT_LE(outer.lower, exact * (1 + 1e-12));
      EXPECT_GE(outer.upper, more.lower);
      for (const LinearisedGrip& a : {inner, outer}) {
        if (std::isfinite(a.upper)) {
          EXPECT_LE(a.upper - a.lower, 1e-5 * a.upper);
        }
      }
      EXPECT_TRUE(std::isfinite(outer.upper));
    }
  }
}

TEST(LinearisedCone, ForcesBalanceAndLieInTheExactCone) {
  GraspDraws draws(2);
  for (int i = 0; i < testing::cases(40); ++i) {
    const LmiDraw g = draw_lmi(draws, 4 + i % 7, 0.7, true);
    const LinearisedGrip a = linearised_least_grip(g.made(), g.load, 8, CutSide::inner);
    if (!std::isfinite(a.upper)) continue;
    Vector6 sum = g.load;
    for (std::size_t c = 0; c < a.forces.size(); ++c) {
      const DrawnContact& k = g.contacts[c];
      const auto& [F, t] = a.forces[c];
      sum += k.contact().wrench(F, t);
      EXPECT_LE(F, a.upper);
      const Vector3 s(t[0], t[1], k.e > 0 ? t[2] / k.e : 0);
      const double gauge = k.model == DrawnContact::Model::linear     ? std::hypot(s[0], s[1]) + std::fabs(s[2])
                           : k.model == DrawnContact::Model::elliptic ? s.norm()
                                                                      : std::hypot(s[0], s[1]);
      EXPECT_LE(gauge, k.mu * F * (1 + 1e-14));
    }
    EXPECT_LE(sum.norm(), 1e-11 * static_cast<double>(g.contacts.size()) * a.upper);
  }
}

// Two fingers pinch, the load between two edges and along one: 1 / cos(pi/k) and 1 times the grip that is needed.
TEST(LinearisedCone, APinchBetweenTwoEdgesNeedsTheMost) {
  const FrictionCone cone = FrictionCone::point(0.4);
  const std::vector<Contact> pinch{Contact({Vector3(0, 0, .01), Vector3(0, 0, 1), Vector3(1, 0, 0)}, cone),
                                   Contact({Vector3(0, 0, -.01), Vector3(0, 0, -1), Vector3(1, 0, 0)}, cone)};
  for (const int k : {4, 8, 32, 128}) {
    for (const double share : {0., 0.5}) {
      const double phi = share * 2 * pi / k;
      const Vector6 load = spatial(Vector3(std::cos(phi), std::sin(phi), 0), Vector3::Zero());
      const double inner = share > 0 ? 1 / std::cos(pi / k) : 1;
      const LinearisedGrip a = linearised_least_grip(pinch, load, k, CutSide::inner);
      EXPECT_NEAR(a.lower, inner / 0.8, 1e-7);
      EXPECT_NEAR(a.upper, inner / 0.8, 1e-7);
      const LinearisedGrip b = linearised_least_grip(pinch, load, k, CutSide::outer);
      EXPECT_NEAR(b.upper, inner * std::cos(pi / k) / 0.8, 1e-7);
    }
  }
}

TEST(LinearisedCone, ErrorFallsWithTheSquareOfTheEdges) {
  GraspDraws draws(3);
  double sums[] = {0, 0, 0};
  for (int i = 0; i < testing::cases(30); ++i) {
    const LmiDraw g = draw_lmi(draws, 5 + i % 4, 0.6, false);
    const double exact = Grasp(g.made()).least_grip(g.load).value;
    int k = 8;
    for (double& sum : sums) {
      const LinearisedGrip inner = linearised_least_grip(g.made(), g.load, k, CutSide::inner);
      const LinearisedGrip outer = linearised_least_grip(g.made(), g.load, k, CutSide::outer);
      sum += (inner.upper - outer.lower) / exact;
      k *= 2;
    }
  }
  EXPECT_LT(sums[2], sums[0]);
  if (!testing::all_cases()) return;
  EXPECT_NEAR(std::log2(sums[0] / sums[1]), 2, 0.2);
  EXPECT_NEAR(std::log2(sums[1] / sums[2]), 2, 0.2);
}

TEST(LinearisedCone, WhatCannotBeHeldIsProvedByATwist) {
  const FrictionCone cone = FrictionCone::point(0.4);
  const std::vector<Contact> plane{Contact({Vector3(.01, 0, 0), Vector3(0, 0, -1), {}}, cone),
                                   Contact({Vector3(-.01, 0, 0), Vector3(0, 0, -1), {}}, cone),
                                   Contact({Vector3(0, .01, 0), Vector3(0, 0, -1), {}}, cone)};
  const LinearisedGrip a = linearised_least_grip(plane, spatial(Vector3(0, 0, 1), Vector3::Zero()), 8, CutSide::outer);
  EXPECT_GT(a.lower, 1e8);
  EXPECT_EQ(a.upper, std::numeric_limits<double>::infinity());
  const LinearisedGrip none = linearised_least_grip(plane, Vector6::Zero(), 8, CutSide::inner);
  EXPECT_EQ(none.upper, 0);
}

TEST(LinearisedCone, BadInputIsRefused) {
  const FrictionCone point = FrictionCone::point(0.4);
  const FrictionCone patch = FrictionCone::patch(0.4, friction::HertzDisc::of_radius(0.01));
  for (const int k : {0, 3, 6, 1028}) EXPECT_THROW(cone_edges(point, k, CutSide::inner), std::invalid_argument);
  EXPECT_THROW(cone_edges(patch, 8, CutSide::inner), std::invalid_argument);
  EXPECT_THROW(linearised_least_grip({}, Vector6::Ones(), 8, CutSide::inner), std::invalid_argument);
}

}  // namespace
}  // namespace patchgrip::grasp
